#include "segment_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "fourwis_navigation/vehicle/mode_limits.h"

namespace fourwis
{
namespace
{

using Problem = ocp::Problem<5, 3>;
using Bounds = ocp::Bounds<5, 3>;
using SegmentHessian = ocp::Matrix<8, 8>;

/// Greatest speed at a knot where the robot has to stop. It is not 0 because the solver needs room between the bounds
/// [m/s].
constexpr double kStandstill = 1e-3;

bool is_cusp(const Segment& segment, std::size_t knot)
{
  return knot > 0 && knot < segment.intervals() &&
         std::signbit(segment.length[knot - 1]) != std::signbit(segment.length[knot]);
}

double length_of(const Segment& segment)
{
  return std::accumulate(segment.length.begin(), segment.length.end(), 0.0,
                         [](double sum, double length) { return sum + std::abs(length); });
}

bool is_at_rest(const Segment& segment, std::size_t knot)
{
  return knot == 0 || knot == segment.intervals() || is_cusp(segment, knot);
}

void add_symmetric(SegmentHessian& hessian, int i, int j, double value)
{
  hessian(i, j) += value;
  hessian(j, i) += value;
}

template <class WheelSpeeds>
void add_rows(const Polytope& region, const Point2& centre, std::size_t knot, double weight,
              SegmentProblem<WheelSpeeds>& problem)
{
  for (const HalfPlane& plane : region)
  {
    problem.model.disc_rows.push_back({plane, centre});
    problem.numbers.add_row(knot, {plane.c, weight});
  }
}

/// The wheels' rows and the way's of each interval, and those of the inner knots: each is bound by the regions of both
/// its intervals.
template <class WheelSpeeds>
void set_rows(const SegmentTask& task, double weight, SegmentProblem<WheelSpeeds>& problem)
{
  SegmentModel<WheelSpeeds>& model = problem.model;
  const std::size_t n = task.segment.intervals();
  model.disc_rows.clear();
  model.first_row.assign(n + 1, 0);
  for (std::size_t k = 0; k < n; ++k)
  {
    for (int i = 0; i < WheelRateRows::kRows; ++i) problem.numbers.add_row(k, {0.0});
    problem.numbers.add_row(k, {0.0, weight});
    for (int i = 0; i < WheelSpeeds::kRows; ++i) problem.numbers.add_row(k, {0.0});
    model.first_row[k] = model.disc_rows.size();
    if (k == 0) continue;
    for (std::size_t interval : {k - 1, k})
      for (const DiscRegions& disc : task.corridor) add_rows(disc.regions[interval], disc.centre, k, weight, problem);
  }
}

/// Whether the reference steers so sharply at a knot that the wheels need more time than `longest`.
bool is_sharp(const Segment& segment, std::size_t knot, double steering_rate, double longest)
{
  return knot > 0 && knot < segment.intervals() &&
         std::abs(segment.phi[knot] - segment.phi[knot - 1]) > steering_rate * longest;
}

template <class WheelSpeeds>
void set_bounds(const SegmentTask& task, const MotionLimits& limits, const OptimizeOptions& options, double travel,
                SegmentProblem<WheelSpeeds>& problem)
{
  const Segment& segment = task.segment;
  const std::size_t n = segment.intervals();
  const std::vector<double>& h_ref = problem.model.h_ref;
  // From rest to rest over a short way, the speed on which h_ref is based is not reached.
  const double ramp = limits.speed * limits.speed / limits.acceleration;
  const double room = std::sqrt(std::min(travel, ramp) / limits.acceleration);
  // The time of an interval as long as the longer of the two at a knot, so that curves may be moved a little.
  const auto h_at = [&](std::size_t knot) {
    return std::max(h_ref[knot > 0 ? knot - 1 : 0], h_ref[std::min(knot, n - 1)]);
  };
  const auto longest = [&](std::size_t knot, double factor) { return std::max(factor * h_at(knot), room); };
  const auto takes_time = [&](std::size_t knot) {
    return is_at_rest(segment, knot) ||
           is_sharp(segment, knot, limits.fastest_steering, longest(knot, options.longest_interval));
  };
  for (std::size_t k = 0; k <= n; ++k)
  {
    const double speed = !task.pinned.empty() && task.pinned[k] ? kStandstill : limits.speed;
    const bool slow = takes_time(k) || (k < n && takes_time(k + 1));
    Bounds& bounds = problem.numbers.bounds[k];
    bounds.upper.tail<5>() << speed, limits.angle, limits.acceleration, limits.fastest_steering,
        std::max(longest(k, slow ? options.longest_at_rest : options.longest_interval),
                 longest(std::min(k + 1, n), slow ? options.longest_at_rest : options.longest_interval));
    bounds.lower.tail<5>() = -bounds.upper.tail<5>();
    bounds.lower[7] = options.shortest_interval * h_ref[std::min(k, n - 1)];
  }
}

/// Time from one steering angle of the reference to the next, at the knot between them [s].
double steering_time(const Segment& segment, std::size_t knot, double rate)
{
  if (knot == 0 || knot == segment.intervals()) return 0.0;
  return std::abs(segment.phi[knot] - segment.phi[knot - 1]) / rate;
}

/// Speeds at the knots at which each interval takes h_ref or more, and which the acceleration allows.
std::vector<double> reference_speeds(const Segment& segment, const MotionLimits& limits,
                                     const std::vector<double>& h_ref)
{
  const std::size_t n = segment.intervals();
  std::vector<double> speed(n + 1, 0.0);
  for (std::size_t k = 1; k < n; ++k)
    if (!is_at_rest(segment, k))
      speed[k] = std::min(std::abs(segment.length[k - 1]) / h_ref[k - 1], std::abs(segment.length[k]) / h_ref[k]);
  const auto reachable = [&](double from, double length) {
    return std::sqrt(from * from + 2.0 * limits.acceleration * std::abs(length));
  };
  for (std::size_t k = 1; k <= n; ++k) speed[k] = std::min(speed[k], reachable(speed[k - 1], segment.length[k - 1]));
  for (std::size_t k = n; k-- > 0;) speed[k] = std::min(speed[k], reachable(speed[k + 1], segment.length[k]));
  return speed;
}

}  // namespace

template <class WheelSpeeds>
void SegmentModel<WheelSpeeds>::evaluate(std::size_t k, const State& x, const Control& u, const State& next,
                                         Value& value) const
{
  const double sweep = x[3] * u[1], late = u[2] - h_ref[k];
  value.cost = u[2] + alpha * sweep * sweep * u[2] + interval_weight * late * late;
  value.defect = dynamics.next(x, u) - next;
}

template <class WheelSpeeds>
void SegmentModel<WheelSpeeds>::differentiate(std::size_t k, const State& x, const Control& u, const State& lambda,
                                              Derivatives& d) const
{
  dynamics.differentiate(x, u, lambda, d.jacobian, d.hessian);
  const double v = x[3], omega = u[1], h = u[2];
  enum
  {
    V = 3,
    OMEGA = 6,
    H = 7
  };
  // h + alpha v^2 omega^2 h + w_h (h - h_ref)^2
  d.gradient[V] = 2.0 * alpha * v * omega * omega * h;
  d.gradient[OMEGA] = 2.0 * alpha * v * v * omega * h;
  d.gradient[H] = 1.0 + alpha * v * v * omega * omega + 2.0 * interval_weight * (h - h_ref[k]);
  d.hessian(V, V) += 2.0 * alpha * omega * omega * h;
  d.hessian(OMEGA, OMEGA) += 2.0 * alpha * v * v * h;
  d.hessian(H, H) += 2.0 * interval_weight;
  add_symmetric(d.hessian, V, OMEGA, 4.0 * alpha * v * omega * h);
  add_symmetric(d.hessian, V, H, 2.0 * alpha * v * omega * omega);
  add_symmetric(d.hessian, OMEGA, H, 2.0 * alpha * v * v * omega);
}

/// (s / reach)^2 - 1 <= 0 with the way s = v h + a h^2 / 2. Where the robot takes time to steer, it must not move far
/// between two knots, because regions and chords are valid only near the reference.
template <class WheelSpeeds>
void SegmentModel<WheelSpeeds>::differentiate_way(const RowPoint& q, double y, Gradients& gradients,
                                                  RowHessian& hessian) const
{
  const double v = q[3], a = q[5], h = q[7], scale = 2.0 / (reach * reach);
  const double way = way_of(q);
  RowPoint slope = RowPoint::Zero();
  slope[3] = h;
  slope[5] = 0.5 * h * h;
  slope[7] = v + a * h;
  gradients.col(kWayRow) = scale * way * slope;
  hessian += y * scale * RowHessian(slope * slope.transpose());
  hessian(7, 7) += y * scale * way * a;
  for (const auto& [i, value] : {std::pair(3, 1.0), std::pair(5, h)})
  {
    hessian(i, 7) += y * scale * way * value;
    hessian(7, i) += y * scale * way * value;
  }
}

template <class WheelSpeeds>
void SegmentModel<WheelSpeeds>::rows(std::size_t k, const RowPoint& q, ocp::RowValues values) const
{
  const double c = std::cos(q[2]), s = std::sin(q[2]);
  const DiscRow* row = disc_rows.data() + first_row[k];
  wheel_rates.evaluate(q, values.data());
  values[kWayRow] = way_of(q) * way_of(q) / (reach * reach) - 1.0;
  wheel_speeds.evaluate(q, values.data() + kSpeedRows);
  for (Eigen::Index i = Base::kWideRows; i < values.size(); ++i, ++row)
  {
    const auto& [ox, oy] = row->centre;
    values[i] = row->plane.a * (q[0] + ox * c - oy * s) + row->plane.b * (q[1] + ox * s + oy * c);
  }
}

template <class WheelSpeeds>
void SegmentModel<WheelSpeeds>::differentiate_rows(std::size_t k, const RowPoint& q, ocp::RowMultipliers y,
                                                   Gradients gradients, RowHessian& hessian) const
{
  const double c = std::cos(q[2]), s = std::sin(q[2]);
  const DiscRow* row = disc_rows.data() + first_row[k];
  wheel_rates.differentiate(q, y, gradients, hessian);
  differentiate_way(q, y[kWayRow], gradients, hessian);
  wheel_speeds.differentiate(q, y.data() + kSpeedRows, kSpeedRows, gradients, hessian);
  for (Eigen::Index i = Base::kWideRows; i < y.size(); ++i, ++row)
  {
    const double a = row->plane.a, b = row->plane.b;
    const double ox = row->centre.x * c - row->centre.y * s, oy = row->centre.x * s + row->centre.y * c;
    gradients.col(i).template head<3>() << a, b, b * ox - a * oy;
    hessian(2, 2) -= y[i] * (a * ox + b * oy);
  }
}

template <class WheelSpeeds>
SegmentProblem<WheelSpeeds> segment_problem(const SegmentTask& task, const Robot& robot, const OptimizeOptions& options,
                                            const MotionLimits& limits, double reference_speed)
{
  const Segment& segment = task.segment;
  const std::size_t n = segment.intervals();
  const double length = length_of(segment);
  SegmentProblem<WheelSpeeds> problem{SegmentModel<WheelSpeeds>(robot, segment.mode), {}};
  problem.model.alpha = options.steering_comfort;
  problem.model.interval_weight = options.interval_weight;
  const double step = length / static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k)
  {
    const double speed = std::min({limits.speed, reference_speed, greatest_speed(robot, segment.mode, segment.phi[k])});
    const double steering = steering_time(segment, k, limits.fastest_steering) / 2.0 +
                            steering_time(segment, k + 1, limits.fastest_steering) / 2.0;
    problem.model.h_ref.push_back(std::max(step / speed, steering));
  }
  problem.model.reach = options.longest_interval * step;

