// Random robots: what holds for one must hold for all, and more modes must never make a robot slower.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>

#include "../../support/exact_polygon.h"
#include "exact_body.h"
#include "figures.h"
#include "maps.h"

namespace fourwis::nightly
{
namespace
{

constexpr int kRobots = 60;
constexpr int kProblems = 10;     ///< of each robot, on two maps
constexpr double kSlower = 0.01;  ///< share of the arrival time that counts

/// A convex outline of 4 to 10 corners around the wheels.
void give_polygon(Robot& robot, Random& random)
{
  const double wheels = std::hypot(robot.wheelbase, robot.track_width) / 2.0;
  const int sides = random.whole(4, 10);
  const double turn = random.angle(), reach = wheels * random.between(1.02, 1.2) / std::cos(M_PI / sides);
  for (int k = 0; k < sides; ++k)
  {
    const double angle = turn + 2.0 * M_PI * k / sides, nose = std::cos(angle) > 0.0 ? 1.2 : 1.0;
    robot.footprint.push_back(
        {robot.base_offset.x + nose * reach * std::cos(angle), robot.base_offset.y + reach * std::sin(angle)});
  }
}

Robot any_robot(Random& random)
{
  Robot robot;
  robot.length = 0.3 * std::pow(5.0 / 0.3, random.between(0.0, 1.0));
  robot.width = robot.length * random.between(0.4, 1.0);
  robot.wheelbase = robot.length * random.between(0.4, 0.85);
  robot.track_width = robot.width * random.between(0.5, 0.9);
  robot.max_steering_angle = M_PI / 180.0 * random.between(10.0, 80.0);
  robot.wheel_max_angle = M_PI / 180.0 * random.between(41.0, 180.0);
  robot.max_steering_rate = random.between(0.3, M_PI);
  robot.wheel_max_rate = random.between(1.0, M_PI);
  robot.max_speed = random.between(0.3, 2.5);
  robot.max_acceleration = random.between(0.5, 5.0);
  robot.wheel_max_speed = robot.max_speed * random.between(1.0, 3.0);
  robot.mode_switch_time = random.between(0.0, 1.0);
  robot.safety_margin = random.between(0.0, std::min(0.3, 0.15 * robot.width));
  switch (random.whole(0, 3))
  {
    case 0: break;
    case 1: robot.body_offset = {0.05 * robot.length * random.unit(), 0.02 * robot.width * random.unit()}; break;
    case 2: robot.base_offset = {0.4 * robot.length * random.unit(), 0.1 * robot.width * random.unit()}; break;
    case 3:
      robot.base_offset = {0.4 * robot.length * random.unit(), 0.0};
      give_polygon(robot, random);
      break;
  }
  return robot;
}

/// One that check() takes.
Robot random_robot(Random& random)
{
  for (;;) try
    {
      const Robot robot = any_robot(random);
      check(robot);
      return robot;
    }
    catch (const std::invalid_argument&)
    {}
}

/// How many times as big as the default robot the maps must be.
double scale_of(const Robot& robot)
{
  return std::max(robot.body_length() + 2.0 * robot.safety_margin,
                  (robot.body_width() + 2.0 * robot.safety_margin) / 0.62);
}

/// A pose of base_link at which the body is free.
Pose random_free_pose(const OccupancyGrid& grid, const Robot& robot, Random& random)
{
  const ExactBody body(grid, {}, robot);
  for (int trial = 0;; ++trial)
  {
    const Pose pose = {random.between(0.0, grid.width * grid.resolution),
                       random.between(0.0, grid.height * grid.resolution), random.angle()};
    if (!body.overlaps(body.centre_of(pose)) || trial > 100000) return pose;
  }
}

/// How all modes compare with the best of fewer.
class Comparison
{
public:
  void add(const std::vector<Question>& questions, const std::vector<Answer>& answers, CaseBook& cases)
  {
    const Answer& all = answers.front();
    ++problems_;
    solved_ += all.succeeded() ? 1 : 0;
    const Answer* best = nullptr;
    std::size_t which = 0;
    for (std::size_t k = 1; k < answers.size(); ++k)
      if (answers[k].succeeded() && (best == nullptr || answers[k].arrival < best->arrival))
      {
        best = &answers[k];
        which = k;
      }
    if (best == nullptr) return;
    if (!all.succeeded())
    {
      ++refused_;
      cases.add("all modes find nothing, " + text(questions[which].modes) + " arrives in " + seconds(best->arrival),
                questions.front(), all);
      return;
    }
    ++compared_;
    const double slower = best->arrival > 0.0 ? all.arrival / best->arrival - 1.0 : 0.0;
    worst_ = std::max(worst_, slower);
    if (slower <= kSlower) return;
    ++slower_;
    cases.add("all modes " + seconds(all.arrival) + ", " + text(questions[which].modes) + " " + seconds(best->arrival),
              questions.front(), all);
  }

  void add_rows(Rows& rows) const
  {
    rows.note("random robots: solved with all modes", share(solved_, problems_));
    rows.add("random robots: all modes slower than the best subset by more than 1 %", "never",
             share(slower_, compared_) + ", worst by " + std::to_string(std::lround(100.0 * worst_)) + " %",
             slower_ == 0, Rows::Weight::goal);
    rows.add("random robots: all modes find nothing where a subset does", "never", share(refused_, problems_),
             refused_ == 0, Rows::Weight::goal);
  }

private:
  static std::string seconds(double time)
  {
    char text[40];
    std::snprintf(text, sizeof text, "%.2f s", time);
    return text;
  }

  int problems_ = 0, solved_ = 0, compared_ = 0, slower_ = 0, refused_ = 0;
  double worst_ = 0.0;
};

}  // namespace

void random_robots(const Figures& figures)
{
  Wrongs wrongs;
  Comparison comparison;
  std::vector<double> times;
  const int robots = figures.part_of(kRobots);
  for (int k = 0; k < robots && !Figures::stopped(); ++k)
  {
    Random random(static_cast<unsigned>(k) + 1);
    const Robot robot = random_robot(random);
    for (int map = 0; map < 2; ++map)
    {
      const MapKind& kind = map_kinds()[static_cast<std::size_t>(2 * k + map) % map_kinds().size()];
      const OccupancyGrid grid = kind.draw(random, scale_of(robot));
      for (int problem = 0; problem < kProblems / 2; ++problem)
      {
        const Pose start = random_free_pose(grid, robot, random), goal = random_free_pose(grid, robot, random);
        const std::string name = "robot_" + std::to_string(k + 1) + "_" + kind.name + "#" + std::to_string(problem);
        std::vector<Question> questions{{name, &grid, robot, start, goal, ModeSet()}};
        for (const ModeSet& modes : all_mode_sets())
          if (modes != ModeSet()) questions.push_back({name, &grid, robot, start, goal, modes});
        const std::vector<Answer> answers = ask_all(questions);
        for (std::size_t i = 0; i < answers.size(); ++i) wrongs.count(questions[i], answers[i], figures.cases);
        times.push_back(answers.front().cpu);
        comparison.add(questions, answers, figures.cases);
      }
    }
    std::cout << "robot " << k + 1 << " of " << robots << std::endl;
  }
  wrongs.add_row("random robots", figures.rows);
  comparison.add_rows(figures.rows);
  figures.rows.note("random robots: CPU p50 / p95 / p99 / max, all modes", percentiles(times));
}

}  // namespace fourwis::nightly
