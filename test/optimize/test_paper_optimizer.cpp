#include "fourwis_navigation/optimize/paper_optimizer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <limits>
#include <stdexcept>

#include "fourwis_navigation/segment/segment.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "optimize/paper_problem.h"

namespace fourwis
{
namespace
{

constexpr double kSpeed = 1.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A gentle bend of 4 m in a corridor of boxes of half side `reach` around the disc centres.
struct Bend
{
  explicit Bend(const Robot& robot, Mode mode, double reach = 0.3)
  {
    Path path;
    path.pieces = {{mode, {1.0, 2.0, 0.5}, 0.2, 4.0}};
    path.goal = advance(robot, path.pieces[0].start, mode, 0.2, 4.0);
    segment = split_at_switches(path, robot, 0.2).at(0);
    for (const Pose& knot : segment.knots)
    {
      boxes.front.push_back(around(compose(knot, {robot.length / 4.0, 0.0, 0.0}), reach));
      boxes.rear.push_back(around(compose(knot, {-robot.length / 4.0, 0.0, 0.0}), reach));
    }
  }

  static Box around(const Pose& centre, double reach)
  {
    return {centre.x - reach, centre.y - reach, centre.x + reach, centre.y + reach};
  }

  Segment segment;
  BoxCorridor boxes;
};

/// The paper's J (26) with the disc centres where they do best.
double paper_cost(const Trajectory& points, const BoxCorridor& boxes, const Robot& robot, const PaperOptions& options)
{
  const double duration = points.back().t, h = duration / static_cast<double>(points.size() - 1);
  double cost = duration + options.penalty * paper_infeasibility(points, boxes, robot);
  for (const TrajectoryPoint& p : points) cost += options.steering_comfort * p.v * p.omega * p.v * p.omega * h;
  return cost;
}

struct PaperOptimizerTest : testing::TestWithParam<Mode>
{
  PaperSolution solve(const Bend& bend, const Trajectory* previous = nullptr, const Interrupt& interrupt = {}) const
  {
    return PaperOptimizer(robot, options, kSpeed).solve(bend.segment, bend.boxes, previous, interrupt);
  }

  /// A bend with something changed is no problem.
  void expect_refused(const std::function<void(Bend&)>& change) const
  {
    Bend bend(robot, GetParam());
    change(bend);
    const PaperSolution solution = solve(bend);
    EXPECT_EQ(solution.status, NlpStatus::invalid_problem);
    EXPECT_TRUE(solution.points.empty());
  }

