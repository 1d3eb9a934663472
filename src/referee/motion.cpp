#include "motion.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fourwis_navigation/model/sentence.h"
#include "rollout.h"
#include "shape.h"

namespace fourwis::referee
{
namespace
{

constexpr double kTouch = 1e-9;          // an overlap of this depth is still a touch [m]
constexpr double kDepthRounding = 1e-7;  // depths are equal within this [m]

// Clearances that exceed the least one so far by more than the look-ahead count as equal. The look-ahead is adapted to
// the last clearance seen.
constexpr double kLeastLookAhead = 0.05;  // [m]
constexpr double kMostLookAhead = 0.8;    // [m]

constexpr double kMostMotion = 2e4;     // of the body, and of its angles, along one trajectory [m, rad]
constexpr long kMostLooks = 1'000'000;  // at the grid for one trajectory

/// Moves the body along the trajectory and looks at the grid no more often than needed. No point of the body can reach an
/// obstacle before it has moved by the clearance that was seen last.
class Sweep
{
public:
  Sweep(const Judgement& judgement, const ObstacleCells& cells, Verdict& verdict)
    : judgement_(judgement),
      cells_(cells),
      verdict_(verdict),
      step_(judgement.options.collision_step),
      body_(body_shape(judgement.robot)),
      touching_(inset(body_, kTouch)),
      radius_(greatest_radius(body_)),
      greatest_depth_(judgement.options.start_tolerance),
      least_(INFINITY)
  {}

  void run()
  {
    judgement_.report.next_kind();
    const Trajectory& points = judgement_.trajectory;
    look_at_point(0);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      if (points[i].mode == points[i + 1].mode)
        roll(i);
      else
        jump(points[i].pose(), points[i + 1].pose());
      if (exhausted_)
      {
        judgement_.report.add(i, points[i].t, "motion too long to be judged");
        break;
      }
      if (safe_motion_ <= 0.0 || motion_to_next_look_ <= 0.0 || i + 2 == points.size()) look_at_point(i + 1);
    }
    verdict_.min_clearance = least_;
  }

private:
  /// From point i to the next, looking at the grid when the motion to the next look is used up.
  void roll(std::size_t i)
  {
    const TrajectoryPoint &from = judgement_.trajectory[i], &to = judgement_.trajectory[i + 1];
    const double duration = to.t - from.t;
    Rollout rollout(judgement_.robot, from, to);
    const double motion_per_length = 1.0 + radius_ * rollout.greatest_curvature();
    if (!affordable(rollout.greatest_speed() * duration * (motion_per_length + rollout.greatest_curvature()) +
                    std::abs(to.phi - from.phi)))
      return;
    while (rollout.remaining() > 0.0 && !exhausted_)
    {
      const double motion_per_share = rollout.greatest_speed() * duration * motion_per_length;
      const double moved = motion_per_share * rollout.remaining();
      if (moved <= motion_to_next_look_ || collided_at(i))
      {
        rollout.advance(rollout.remaining());
        move_by(moved);
        break;
      }
      rollout.advance(motion_to_next_look_ / motion_per_share);
      move_by(motion_to_next_look_);
      look(i, from.t + (1.0 - rollout.remaining()) * duration, rollout);
    }
    if (!exhausted_) compare(i, rollout);
  }

  /// Whether the motion of one more interval may be followed. The bound keeps the time that garbage takes finite.
  bool affordable(double motion)
  {
    motion_ += motion;
    if (!(motion_ <= kMostMotion)) exhausted_ = true;
    return !exhausted_;
  }

  /// The rolled-out end against the stated next point.
  void compare(std::size_t i, const Rollout& rollout)
  {
    const TrajectoryPoint& next = judgement_.trajectory[i + 1];
    const Pose end{rollout.x(), rollout.y(), rollout.theta()};
    const double position = distance(end, next.pose()), angle = std::abs(end.theta - next.theta);
    verdict_.max_rollout_position = std::max(verdict_.max_rollout_position, position);
    verdict_.max_rollout_angle = std::max(verdict_.max_rollout_angle, angle);
    if (!(position <= judgement_.options.rollout_position))
      judgement_.report.add(i, judgement_.trajectory[i].t, "distance from the rolled-out motion to the next point",
                            position, judgement_.options.rollout_position, "m");
    if (!(angle <= judgement_.options.rollout_angle))
      judgement_.report.add(i, judgement_.trajectory[i].t, "angle from the rolled-out motion to the next point", angle,
                            judgement_.options.rollout_angle, "rad");
    jump(end, next.pose());
  }

  void jump(const Pose& from, const Pose& to)
  {
    move_by(distance(from, to) + radius_ * std::abs(to.theta - from.theta));
  }

