#include "fourwis_navigation/vehicle/base_link.h"

#include <utility>

namespace fourwis
{
namespace
{

template <class Convert>
Trajectory converted(Trajectory trajectory, Convert convert)
{
  for (TrajectoryPoint& point : trajectory)
  {
    const Pose pose = convert(point.pose());
    point.x = pose.x;
    point.y = pose.y;
    point.theta = pose.theta;
  }
  return trajectory;
}

/// Covariance of (x, y, theta), or of their rates, of another point of the body, at (dx, dy) from the one it is given for.
Eigen::Matrix3d seen_from(double dx, double dy, const Eigen::Matrix3d& covariance)
{
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -dy;
  jacobian(1, 2) = dx;
  return jacobian * covariance * jacobian.transpose();
}

}  // namespace

Trajectory BaseLink::to_centre(Trajectory base_link) const
{
  return converted(std::move(base_link), [this](const Pose& pose) { return to_centre(pose); });
}

Trajectory BaseLink::from_centre(Trajectory centre) const
{
  return converted(std::move(centre), [this](const Pose& pose) { return from_centre(pose); });
}

Twist BaseLink::to_centre(const Twist& base_link) const
{
  return {base_link.vx - base_link.omega * centre_.y, base_link.vy + base_link.omega * centre_.x, base_link.omega};
}

Twist BaseLink::from_centre(const Twist& centre) const
{
  return {centre.vx + centre.omega * centre_.y, centre.vy - centre.omega * centre_.x, centre.omega};
}

Odometry BaseLink::from_centre(const Odometry& centre) const
{
  Odometry base_link = centre;
  base_link.pose = from_centre(centre.pose);
  base_link.motion.twist = from_centre(centre.motion.twist);
  // What is not known of the heading moves base_link across its direction from C.
  const double dx = base_link.pose.x - centre.pose.x, dy = base_link.pose.y - centre.pose.y;
  base_link.pose_covariance = seen_from(dx, dy, centre.pose_covariance);
  base_link.motion.covariance = seen_from(-centre_.x, -centre_.y, centre.motion.covariance);
  return base_link;
}

}  // namespace fourwis
