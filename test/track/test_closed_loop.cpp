// Trajectories of the planner for the environments of the project, driven on the simulated base.

#include <gtest/gtest.h>

#include <fstream>

#include "../support/rectangle.h"
#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/planner/planner.h"
#include "simulator_rig.h"

namespace fourwis
{
namespace
{

const std::string kFolder = FOURWIS_SOURCE_DIR "/config/";

struct Environment
{
  std::string id, map;
  Pose start, goal;
};

std::vector<Environment> environments()
{
  std::vector<Environment> all;
  std::ifstream file(kFolder + "environments.csv");
  std::string line;
  std::getline(file, line);  // the header
  while (std::getline(file, line))
  {
    char id[32], map[64];
    Pose s, g;
    if (std::sscanf(line.c_str(), "%31[^;];%63[^;];%lf,%lf,%lf;%lf,%lf,%lf", id, map, &s.x, &s.y, &s.theta, &g.x, &g.y,
                    &g.theta) == 8)
      all.push_back({id, map, s, g});
  }
  return all;
}

struct Errors
{
  double sum = 0.0, most = 0.0;
  int count = 0;

  void add(double error)
  {
    sum += std::abs(error);
    most = std::max(most, std::abs(error));
    ++count;
  }
};

TEST(ClosedLoop, EnvironmentsAreDrivenAsPlanned)
{
  const std::vector<Environment> all = environments();
  ASSERT_EQ(all.size(), 4u);
  for (const Environment& environment : all)
  {
    SCOPED_TRACE(environment.id);
    const OccupancyGrid grid = read_map_file(kFolder + environment.map);
    const Robot robot;
    const PlannerOptions options;
    const PlanResult plan =
        Planner(options).plan(World(grid, robot, options), {environment.start, environment.goal, {}});
    ASSERT_EQ(plan.status, PlanStatus::succeeded) << plan.message;

    const ExactRectangle footprint(grid, robot);
    SimulatorRig rig(environment.start);
    ASSERT_EQ(rig.tracker.accept(plan.trajectory), "");
    Errors lateral, longitudinal;
    double driving = 0.0;
    bool collided = false;
    rig.run(2.0 * plan.trajectory.back().t + 10.0, [&] {
      collided |= footprint.collides(rig.base.pose());
      if (rig.output.state != TrackState::driving) return;
      lateral.add(rig.output.lateral_error);
      longitudinal.add(rig.output.longitudinal_error);
      driving += 0.02;
    });
    EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
    EXPECT_FALSE(collided);
    EXPECT_LE(lateral.sum / lateral.count, 0.005);
    EXPECT_LE(lateral.most, 0.02);
    EXPECT_LE(longitudinal.sum / longitudinal.count, 0.005);
    EXPECT_LE(longitudinal.most, 0.02);
    EXPECT_LE(distance(rig.base.pose(), environment.goal), 0.01);
    EXPECT_LE(std::abs(wrap_angle(rig.base.pose().theta - environment.goal.theta)), 0.5 * M_PI / 180);
    EXPECT_LE(driving, 1.02 * plan.trajectory.back().t);
  }
}

}  // namespace
}  // namespace fourwis