  void move_by(double motion)
  {
    safe_motion_ -= motion;
    motion_to_next_look_ -= motion;
  }

  void look_at_point(std::size_t i)
  {
    const TrajectoryPoint& p = judgement_.trajectory[i];
    look(i, p.t, p.x, p.y, p.theta, std::cos(p.theta), std::sin(p.theta));
  }

  void look(std::size_t i, double t, const Rollout& rollout)
  {
    look(i, t, rollout.x(), rollout.y(), rollout.theta(), rollout.cosine(), rollout.sine());
  }

  void look(std::size_t i, double t, double x, double y, double theta, double cosine, double sine)
  {
    if (++looks_ > kMostLooks) exhausted_ = true;
    cells_.place(touching_, x, y, cosine, sine, outline_);
    const bool inside = cells_.contains(outline_);
    const bool in_doubt = safe_motion_ <= 0.0;
    const std::optional<Cell> hit = inside && in_doubt ? cells_.overlapped(outline_) : std::nullopt;
    double clearance = 0.0;
    if (inside && hit && is_leaving(x, y, cosine, sine))
      clearance = 0.0;
    else if (!inside || hit)
      collide(i, t, Pose{x, y, theta}, hit);
    else if (in_doubt)
      greatest_depth_ = 0.0;
    if (inside && !hit)
    {
      cells_.place(body_, x, y, cosine, sine, outline_);
      clearance = cells_.clearance(outline_, (least_ + look_ahead_) / cells_.resolution()) * cells_.resolution();
    }
    least_ = std::min(least_, clearance);
    look_ahead_ = std::clamp(2.0 * (clearance - least_), kLeastLookAhead, kMostLookAhead);
    safe_motion_ = clearance;
    // Near obstacles the looks are closer together than the step. They are farther apart where neither a collision nor a
    // new least clearance can lie between them.
    const double spacing = std::max({clearance - least_, least_ / 4.0, step_});
    motion_to_next_look_ = std::max(step_ / 8.0, std::min(clearance, spacing));
  }

  /// Whether a body that overlaps has done so since the start, and is not deeper than ever before.
  bool is_leaving(double x, double y, double cosine, double sine)
  {
    if (greatest_depth_ <= 0.0) return false;
    double free = radius_, deep = 0.0;
    while (free - deep > kTouch)
    {
      const double depth = (free + deep) / 2.0;
      const Shape smaller = inset(body_, depth);
      if (!smaller.empty()) cells_.place(smaller, x, y, cosine, sine, outline_);
      (!smaller.empty() && cells_.overlapped(outline_) ? deep : free) = depth;
    }
    if (free > greatest_depth_ + kDepthRounding) return false;
    greatest_depth_ = std::min(greatest_depth_, free);
    return true;
  }

  /// One sentence for each interval.
  void collide(std::size_t i, double t, const Pose& pose, const std::optional<Cell>& hit)
  {
    if (collided_at(i)) return;
    collided_ = true;
    collision_ = i;
    const std::string what =
        hit ? sentence("overlaps the obstacle cell in column %d, row %d", hit->column, hit->row) : "leaves the grid";
    const Point2& base = judgement_.robot.base_offset;
    const Pose told = compose(compose(judgement_.frame, pose), {-base.x, -base.y, 0.0});
    judgement_.report.add(
        i, t,
        sentence("collision: the body at (%.9g m, %.9g m, %.9g rad) %s", told.x, told.y, told.theta, what.c_str()));
  }

  bool collided_at(std::size_t i) const { return collided_ && collision_ == i; }

  const Judgement& judgement_;
  const ObstacleCells& cells_;
  Verdict& verdict_;
  const double step_;
  const Shape body_, touching_;  ///< the body, and what of it must be free
  const double radius_;          ///< of the body around C [m]
  Outline outline_{};            ///< the one that is looked at
  double greatest_depth_;        ///< that the body may have; 0 as soon as it has been free [m]
  double least_;                 ///< clearance so far [m]
  double look_ahead_ = kMostLookAhead;
  double safe_motion_ = 0.0;          ///< the body cannot reach an obstacle within this motion [m]
  double motion_to_next_look_ = 0.0;  ///< the grid is looked at after this motion [m]; may exceed safe_motion_
  long looks_ = 0;
  double motion_ = 0.0;  ///< bound on what was followed so far [m, rad]
  bool exhausted_ = false;
  bool collided_ = false;
  std::size_t collision_ = 0;  ///< interval of the last collision
};

}  // namespace

void check_motion(const Judgement& judgement, const ObstacleCells& cells, Verdict& verdict)
{
  Sweep(judgement, cells, verdict).run();
}

}  // namespace fourwis::referee
