#include "mpc.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

/// The last knot of the horizon stands for what comes after it [s].
constexpr double kEnd = 0.5;

/// The problem is solved far more accurately than the robot moves. A less accurate solution may still be used, because
/// it keeps the bounds.
ocp::Options solver_options(bool warm)
{
  ocp::Options options;
  options.tolerance = 1e-5;
  options.acceptable_tolerance = 1e-3;
  options.max_iterations = 30;
  options.initial_barrier = warm ? 1e-3 : 1.0;
  return options;
}

template <class Solution>
bool is_usable(const Solution& solution)
{
  return solution.status == ocp::Status::solved || solution.status == ocp::Status::acceptable;
}

}  // namespace

void HorizonModel::evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const
{
  const Interval& interval = intervals[k];
  value.cost = 0.5 * interval.h * (state_weight.dot(x.cwiseAbs2()) + control_weight.dot(u.cwiseAbs2()));
  value.defect =
      interval.jacobian.leftCols<5>().lazyProduct(x) + interval.jacobian.rightCols<2>().lazyProduct(u) - next;
}

void HorizonModel::differentiate(std::size_t k, const State& x, const Control& u, const State&, Derivatives& d) const
{
  const Interval& interval = intervals[k];
  d.jacobian = interval.jacobian;
  d.gradient << interval.h * state_weight.cwiseProduct(x), interval.h * control_weight.cwiseProduct(u);
  d.hessian.diagonal() << interval.h * state_weight, interval.h * control_weight;
}

double HorizonModel::terminal_cost(const State& x) const
{
  return 0.5 * end_weight * state_weight.dot(x.cwiseAbs2());
}

void HorizonModel::differentiate_terminal(const State& x, Terminal& terminal) const
{
  terminal.gradient = end_weight * state_weight.cwiseProduct(x);
  terminal.hessian.diagonal() = end_weight * state_weight;
}

Mpc::Mpc(const Robot& robot, const TrackOptions& options) : robot_(robot), error_model_(robot, Mode::none)
{
  check(options);
  const std::size_t count = static_cast<std::size_t>(options.knots);
  const double first = 1.0 / options.controller_frequency;
  times_ = {0.0};
  for (std::size_t k = 0; k < count; ++k)
    times_.push_back(first + (options.horizon - first) * double(k) / double(count - 1));

  const auto weight = [&](double scale) { return 1.0 / (scale * scale); };
  horizon_.state_weight << weight(options.longitudinal_scale), weight(options.lateral_scale),
      weight(options.heading_scale), weight(options.speed_scale), weight(options.steering_scale);
  horizon_.control_weight << weight(options.acceleration_scale), weight(options.steering_rate_scale);
  horizon_.end_weight = kEnd;
  horizon_.intervals.resize(count);
  for (std::size_t k = 0; k < count; ++k)
    horizon_.intervals[k] = {Eigen::Matrix<double, 5, 7>::Zero(), times_[k + 1] - times_[k]};

  problem_.reset(count);
  hold_.states.assign(count + 1, ErrorState::Zero());
  hold_.controls.assign(count, ErrorInput::Zero());
  knots_.resize(count + 1);
  middles_.resize(count);
  prediction_.resize(count + 1);
  solver_.solve(horizon_, problem_, hold_);  // so that it has its storage
}

void Mpc::restart(Mode mode, const SteeringRange& steering)
{
  error_model_ = ErrorModel(robot_, mode);
  steering_ = steering;
  warm_ = false;
}

/// `state` moved within the bounds of v and phi, so that a measured value beyond them does not make the problem
/// infeasible.
MotionState Mpc::within_bounds(const MotionState& state) const
{
  MotionState inside = state;
  inside.v = std::clamp(state.v, -robot_.max_speed, robot_.max_speed);
  inside.phi = std::clamp(state.phi, steering_.low, steering_.high);
  return inside;
}

/// Bounds on v and phi at a knot. v may take the time it needs to get within the limit of the fastest wheel.
void Mpc::set_state_bounds(std::size_t k, double v)
{
  const MotionState& r = knots_[k];
  const double by_wheels = robot_.wheel_max_speed / wheel_speed_ratio(robot_, error_model_.mode(), r.phi);
  const double reachable = std::abs(v) - robot_.max_acceleration * times_[k];
  const double limit = std::max(std::min(robot_.max_speed, by_wheels), reachable);
  auto& bounds = problem_.bounds[k];
  bounds.lower.segment<2>(3) << -limit - r.v, steering_.low - r.phi;
  bounds.upper.segment<2>(3) << limit - r.v, steering_.high - r.phi;
}