  const Robot robot;
  PaperOptions options;
};

TEST_P(PaperOptimizerTest, DrivesThroughItsBoxesKeepingLimitsAndEnds)
{
  const Bend bend(robot, GetParam());
  const PaperSolution solution = solve(bend);
  ASSERT_EQ(solution.status, NlpStatus::solved);
  EXPECT_LT(solution.infeasibility, 1e-6);
  EXPECT_GT(solution.iterations, 0);
  EXPECT_GT(solution.duration(), distance(bend.segment.knots.front(), bend.segment.knots.back()) / kSpeed);
  EXPECT_LT(solution.duration(), 6.0 / kSpeed);

  const std::size_t n = bend.segment.intervals();
  ASSERT_EQ(solution.points.size(), n + 1);
  for (std::size_t k : {std::size_t{0}, n})
  {
    const Pose& pose = bend.segment.knots[k];
    const TrajectoryPoint& p = solution.points[k];
    EXPECT_EQ(p.x, pose.x);
    EXPECT_EQ(p.y, pose.y);
    EXPECT_EQ(p.theta, pose.theta);
    EXPECT_EQ(p.v, 0.0);
    EXPECT_EQ(p.phi, bend.segment.phi.front());
  }
  const double most_phi = GetParam() == Mode::parallel ? robot.wheel_max_angle : robot.max_steering_angle;
  for (std::size_t k = 0; k <= n; ++k)
  {
    const TrajectoryPoint& p = solution.points[k];
    EXPECT_EQ(p.mode, GetParam());
    EXPECT_NEAR(p.t, solution.duration() * static_cast<double>(k) / static_cast<double>(n), 1e-12);
    EXPECT_LE(std::abs(p.v), kSpeed + 1e-6);
    EXPECT_LE(std::abs(p.phi), most_phi + 1e-6);
    EXPECT_LE(std::abs(p.a), robot.max_acceleration + 1e-6);
    EXPECT_LE(std::abs(p.omega), robot.max_steering_rate + 1e-6);
    const Pose front = compose(p.pose(), {robot.length / 4.0, 0.0, 0.0});
    const Box& box = bend.boxes.front[k];
    EXPECT_TRUE(front.x > box.x_min - 1e-3 && front.x < box.x_max + 1e-3 && front.y > box.y_min - 1e-3 &&
                front.y < box.y_max + 1e-3)
        << "knot " << k;
  }
}

TEST_P(PaperOptimizerTest, LiftedFormEndsAtAStationaryPointOfThePapers)
{
  options.penalty = 1e4;  // differences cannot resolve more
  options.tolerance = 1e-9;
  const Bend bend(robot, GetParam());
  const PaperSolution solution = solve(bend);
  ASSERT_EQ(solution.status, NlpStatus::solved);
  const auto slope = [&](const std::function<void(Trajectory&, double)>& move) {
    constexpr double kStep = 1e-8;
    Trajectory up = solution.points, down = solution.points;
    move(up, kStep);
    move(down, -kStep);
    return (paper_cost(up, bend.boxes, robot, options) - paper_cost(down, bend.boxes, robot, options)) / (2.0 * kStep);
  };
  const double tolerance = 0.002;  // the slope of T alone is 1
  for (std::size_t k = 1; k < bend.segment.intervals(); ++k)
  {
    SCOPED_TRACE(k);
    EXPECT_NEAR(slope([k](Trajectory& points, double step) { points[k].x += step; }), 0.0, tolerance);
    EXPECT_NEAR(slope([k](Trajectory& points, double step) { points[k].y += step; }), 0.0, tolerance);
    EXPECT_NEAR(slope([k](Trajectory& points, double step) { points[k].theta += step; }), 0.0, tolerance);
  }
  const auto stretch = [](Trajectory& points, double step) {
    const double factor = 1.0 + step / points.back().t;
    for (TrajectoryPoint& p : points) p.t *= factor;
  };
  EXPECT_NEAR(slope(stretch), 0.0, tolerance);
}

TEST_P(PaperOptimizerTest, StaysWhereItHasBeen)
{
  const Bend bend(robot, GetParam());
  const PaperSolution first = solve(bend);
  const PaperSolution second = solve(bend, &first.points);
  ASSERT_EQ(second.status, NlpStatus::solved);
  EXPECT_NEAR(second.duration(), first.duration(), 1e-4);
  EXPECT_LT(second.infeasibility, 1e-6);
}

TEST_P(PaperOptimizerTest, SoftensBoxesThatDoNotHoldTheReference)
{
  Bend bend(robot, GetParam());
  for (std::vector<Box>* boxes : {&bend.boxes.front, &bend.boxes.rear})
    (*boxes)[10] = Bend::around({-5.0, -5.0, 0.0}, 0.3);
  const PaperSolution solution = solve(bend);
  ASSERT_EQ(solution.points.size(), bend.segment.knots.size());
  EXPECT_GT(solution.infeasibility, 1e-3);
  EXPECT_NEAR(solution.infeasibility, paper_infeasibility(solution.points, bend.boxes, robot), 1e-12);
}

TEST_P(PaperOptimizerTest, StopsWhenInterrupted)
{
  const Bend bend(robot, GetParam());
  const std::atomic<bool> cancelled{true};
  const PaperSolution solution = solve(bend, nullptr, Interrupt(&cancelled));
  EXPECT_EQ(solution.status, NlpStatus::interrupted);
  EXPECT_EQ(solution.points.size(), bend.segment.knots.size());
}

TEST_P(PaperOptimizerTest, RefusesWhatMakesNoSense)
{
  expect_refused([](Bend& b) { b.segment = {}; });
  expect_refused([](Bend& b) { b.segment.mode = Mode::none; });
  expect_refused([](Bend& b) { b.segment.knots.pop_back(); });
  expect_refused([](Bend& b) { b.boxes.rear.pop_back(); });
  expect_refused([](Bend& b) { b.segment.length.assign(b.segment.length.size(), 0.0); });
  expect_refused([](Bend& b) { std::swap(b.boxes.front[3].x_min, b.boxes.front[3].x_max); });
  for (double bad : {kNaN, kInfinity})
  {
    expect_refused([bad](Bend& b) { b.segment.knots[0].y = bad; });
    expect_refused([bad](Bend& b) { b.segment.knots[4].theta = bad; });
    expect_refused([bad](Bend& b) { b.segment.phi.back() = bad; });
    expect_refused([bad](Bend& b) { b.segment.length[1] = bad; });
  }
  expect_refused([](Bend& b) { b.boxes.rear[2].y_max = kNaN; });
  const Trajectory short_one(3);
  EXPECT_EQ(solve(Bend(robot, GetParam()), &short_one).status, NlpStatus::invalid_problem);
}

TEST(PaperOptions, OutOfRangeAreRefusedByName)
{
  const Robot robot;
  const auto expect_refused = [&](const std::string& name, const std::function<void(PaperOptions&)>& change,
                                  double speed = kSpeed) {
    PaperOptions options;
    change(options);
    try
    {
      PaperOptimizer(robot, options, speed);
      ADD_FAILURE() << name << " was accepted";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  expect_refused("steering_comfort", [](PaperOptions& o) { o.steering_comfort = -1.0; });
  expect_refused("penalty", [](PaperOptions& o) { o.penalty = kNaN; });
  expect_refused("tolerance", [](PaperOptions& o) { o.tolerance = 0.0; });
  expect_refused("max_iterations", [](PaperOptions& o) { o.max_iterations = -1; });
  for (double speed : {0.0, kNaN, kInfinity})
    expect_refused(
        "reference_speed", [](PaperOptions&) {}, speed);
}

TEST(PaperInfeasibility, IsTheSumOfBothDefects)
{
  const Robot robot;
  Trajectory points(3);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    points[k].mode = Mode::ackermann;
    points[k].t = 0.5 * static_cast<double>(k);
    points[k].v = 1.0;
    points[k].x = points[k].t;
  }
  BoxCorridor boxes;
  boxes.front = boxes.rear = std::vector<Box>(3, Box{-9.0, -9.0, 9.0, 9.0});
  EXPECT_NEAR(paper_infeasibility(points, boxes, robot), 0.0, 1e-30);
  boxes.front[1].x_max = 0.5 + robot.length / 4.0 - 0.2;
  EXPECT_NEAR(paper_infeasibility(points, boxes, robot), 0.2 * 0.2 * 0.5, 1e-12);
  points[2].y = 0.1;
  EXPECT_NEAR(paper_infeasibility(points, boxes, robot), 0.2 * 0.2 * 0.5 + 0.1 * 0.1, 1e-12);
  EXPECT_EQ(paper_infeasibility({}, boxes, robot), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Modes, PaperOptimizerTest, testing::ValuesIn(kPlannedModes),
                         [](const auto& given) { return std::string(to_string(given.param)); });

}  // namespace
}  // namespace fourwis
