#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fourwis_navigation/model/point.h"

namespace fourwis
{

/// How a point is written: "[0.34, 0]". See option_text.h.
struct PointText
{
  double most;  ///< greatest |x| and |y| [m]

  std::string expected() const;
  std::string write(const Point2& point) const;
  bool read(const std::string& text, Point2& point) const;
};

/// How a polygon is written: "[[0.5, 0.3], [-0.5, 0.3], [-0.5, -0.3], [0.5, -0.3]]", or "[]" for none.
struct PolygonText
{
  double most;  ///< greatest |x| and |y| [m]

  std::string expected() const;
  std::string write(const std::vector<Point2>& polygon) const;
  bool read(const std::string& text, std::vector<Point2>& polygon) const;
};

/// The 4WIS base. Defaults: the paper's Table I. One `config/robot.yaml` holds it for all nodes; the keys there are the
/// names here. C is the centre of the four wheels. All that is computed of the robot is in the frame of C, with the axes of
/// `base_link`; poses of users are those of `base_link` (vehicle/base_link.h).
struct Robot
{
  double length = 1.00;             ///< l, body length along x [m]
  double width = 0.62;              ///< w, body width along y [m]
  Point2 body_offset = {0.0, 0.0};  ///< centre of that rectangle, from C [m]
  std::vector<Point2> footprint;    ///< the body as a convex polygon in `base_link`, in place of the rectangle [m]
  Point2 base_offset = {0.0, 0.0};  ///< C in `base_link` [m]
  double wheelbase = 0.68;          ///< L, distance between front and rear steering axes [m]
  double track_width = 0.52;        ///< W, distance between left and right steering axes [m]
  double max_steering_angle = M_PI / 6.0;     ///< phi_max of the equivalent wheel, ackermann and lateral [rad]
  double max_steering_rate = M_PI;            ///< limit of |d phi / dt| of the equivalent wheel [rad/s]
  double max_speed = 1.0;                     ///< v_max of the centre C [m/s]
  double max_acceleration = 5.0;              ///< a_max of the centre C [m/s^2]
  double mode_switch_time = 0.4;              ///< t_switch, the least time a mode switch takes at rest [s]
  double wheel_max_angle = M_PI * 160 / 180;  ///< each wheel turns within +- this angle [rad]
  double wheel_max_rate = M_PI;               ///< steering rate of each wheel about its own axis [rad/s]
  double wheel_max_speed = 2.0;               ///< rolling speed of each wheel [m/s]
  double safety_margin = 0.02;                ///< r_safe, added to the two discs that cover the body [m]

  /// Of the rectangle along the axes that the body fills: the rectangle itself, or that around the footprint.
  double body_length() const;  ///< [m]
  double body_width() const;   ///< [m]

  /// The longer side of that [m].
  double size() const { return std::max(body_length(), body_width()); }

  /// What the lengths of motions are in proportion to: 0.85 times the diameter of the tightest Ackermann turn, but at least half
  /// the size and at most the size [m].
  double motion_size() const
  {
    return std::clamp(0.85 * wheelbase / std::tan(max_steering_angle), 0.5 * size(), size());
  }

  /// The table of the options; see option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("length", o.length, 0.05, 20.0, "m");
    row("width", o.width, 0.05, 20.0, "m");
    row("wheelbase", o.wheelbase, 0.01, 20.0, "m");
    row("track_width", o.track_width, 0.01, 20.0, "m");
    row("max_steering_angle", o.max_steering_angle, 0.01, M_PI * 80 / 180, "rad");
    row("max_steering_rate", o.max_steering_rate, 0.01, 100.0, "rad/s");
    row("max_speed", o.max_speed, 0.01, 20.0, "m/s");
    row("max_acceleration", o.max_acceleration, 0.01, 50.0, "m/s^2");
    row("mode_switch_time", o.mode_switch_time, 0.0, 60.0, "s");
    row("wheel_max_angle", o.wheel_max_angle, 0.01, 10.0, "rad");
    row("wheel_max_rate", o.wheel_max_rate, 0.01, 100.0, "rad/s");
    row("wheel_max_speed", o.wheel_max_speed, 0.01, 50.0, "m/s");
    row("safety_margin", o.safety_margin, 0.0, 1.0, "m");
    row("body_offset", o.body_offset, PointText{20.0});
    row("footprint", o.footprint, PolygonText{20.0});
    row("base_offset", o.base_offset, PointText{20.0});
  }
};

/// Throws std::invalid_argument, naming key, value and range, unless all is in range, the footprint is convex and the wheels lie
/// within the body.
void check(const Robot& robot);

/// Wheel order everywhere: front-left, front-right, rear-left, rear-right.
inline constexpr int kWheels = 4;

/// Position of a wheel's steering axis in the frame of C [m].
struct WheelPosition
{
  double x, y;
};

inline std::array<WheelPosition, kWheels> wheel_positions(const Robot& robot)
{
  const double x = robot.wheelbase / 2, y = robot.track_width / 2;
  return {{{x, y}, {x, -y}, {-x, y}, {-x, -y}}};
}

}  // namespace fourwis