/// Dynamics and bounds on a and omega of an interval.
void Mpc::set_interval(const MotionState& state, std::size_t k)
{
  const MotionState &from = knots_[k], &to = knots_[k + 1];
  const double h = horizon_.intervals[k].h;
  // The mean input over the interval: the reference's own input may change within it.
  const ReferencePoint middle = {state, {(to.v - from.v) / h, (to.phi - from.phi) / h}};
  horizon_.intervals[k].jacobian = error_model_.jacobian(middle, h);
  const double rate =
      std::min(robot_.max_steering_rate, robot_.wheel_max_rate / error_model_.steering_gain(middle.state.phi));
  auto& bounds = problem_.bounds[k];
  bounds.lower.tail<2>() << -robot_.max_acceleration - middle.input.a, -rate - middle.input.omega;
  bounds.upper.tail<2>() << robot_.max_acceleration - middle.input.a, rate - middle.input.omega;
}

MpcAnswer Mpc::solve(const Reference& reference, double t, const MotionState& state)
{
  for (std::size_t k = 0; k < knots_.size(); ++k) knots_[k] = reference.at(t + times_[k]).state;
  for (std::size_t k = 0; k < middles_.size(); ++k)
    middles_[k] = reference.at(t + 0.5 * (times_[k] + times_[k + 1])).state;
  return solve_from(state);
}

MpcAnswer Mpc::solve(const Reference& reference, Pace pace, bool go, const MotionState& state)
{
  if (go && pace.rate() == 1.0) return solve(reference, pace.time(), state);
  for (std::size_t k = 0; k < middles_.size(); ++k)
  {
    const double half = 0.5 * horizon_.intervals[k].h;
    knots_[k] = pace.state(reference);
    pace.advance(reference, go, half);
    middles_[k] = pace.state(reference);
    pace.advance(reference, go, half);
  }
  knots_.back() = pace.state(reference);
  return solve_from(state);
}

MpcAnswer Mpc::solve_from(const MotionState& state)
{
  const MotionState start = within_bounds(state);
  for (std::size_t k = 0; k <= problem_.intervals(); ++k) set_state_bounds(k, start.v);
  for (std::size_t k = 0; k < problem_.intervals(); ++k) set_interval(middles_[k], k);
  problem_.initial_state = error_model_.error(start, knots_.front());

  const auto* solution = &(warm_ ? solve_warm() : solve_cold());
  if (warm_ && !is_usable(*solution)) solution = &solve_cold();
  MpcAnswer answer;
  answer.iterations = solution->statistics.iterations;
  answer.usable = warm_ = is_usable(*solution);
  if (answer.usable) take(*solution, answer);
  return answer;
}

/// Starts from the last solution, because little changes from one control step to the next.
auto Mpc::solve_warm() -> const Solution&
{
  return solver_.solve(horizon_, problem_, solver_.solution().trajectory, solver_options(true),
                       &solver_.solution().multipliers);
}

/// Starts from a robot with constant v and phi, which keeps all bounds.
auto Mpc::solve_cold() -> const Solution&
{
  hold_.states.front() = problem_.initial_state;
  for (std::size_t k = 0; k < hold_.controls.size(); ++k)
  {
    const MotionState &from = knots_[k], &to = knots_[k + 1];
    hold_.controls[k] = ErrorInput(from.v - to.v, from.phi - to.phi) / horizon_.intervals[k].h;
    hold_.states[k + 1] = horizon_.intervals[k].jacobian.leftCols<5>() * hold_.states[k] +
                          horizon_.intervals[k].jacobian.rightCols<2>() * hold_.controls[k];
  }
  return solver_.solve(horizon_, problem_, hold_, solver_options(false));
}

void Mpc::take(const Solution& solution, MpcAnswer& answer)
{
  const MotionState &from = knots_[0], &to = knots_[1];
  answer.input = {(to.v - from.v) / times_[1] + solution.trajectory.controls.front()[0],
                  (to.phi - from.phi) / times_[1] + solution.trajectory.controls.front()[1]};
  for (std::size_t k = 0; k < knots_.size(); ++k)
    prediction_[k] = error_model_.pose(solution.trajectory.states[k], knots_[k]);
}

}  // namespace fourwis
