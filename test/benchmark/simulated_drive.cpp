#include "simulated_drive.h"

#include <cmath>
#include <deque>

#include "../support/random.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/sim/base_simulator.h"
#include "measurement.h"
#include "trajectory_at.h"

namespace fourwis::benchmark
{
namespace
{

/// How far from the beginning of the trajectory the robot is placed, at most.
constexpr double kStartOffset = 0.005, kStartTurn = 0.005;  // [m, rad]
/// A drive that takes longer than so many times the trajectory and more than that hangs [s].
constexpr double kPatience = 60.0;

class SimulatedDrive
{
public:
  SimulatedDrive(const DriveConditions& conditions, const Trajectory& trajectory, const OccupancyGrid* grid, int seed)
    : conditions_(conditions),
      trajectory_(trajectory),
      random_(static_cast<unsigned>(seed)),
      base_(conditions.robot, with_seed(conditions.simulator, seed)),
      tracker_(conditions.robot, conditions.track),
      period_(1.0 / conditions.track.controller_frequency)
  {
    if (grid) footprint_.emplace(*grid, conditions.robot);
    const double r = kStartOffset, turn = kStartTurn;
    base_.place(compose(trajectory.front().pose(),
                        {random_.between(-r, r), random_.between(-r, r), random_.between(-turn, turn)}));
  }

  DriveResult run()
  {
    result_.message = tracker_.accept(trajectory_);
    result_.state = TrackState::failed;
    if (!result_.message.empty()) return result_;
    const double patience = 2.0 * trajectory_.back().t + kPatience;
    while (base_.time() < patience && step())
    {}
    const Pose goal = trajectory_.back().pose();
    result_.terminal_position = distance(pose(), goal);
    result_.terminal_heading = std::abs(wrap_angle(pose().theta - goal.theta));
    return result_;
  }

private:
  static SimulatorOptions with_seed(SimulatorOptions options, int seed)
  {
    options.seed = seed;
    return options;
  }

  double noise(double deviation) { return deviation * std::sqrt(3.0) * random_.between(-1.0, 1.0); }

  /// What the localiser says now of the pose some time ago.
  TrackInput input()
  {
    const Localisation& localisation = conditions_.localisation;
    seen_.push_back({base_.time(), pose()});
    while (seen_.size() > 1 && seen_[1].first <= base_.time() - localisation.delay + 1e-9) seen_.pop_front();
    Pose pose = seen_.front().second;
    pose.x += noise(localisation.deviation);
    pose.y += noise(localisation.deviation);
    pose.theta += noise(localisation.yaw_deviation);
    return {base_.time(), seen_.front().first, pose, base_.wheels()};
  }

  /// One control step; false once the tracker is done.
  bool step()
  {
    const TrackInput known = input();
    const double begin = cpu_ms();
    const TrackOutput output = tracker_.step(known);
    const double ms = cpu_ms() - begin;
    result_.state = output.state;
    result_.message = output.message;
    if (output.state == TrackState::driving) observe(output, ms);
    if (output.state == TrackState::aligning) result_.aligning += period_;
    base_.command(output.command);
    let_time_pass();
    return output.state == TrackState::aligning || output.state == TrackState::driving ||
           output.state == TrackState::stopping;
  }

  void observe(const TrackOutput& output, double ms)
  {
    result_.driving += period_;
    result_.step_ms.push_back(ms);
    const TrajectoryPoint should =
        trajectory_at(conditions_.robot, trajectory_, output.t + base_.time() - seen_.front().first);
    const double course = should.theta + (should.mode == Mode::lateral    ? M_PI_2
                                          : should.mode == Mode::parallel ? should.phi
                                                                          : 0.0);
    const Pose error = relative_to({should.x, should.y, course}, pose());
    result_.longitudinal.push_back(std::abs(error.x));
    result_.lateral.push_back(std::abs(error.y));
    result_.heading.push_back(std::abs(wrap_angle(pose().theta - should.theta)));
    if (conditions_.push && !pushed_ && output.t >= conditions_.push->at) push();
  }

  /// Where the robot is.
  Pose pose() const { return compose(world_, base_.pose()); }

  /// Moves the body aside, wheels turning on: to the base all places are the same. Not into an obstacle; it waits for
  /// room.
  void push()
  {
    const Pose there = compose(pose(), conditions_.push->by);
    if (footprint_ && footprint_->collides(there)) return;
    world_ = compose(there, relative_to(base_.pose(), Pose{}));
    pushed_ = true;
  }

  void let_time_pass()
  {
    constexpr int looks = 2;  // at the footprint in each control step
    for (int i = 0; i < looks; ++i)
    {
      base_.step(period_ / looks);
      if (footprint_ && !result_.collided) result_.collided = footprint_->collides(pose());
    }
  }

  const DriveConditions& conditions_;
  const Trajectory& trajectory_;
  Random random_;
  BaseSimulator base_;
  Tracker tracker_;
  const double period_;
  std::optional<ExactRectangle> footprint_;
  std::deque<std::pair<double, Pose>> seen_;
  Pose world_;  ///< of the base's own frame
  bool pushed_ = false;
  DriveResult result_;
};

}  // namespace

DriveResult simulate(const DriveConditions& conditions, const Trajectory& trajectory, const OccupancyGrid* grid,
                     int seed)
{
  return SimulatedDrive(conditions, trajectory, grid, seed).run();
}

}  // namespace fourwis::benchmark
