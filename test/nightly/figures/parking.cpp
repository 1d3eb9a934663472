#include "parking.h"

#include "drawing.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kCell = 0.1;
constexpr double kStreet = 30.0;  ///< length of the places along the street [m]

void park(Drawing& drawing, const Pose& pose, double length = 4.5, double width = 1.8)
{
  drawing.rectangle(pose, length, width);
}

/// Between two cars at the kerb of a street, whose other side has cars as well.
ParkingCase parallel(Random& random, bool leaving)
{
  const double lane = random.between(3.2, 4.5), kerb = 1.0, strip = 2.9, gap = random.between(6.4, 7.4);
  Drawing drawing(kStreet, kerb + strip + lane + strip + kerb, kCell);
  drawing.box(0.0, 0.0, kStreet, kerb);
  drawing.box(0.0, drawing.width() - kerb, kStreet, drawing.width());
  const double low = kerb + strip / 2.0, high = drawing.width() - low;
  const double middle = kStreet / 2.0 + random.between(-2.0, 2.0);
  for (double side : {-1.0, 1.0}) park(drawing, {middle + side * (gap / 2.0 + 2.25), low, 0.0});
  park(drawing, {middle - gap / 2.0 - 8.0, low + 0.1, 0.03});
  for (double x = 4.0; x < kStreet - 2.0; x += random.between(5.5, 8.0)) park(drawing, {x, high, M_PI});
  // With room to the wall behind the kerb: a car that steers both axles swings its rear out.
  const Pose in_gap = {middle, low, 0.0};
  const Pose on_lane = {random.between(4.0, 8.0), kerb + strip + lane / 2.0, 0.0};
  return {"parallel", drawing.grid(), leaving ? in_gap : on_lane, leaving ? on_lane : in_gap};
}

/// A row of bays across a lane, all but one taken; `angle` is that of the bays to the lane.
ParkingCase bays(Random& random, double angle, bool backward)
{
  const double lane = random.between(5.2, 6.8), bay = random.between(2.6, 3.0) / std::sin(angle);
  const double deep = 5.2 * std::sin(angle) + 1.9 * std::cos(angle);
  Drawing drawing(kStreet, 2.0 * deep + lane + 1.0, kCell);
  drawing.frame(0.2);
  const int count = static_cast<int>((kStreet - 6.0) / bay), empty = random.whole(2, count - 3);
  Pose goal;
  for (int k = 0; k < count; ++k)
  {
    const double x = 4.0 + k * bay;
    const Pose lower = {x, 0.5 + deep / 2.0, angle}, upper = {x, drawing.width() - 0.5 - deep / 2.0, -angle};
    const double shift = random.between(-0.1, 0.1), turn = random.between(-0.03, 0.03);
    if (k == empty)
      goal = {lower.x, lower.y, backward ? angle : angle + M_PI};
    else if (random.chance(0.9))
      park(drawing, {lower.x + shift, lower.y, lower.theta + turn});
    if (random.chance(0.8)) park(drawing, {upper.x - shift, upper.y, upper.theta - turn});
  }
  const Pose start = {3.5, drawing.width() / 2.0, 0.0};
  return {angle < M_PI_2 ? "angled"
          : backward     ? "reverse"
                         : "nose_in",
          drawing.grid(),
          start,
          {goal.x, goal.y, wrap_angle(goal.theta)}};
}

/// A dead end to turn round in: a street with a driveway.
ParkingCase turning_round(Random& random)
{
  const double lane = random.between(5.0, 6.0), drive = random.between(3.2, 4.0);
  Drawing drawing(kStreet, lane + 8.0, kCell);
  drawing.box(0.0, 0.0, kStreet, 6.5);
  drawing.box(0.0, 6.5 + lane, kStreet, drawing.width());
  const double x = random.between(12.0, 18.0);
  drawing.opening(x, 1.0, x + drive, 6.6);
  drawing.box(0.0, 0.0, 0.3, drawing.width());
  const double y = 6.5 + lane / 2.0;
  return {"turn_round", drawing.grid(), {4.0, y, 0.0}, {kStreet - 5.0, y, M_PI}};
}

}  // namespace

Robot car()
{
  Robot robot;
  robot.length = 4.689;
  robot.width = 1.942;
  robot.safety_margin = 0.02;
  robot.wheelbase = 2.8;
  robot.track_width = 1.6;
  robot.wheel_max_angle = 2.792526803190927;
  robot.wheel_max_rate = 3.141592653589793;
  robot.wheel_max_speed = 6.0;
  robot.max_steering_angle = 0.75;
  robot.max_steering_rate = 0.5;
  robot.max_speed = 2.5;
  robot.max_acceleration = 1.0;
  robot.mode_switch_time = 0.4;
  return robot;
}

std::vector<ParkingCase> parking_cases(int count)
{
  std::vector<ParkingCase> cases;
  for (int k = 0; k < count; ++k)
  {
    Random random(static_cast<unsigned>(k) + 1);
    switch (k % 7)
    {
      case 0: cases.push_back(parallel(random, false)); break;
      case 1: cases.push_back(bays(random, M_PI_2, true)); break;
      case 2: cases.push_back(bays(random, M_PI / 3.0, false)); break;
      case 3: cases.push_back(parallel(random, true)); break;
      case 4: cases.push_back(bays(random, M_PI_2, false)); break;
      case 5: cases.push_back(bays(random, M_PI / 4.0, true)); break;
      case 6: cases.push_back(turning_round(random)); break;
    }
    cases.back().name = "car_" + cases.back().name + "_seed_" + std::to_string(k + 1);
  }
  return cases;
}

}  // namespace fourwis::nightly
