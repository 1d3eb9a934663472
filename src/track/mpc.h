#pragma once

#include <vector>

#include "error_model.h"
#include "fourwis_navigation/ocp/solver.h"
#include "fourwis_navigation/track/track_options.h"
#include "pace.h"

namespace fourwis
{

/// The error model along a horizon with a quadratic cost: a convex problem.
struct HorizonModel : ocp::ModelBase<5, 2>
{
  struct Interval
  {
    Eigen::Matrix<double, 5, 7> jacobian;
    double h = 0.0;  ///< [s]
  };
  std::vector<Interval> intervals;
  State state_weight;       ///< per second
  Control control_weight;   ///< likewise
  double end_weight = 0.0;  ///< the cost of the last state counts for this time [s]

  void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const;
  void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda, Derivatives& d) const;
  double terminal_cost(const State& x) const;
  void differentiate_terminal(const State& x, Terminal& terminal) const;
};

/// What phi may be [rad].
struct SteeringRange
{
  double low, high;
};

/// What to do now.
struct MpcAnswer
{
  MotionInput input;    ///< for one control step
  bool usable = false;  ///< whether `input` is valid
  int iterations = 0;
};

/// Model-predictive controller of one mode's motion about a reference. Each step solves the linearised problem over the
/// horizon, warm-started. v, phi, a and omega are bounded, and so are the speed of the fastest wheel and the rate of
/// the fastest turning wheel. After set-up nothing is allocated. Deterministic.
class Mpc
{
public:
  /// Throws as check(options) does.
  Mpc(const Robot& robot, const TrackOptions& options);

  /// To be called before a stretch: forgets the last one.
  void restart(Mode mode, const SteeringRange& steering);

  /// From `state` at time t of the trajectory.
  MpcAnswer solve(const Reference& reference, double t, const MotionState& state);

  /// The same at a pace that goes on to the rate 1, or comes to rest.
  MpcAnswer solve(const Reference& reference, Pace pace, bool go, const MotionState& state);

  /// The problem of the last step and its solution, for tests.
  const HorizonModel& horizon() const { return horizon_; }
  const ocp::Problem<5, 2>& problem() const { return problem_; }
  const ocp::Trajectory<5, 2>& solution() const { return solver_.solution().trajectory; }

  /// Where the last answer expects the robot, one pose a knot.
  const std::vector<Pose>& prediction() const { return prediction_; }

private:
  using Solution = ocp::Solver<HorizonModel>::Solution;

  MotionState within_bounds(const MotionState& state) const;
  void set_state_bounds(std::size_t k, double v);
  void set_interval(const MotionState& middle, std::size_t k);
  MpcAnswer solve_from(const MotionState& state);
  const Solution& solve_warm();
  const Solution& solve_cold();
  void take(const Solution& solution, MpcAnswer& answer);

  const Robot robot_;
  std::vector<double> times_;  ///< of the knots, from the beginning of the horizon [s]
  ErrorModel error_model_;
  SteeringRange steering_{0.0, 0.0};
  HorizonModel horizon_;
  ocp::Problem<5, 2> problem_;
  ocp::Trajectory<5, 2> hold_;  ///< the guess of a cold start
  ocp::Solver<HorizonModel> solver_;
  std::vector<MotionState> knots_;    ///< of the reference
  std::vector<MotionState> middles_;  ///< the same in the middle of each interval
  std::vector<Pose> prediction_;
  bool warm_ = false;
};

}  // namespace fourwis
