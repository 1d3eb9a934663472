#include "conversions.h"

#include "fourwis_navigation/model/fingerprint.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/vehicle/base_link.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace fourwis
{
namespace
{

void check_quaternion(const geometry_msgs::Quaternion& q, const std::string& name)
{
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  // Written so that NaN, too, is rejected.
  if (!(std::abs(norm - 1.0) <= kQuaternionTolerance))
    reject<ConversionError>(name, ": orientation (", q.x, ", ", q.y, ", ", q.z, ", ", q.w, ") has norm ", norm,
                            ", expected a quaternion of norm 1 within ", kQuaternionTolerance);
}

/// Angle between the pose's z axis and the plane's normal [rad].
double tilt(const geometry_msgs::Quaternion& q)
{
  const double horizontal = 2.0 * std::hypot(q.x * q.z + q.w * q.y, q.y * q.z - q.w * q.x);
  return std::atan2(horizontal, q.w * q.w + q.z * q.z - q.x * q.x - q.y * q.y);
}

double yaw(const geometry_msgs::Quaternion& q)
{
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

void check_size(const nav_msgs::OccupancyGrid& message)
{
  const std::uint64_t width = message.info.width, height = message.info.height;
  if (width == 0 || height == 0)
    reject<ConversionError>("map: size is ", width, " x ", height, " cells, expected at least 1 x 1");
  if (message.data.size() != width * height)
    reject<ConversionError>("map: data holds ", message.data.size(), " cells, expected width x height = ", width, " x ",
                            height, " = ", width * height);
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  if (width > most || height > most)
    reject<ConversionError>("map: size is ", width, " x ", height, " cells, expected at most ", most, " each");
}

geometry_msgs::PoseStamped stamped(const Pose& pose, const std_msgs::Header& header)
{
  geometry_msgs::PoseStamped message;
  message.header = header;
  message.pose = to_message(pose);
  return message;
}

}  // namespace

Pose to_pose(const geometry_msgs::Pose& message, const std::string& name, double max_tilt)
{
  const auto& p = message.position;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    reject<ConversionError>(name, ": position (", p.x, ", ", p.y, ", ", p.z, ") is not finite");
  check_quaternion(message.orientation, name);
  if (tilt(message.orientation) > max_tilt)
    reject<ConversionError>(name, ": orientation is tilted out of the plane by ", tilt(message.orientation),
                            " rad, expected at most ", max_tilt, " rad");
  return {p.x, p.y, yaw(message.orientation)};
}

Pose to_pose(const geometry_msgs::Transform& message, const std::string& name, double max_tilt)
{
  geometry_msgs::Pose pose;
  pose.position.x = message.translation.x;
  pose.position.y = message.translation.y;
  pose.position.z = message.translation.z;
  pose.orientation = message.rotation;
  return to_pose(pose, name, max_tilt);
}

namespace
{

/// Older tools, octomap_server among them, leave the orientation of the origin at zero and mean none.
Pose map_origin(const nav_msgs::OccupancyGrid& message)
{
  geometry_msgs::Pose origin = message.info.origin;
  geometry_msgs::Quaternion& q = origin.orientation;
  if (q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && q.w == 0.0) q.w = 1.0;
  return to_pose(origin, "map: origin");
}

}  // namespace

void check_map(const nav_msgs::OccupancyGrid& message)
{
  check_size(message);
  if (!std::isfinite(message.info.resolution) || message.info.resolution <= 0.0f)
    reject<ConversionError>("map: resolution is ", message.info.resolution, " m, expected a positive number");
  map_origin(message);
}

OccupancyGrid to_grid(const nav_msgs::OccupancyGrid& message)
{
  check_map(message);
  OccupancyGrid grid;
  grid.width = static_cast<int>(message.info.width);
  grid.height = static_cast<int>(message.info.height);
  grid.resolution = message.info.resolution;
  grid.origin = map_origin(message);
  grid.data.assign(message.data.begin(), message.data.end());
  return grid;
}

void apply_update(const map_msgs::OccupancyGridUpdate& update, OccupancyGrid& grid)
{
  const std::uint64_t width = update.width, height = update.height;
  const auto inside = [](std::int64_t start, std::int64_t size, int limit) {
    return start >= 0 && size >= 0 && start + size <= limit;
  };
  if (!inside(update.x, update.width, grid.width) || !inside(update.y, update.height, grid.height))
    reject<ConversionError>("map update: ", width, " x ", height, " cells at (", update.x, ", ", update.y,
                            ") do not lie in the map of ", grid.width, " x ", grid.height, " cells");
  if (update.data.size() != width * height)
    reject<ConversionError>("map update: data holds ", update.data.size(), " cells, expected width x height = ", width,
                            " x ", height, " = ", width * height);

  const auto stride = static_cast<std::ptrdiff_t>(grid.width);
  auto target = grid.data.begin() + update.y * stride + update.x;
  for (auto row = update.data.begin(); row != update.data.end(); row += static_cast<std::ptrdiff_t>(width))
  {
    std::copy(row, row + static_cast<std::ptrdiff_t>(width), target);
    // Past the last row there is nothing to point at.
    if (row + static_cast<std::ptrdiff_t>(width) != update.data.end()) target += stride;
  }
}

ModeSet to_modes(const std::vector<std::string>& names)
{
  if (names.empty()) return {};
  ModeSet modes = ModeSet::none();
  for (const std::string& name : names)
  {
    const auto mode = mode_from_string(name);
    if (!mode) reject<ConversionError>("modes: '", name, "' is unknown, expected ", planned_mode_names(", ", " or "));
    modes.insert(*mode);
  }
  return modes;
}

geometry_msgs::Pose to_message(const Pose& pose)
{
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(pose.theta / 2.0);
  message.orientation.w = std::cos(pose.theta / 2.0);
  return message;
}

geometry_msgs::TransformStamped to_message(const Pose& pose, const std_msgs::Header& header, const std::string& child)
{
  const geometry_msgs::Pose plain = to_message(pose);
  geometry_msgs::TransformStamped message;
  message.header = header;
  message.child_frame_id = child;
  message.transform.translation.x = plain.position.x;
  message.transform.translation.y = plain.position.y;
  message.transform.rotation = plain.orientation;
  return message;
}

geometry_msgs::Twist to_message(const Twist& twist)
{
  geometry_msgs::Twist message;
  message.linear.x = twist.vx;
  message.linear.y = twist.vy;
  message.angular.z = twist.omega;
  return message;
}

nav_msgs::OccupancyGrid to_message(const OccupancyGrid& grid, const std_msgs::Header& header)
{
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin = to_message(grid.origin);
  message.data.assign(grid.data.begin(), grid.data.end());
  return message;
}

fourwis_navigation::ModeTrajectory to_message(const Robot& robot, const Trajectory& trajectory,
                                              const std_msgs::Header& header)
{
  fourwis_navigation::ModeTrajectory message;
  message.header = header;
  message.fingerprint = fingerprint(robot);
  message.points.reserve(trajectory.size());
  for (const TrajectoryPoint& point : trajectory)
  {
    fourwis_navigation::TrajectoryPoint& out = message.points.emplace_back();
    out.t = point.t;
    out.mode = static_cast<std::uint8_t>(point.mode);
    out.x = point.x;
    out.y = point.y;
    out.theta = point.theta;
    out.v = point.v;
    out.phi = point.phi;
    out.a = point.a;
    out.omega = point.omega;
  }
  return message;
}

fourwis_navigation::PlanMetrics to_message(const PlanMetrics& metrics)
{
  fourwis_navigation::PlanMetrics message;
  message.safe = metrics.safe;
  message.length = metrics.length;
  message.arrival_time = metrics.arrival_time;
  message.mean_curvature = metrics.mean_curvature;
  message.max_curvature = metrics.max_curvature;
  message.terminal_position_error = metrics.terminal_position_error;
  message.terminal_yaw_error = metrics.terminal_yaw_error;
  message.standard_mode_rate = metrics.standard_mode_rate;
  message.total_ms = metrics.total_ms;
  message.map_ms = metrics.map_ms;
  message.frontend_ms = metrics.frontend_ms;
  message.backend_ms = metrics.backend_ms;
  message.verify_ms = metrics.verify_ms;
  message.expansions = metrics.expansions;
  message.switches = metrics.switches;
  message.outer_iterations = metrics.outer_iterations;
  message.ipopt_iterations = metrics.ipopt_iterations;
  message.min_clearance = metrics.min_clearance;
  return message;
}

nav_msgs::Path to_path_message(const Trajectory& trajectory, const std_msgs::Header& header)
{
  nav_msgs::Path message;
  message.header = header;
  for (const TrajectoryPoint& point : trajectory) message.poses.push_back(stamped(point.pose(), header));
  return message;
}

nav_msgs::Path to_path_message(const Robot& robot, const Path& path, const std_msgs::Header& header, double step)
{
  nav_msgs::Path message;
  message.header = header;
  const BaseLink base_link(robot);
  for (const PathPiece& piece : path.pieces)
  {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(piece.length) / step)));
    for (int i = 0; i < steps; ++i)
      message.poses.push_back(stamped(
          base_link.from_centre(advance(robot, piece.start, piece.mode, piece.phi, piece.length * i / steps)), header));
  }
  if (!path.pieces.empty()) message.poses.push_back(stamped(base_link.from_centre(path.goal), header));
  return message;
}

}  // namespace fourwis
