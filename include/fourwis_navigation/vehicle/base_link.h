#pragma once

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/wheel_odometry.h"

namespace fourwis
{

/// The one converter between what users see and what is computed: poses, trajectories and twists that come in or go out are those
/// of `base_link`, all others are those of C, the centre of the wheels. The frame that poses are given in stays the same, and so
/// do headings, v and phi. Where base_link is C it changes nothing.
class BaseLink
{
public:
  explicit BaseLink(const Robot& robot) : centre_{robot.base_offset.x, robot.base_offset.y, 0.0} {}

  Pose to_centre(const Pose& base_link) const { return compose(base_link, centre_); }
  Pose from_centre(const Pose& centre) const { return compose(centre, {-centre_.x, -centre_.y, 0.0}); }

  Trajectory to_centre(Trajectory base_link) const;
  Trajectory from_centre(Trajectory centre) const;

  /// Velocities of the same body, in its own frame.
  Twist to_centre(const Twist& base_link) const;
  Twist from_centre(const Twist& centre) const;

  /// Odometry of base_link, with the covariances of its pose and its twist.
  Odometry from_centre(const Odometry& centre) const;

private:
  Pose centre_;  ///< of the wheels, in base_link
};

}  // namespace fourwis
