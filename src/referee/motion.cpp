#include "motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "rollout.h"

namespace fourwis::referee
{
namespace
{

constexpr double kTouch = 1e-9;  // an overlap of this depth is still a touch [m]

// Clearances that exceed the least one so far by more than the look-ahead are not told apart. It follows what was seen.
constexpr double kLeastLookAhead = 0.05;  // [m]
constexpr double kMostLookAhead = 0.8;    // [m]

constexpr double kMostMotion = 2e4;     // of the body, and of its angles, along one trajectory [m, rad]
constexpr long kMostLooks = 1'000'000;  // at the grid for one trajectory

/// Moves the body along the trajectory and looks at the grid no more often than needed: no body point can reach an
/// obstacle before it has moved by the clearance last seen.
class Sweep
{
public:
  Sweep(const Court& court, const ObstacleCells& cells, Verdict& verdict)
    : court_(court),
      cells_(cells),
      verdict_(verdict),
      step_(court.options.collision_step),
      half_length_(court.robot.length / 2),
      half_width_(court.robot.width / 2),
      radius_(std::hypot(half_length_, half_width_)),
      least_(INFINITY)
  {}

  void run()
  {
    court_.report.next_kind();
    const Trajectory& points = court_.trajectory;
    look_at_point(0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      if (points[i].mode == points[i + 1].mode)
        roll(i);
      else
        jump(points[i].pose(), points[i + 1].pose());
      if (exhausted_)
      {
        court_.report.add(i, points[i].t, "motion too long to be judged");
        break;
      }
      if (sure_ <= 0.0 || credit_ <= 0.0 || i + 2 == points.size()) look_at_point(i + 1);
    }
    verdict_.min_clearance = least_;
  }

private:
  /// From point i to the next, looking wherever the credit is used up.
  void roll(std::size_t i)
  {
    const TrajectoryPoint &from = court_.trajectory[i], &to = court_.trajectory[i + 1];
    const double duration = to.t - from.t;
    Rollout rollout(court_.robot, from, to);
    const double motion_per_length = 1.0 + radius_ * rollout.greatest_curvature();
    if (!affordable(rollout.greatest_speed() * duration * (motion_per_length + rollout.greatest_curvature()) +
                    std::abs(to.phi - from.phi)))
      return;
    while (rollout.remaining() > 0.0 && !exhausted_)
    {
      const double motion_per_share = rollout.greatest_speed() * duration * motion_per_length;
      const double moved = motion_per_share * rollout.remaining();
      if (moved <= credit_ || collided_at(i))
      {
        rollout.advance(rollout.remaining());
        spend(moved);
        break;
      }
      rollout.advance(credit_ / motion_per_share);
      spend(credit_);
      look(i, from.t + (1.0 - rollout.remaining()) * duration, rollout);
    }
    if (!exhausted_) compare(i, rollout);
  }

  /// Whether the motion of one more interval may be followed: garbage must not keep the referee busy for ever.
  bool affordable(double motion)
  {
    motion_ += motion;
    if (!(motion_ <= kMostMotion)) exhausted_ = true;
    return !exhausted_;
  }

  /// The rolled-out end against the stated next point.
  void compare(std::size_t i, const Rollout& rollout)
  {
    const TrajectoryPoint& next = court_.trajectory[i + 1];
    const Pose end{rollout.x(), rollout.y(), rollout.theta()};
    const double position = distance(end, next.pose()), angle = std::abs(end.theta - next.theta);
    verdict_.max_rollout_position = std::max(verdict_.max_rollout_position, position);
    verdict_.max_rollout_angle = std::max(verdict_.max_rollout_angle, angle);
    if (!(position <= court_.options.rollout_position))
      court_.report.add(i, court_.trajectory[i].t, "distance from the rolled-out motion to the next point", position,
                        court_.options.rollout_position, "m");
    if (!(angle <= court_.options.rollout_angle))
      court_.report.add(i, court_.trajectory[i].t, "angle from the rolled-out motion to the next point", angle,
                        court_.options.rollout_angle, "rad");
    jump(end, next.pose());
  }

  void jump(const Pose& from, const Pose& to) { spend(distance(from, to) + radius_ * std::abs(to.theta - from.theta)); }

  void spend(double motion)
  {
    sure_ -= motion;
    credit_ -= motion;
  }

  void look_at_point(std::size_t i)
  {
    const TrajectoryPoint& p = court_.trajectory[i];
    look(i, p.t, p.x, p.y, p.theta, std::cos(p.theta), std::sin(p.theta));
  }

  void look(std::size_t i, double t, const Rollout& rollout)
  {
    look(i, t, rollout.x(), rollout.y(), rollout.theta(), rollout.cosine(), rollout.sine());
  }

  void look(std::size_t i, double t, double x, double y, double theta, double cosine, double sine)
  {
    if (++looks_ > kMostLooks) exhausted_ = true;
    const Box touching = cells_.box(x, y, cosine, sine, half_length_ - kTouch, half_width_ - kTouch);
    const bool inside = cells_.contains(touching);
    const bool in_doubt = sure_ <= 0.0;
    const std::optional<Cell> hit = inside && in_doubt ? cells_.overlapped(touching) : std::nullopt;
    double clearance = 0.0;
    if (!inside || hit)
      collide(i, t, Pose{x, y, theta}, hit);
    else
      clearance = cells_.clearance(cells_.box(x, y, cosine, sine, half_length_, half_width_),
                                   (least_ + look_ahead_) / cells_.resolution()) *
                  cells_.resolution();
    least_ = std::min(least_, clearance);
    look_ahead_ = std::clamp(2.0 * (clearance - least_), kLeastLookAhead, kMostLookAhead);
    sure_ = clearance;
    // Finer than the step where obstacles are near; further apart where neither a collision nor a new least clearance
    // can lie between.
    const double dull = std::max({clearance - least_, least_ / 4.0, step_});
    credit_ = std::max(step_ / 8.0, std::min(clearance, dull));
  }

  /// One sentence for each interval.
  void collide(std::size_t i, double t, const Pose& pose, const std::optional<Cell>& hit)
  {
    if (collided_at(i)) return;
    collided_ = true;
    collision_ = i;
    char text[200];
    int end = std::snprintf(text, sizeof(text), "collision: the body at (%.9g m, %.9g m, %.9g rad) ", pose.x, pose.y,
                            pose.theta);
    if (hit)
      std::snprintf(text + end, sizeof(text) - static_cast<std::size_t>(end),
                    "overlaps the obstacle cell in column %d, row %d", hit->column, hit->row);
    else
      std::snprintf(text + end, sizeof(text) - static_cast<std::size_t>(end), "leaves the grid");
    court_.report.add(i, t, text);
  }

  bool collided_at(std::size_t i) const { return collided_ && collision_ == i; }

  const Court& court_;
  const ObstacleCells& cells_;
  Verdict& verdict_;
  const double step_, half_length_, half_width_, radius_;
  double least_;  ///< clearance so far [m]
  double look_ahead_ = kMostLookAhead;
  double sure_ = 0.0;    ///< motion that cannot lead into an obstacle [m]; may be less than the credit
  double credit_ = 0.0;  ///< motion until the next look [m]
  long looks_ = 0;
  double motion_ = 0.0;  ///< bound on what was followed so far [m, rad]
  bool exhausted_ = false;
  bool collided_ = false;
  std::size_t collision_ = 0;  ///< interval of the last collision
};

}  // namespace

void check_motion(const Court& court, const ObstacleCells& cells, Verdict& verdict)
{
  Sweep(court, cells, verdict).run();
}

}  // namespace fourwis::referee