  Problem& numbers = problem.numbers;
  numbers.reset(n);
  const Pose &start = segment.knots.front(), &goal = segment.knots.back();
  numbers.initial_state << start.x, start.y, start.theta, 0.0, segment.phi.front();
  numbers.terminal_state << goal.x, goal.y, goal.theta, 0.0, 0.0;
  numbers.terminal_fixed = {true, true, true, true, false};
  set_bounds(task, limits, options, length, problem);
  set_rows(task, options.corridor_weight, problem);
  return problem;
}

template struct SegmentModel<WheelSpeedRows>;
template struct SegmentModel<NoWheelSpeedRows>;
template SegmentProblem<WheelSpeedRows> segment_problem(const SegmentTask&, const Robot&, const OptimizeOptions&,
                                                        const MotionLimits&, double);
template SegmentProblem<NoWheelSpeedRows> segment_problem(const SegmentTask&, const Robot&, const OptimizeOptions&,
                                                          const MotionLimits&, double);

ocp::Trajectory<5, 3> reference_guess(const Segment& segment, const MotionLimits& limits,
                                      const std::vector<double>& h_ref)
{
  const std::size_t n = segment.intervals();
  const std::vector<double> speed = reference_speeds(segment, limits, h_ref);
  ocp::Trajectory<5, 3> guess;
  for (std::size_t k = 0; k <= n; ++k)
  {
    const Pose& pose = segment.knots[k];
    const double v = is_at_rest(segment, k) ? 0.0 : std::copysign(speed[k], segment.length[k]);
    const double phi = k == 0   ? segment.phi[0]
                       : k == n ? segment.phi[n - 1]
                                : (segment.phi[k - 1] + segment.phi[k]) / 2;
    guess.states.emplace_back();
    guess.states.back() << pose.x, pose.y, pose.theta, v, phi;
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    const double h =
        std::max(h_ref[k], 2.0 * std::abs(segment.length[k]) / std::max(kStandstill, speed[k] + speed[k + 1]));
    const auto change = ((guess.states[k + 1] - guess.states[k]) / h).eval();
    guess.controls.emplace_back(std::clamp(change[3], -limits.acceleration, limits.acceleration),
                                std::clamp(change[4], -limits.steering_rate, limits.steering_rate), h);
  }
  return guess;
}

ocp::Trajectory<5, 3> guess_from(const Trajectory& points)
{
  ocp::Trajectory<5, 3> guess;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const TrajectoryPoint& p = points[k];
    guess.states.emplace_back();
    guess.states.back() << p.x, p.y, p.theta, p.v, p.phi;
    if (k + 1 < points.size()) guess.controls.emplace_back(p.a, p.omega, points[k + 1].t - p.t);
  }
  return guess;
}

Trajectory points_of(const ocp::Trajectory<5, 3>& trajectory, Mode mode)
{
  Trajectory points;
  double t = 0.0;
  for (std::size_t k = 0; k < trajectory.states.size(); ++k)
  {
    const auto& x = trajectory.states[k];
    const bool last = k == trajectory.controls.size();
    points.push_back({t, mode, x[0], x[1], x[2], x[3], x[4], last ? 0.0 : trajectory.controls[k][0],
                      last ? 0.0 : trajectory.controls[k][1]});
    if (!last) t += trajectory.controls[k][2];
  }
  return points;
}

}  // namespace fourwis
