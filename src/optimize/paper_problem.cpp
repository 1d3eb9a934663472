#include "paper_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "fourwis_navigation/vehicle/footprint.h"
#include "segment_problem.h"

namespace fourwis
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Least and greatest T, of the initial.
constexpr double kShortest = 0.1, kLongest = 10.0;

double initial_duration(const Segment& segment, const MotionLimits& limits)
{
  double length = 0.0;
  for (double piece : segment.length) length += std::abs(piece);
  return length / limits.speed;
}

Trajectory reference_points(const Segment& segment, const MotionLimits& limits)
{
  const double h = initial_duration(segment, limits) / static_cast<double>(segment.intervals());
  return points_of(reference_guess(segment, limits, std::vector<double>(segment.intervals(), h)), segment.mode);
}

double squared_distance(double x, double y, const Box& box)
{
  const double dx = std::max({box.x_min - x, 0.0, x - box.x_max}), dy = std::max({box.y_min - y, 0.0, y - box.y_max});
  return dx * dx + dy * dy;
}

EulerDynamics::State state(const TrajectoryPoint& p)
{
  EulerDynamics::State x;
  x << p.x, p.y, p.theta, p.v, p.phi;
  return x;
}

}  // namespace

PaperProblem::PaperProblem(const Segment& segment, const BoxCorridor& boxes, const Robot& robot,
                           const PaperOptions& options, const MotionLimits& limits, const Trajectory* previous)
  : mode_(segment.mode)
{
  const std::size_t n = segment.intervals();
  const Trajectory reference = reference_points(segment, limits);
  const Trajectory& guess = previous ? *previous : reference;
  const double initial = initial_duration(segment, limits);
  add_states(guess, reference.front(), reference.back(), limits);
  add_controls(guess, limits);
  duration_ = nlp_.add_variable(kShortest * initial, kLongest * initial, guess.back().t);

  const EulerDynamics dynamics(robot, mode_);
  for (std::size_t k = 0; k < n; ++k)
  {
    std::vector<int> variables(states_[k].begin(), states_[k].end());
    variables.insert(variables.end(), {controls_[k][0], controls_[k][1], duration_});
    variables.insert(variables.end(), states_[k + 1].begin(), states_[k + 1].end());
    for (int i = 0; i < EulerDynamics::kStates; ++i) variables.push_back(nlp_.add_variable(-kInfinity, kInfinity, 0.0));
    nlp_.elements.push_back(std::make_unique<PaperStep>(dynamics, options, n, variables));
  }
  for (std::size_t k = 1; k < n; ++k)
  {
    std::vector<int> variables = {states_[k][0], states_[k][1], states_[k][2], duration_};
    for (int i = 0; i < 4; ++i) variables.push_back(nlp_.add_variable(-kInfinity, kInfinity, 0.0));
    nlp_.elements.push_back(
        std::make_unique<PaperDiscs>(two_discs(robot).offset, options, n, boxes.front[k], boxes.rear[k], variables));
  }
}

void PaperProblem::add_states(const Trajectory& guess, const TrajectoryPoint& start, const TrajectoryPoint& goal,
                              const MotionLimits& limits)
{
  const auto add = [&](const TrajectoryPoint& p) {
    states_.push_back({nlp_.add_variable(-kInfinity, kInfinity, p.x), nlp_.add_variable(-kInfinity, kInfinity, p.y),
                       nlp_.add_variable(-kInfinity, kInfinity, p.theta),
                       nlp_.add_variable(-limits.speed, limits.speed, p.v),
                       nlp_.add_variable(-limits.angle, limits.angle, p.phi)});
  };
  const auto add_fixed = [&](const TrajectoryPoint& p) {
    add(p);
    for (int i : states_.back()) nlp_.fix(i);
  };
  add_fixed(start);
  std::for_each(guess.begin() + 1, guess.end() - 1, add);
  add_fixed(goal);
}

void PaperProblem::add_controls(const Trajectory& guess, const MotionLimits& limits)
{
  for (std::size_t k = 0; k + 1 < guess.size(); ++k)
    controls_.push_back({nlp_.add_variable(-limits.acceleration, limits.acceleration, guess[k].a),
                         nlp_.add_variable(-limits.steering_rate, limits.steering_rate, guess[k].omega)});
}

Trajectory PaperProblem::points(const std::vector<double>& x) const
{
  const auto value = [&](int index) { return x[static_cast<std::size_t>(index)]; };
  Trajectory points;
  for (std::size_t k = 0; k < states_.size(); ++k)
  {
    const State& s = states_[k];
    const bool is_last = k == controls_.size();
    points.push_back({value(duration_) * static_cast<double>(k) / static_cast<double>(controls_.size()), mode_,
                      value(s[0]), value(s[1]), value(s[2]), value(s[3]), value(s[4]),
                      is_last ? 0.0 : value(controls_[k][0]), is_last ? 0.0 : value(controls_[k][1])});
  }
  return points;
}

double paper_infeasibility(const Trajectory& points, const BoxCorridor& boxes, const Robot& robot)
{
  if (points.size() < 2) return 0.0;
  const double h = points.back().t / static_cast<double>(points.size() - 1), offset = two_discs(robot).offset;
  const EulerDynamics dynamics(robot, points.front().mode);
  double j_dyn = 0.0, j_geom = 0.0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    EulerDynamics::Variables z;
    z << state(points[k]), points[k].a, points[k].omega, h;
    j_dyn += (state(points[k + 1]) - dynamics.next(z)).squaredNorm();
  }
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    const TrajectoryPoint& p = points[k];
    const double dx = offset * std::cos(p.theta), dy = offset * std::sin(p.theta);
    j_geom += h * squared_distance(p.x + dx, p.y + dy, boxes.front[k]);
    j_geom += h * squared_distance(p.x - dx, p.y - dy, boxes.rear[k]);
  }
  return j_dyn + j_geom;
}

}  // namespace fourwis
