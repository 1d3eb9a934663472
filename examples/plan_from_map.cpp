// Plans in a map file (map_server's format): plan_from_map config/env4.yaml 1.1,1.1,1.57 10.65,8.75,3.14

#include <cstdio>

#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/planner/planner.h"

using namespace fourwis;

int main(int argc, char** argv)
{
  PlanRequest request;
  const auto read_pose = [](const char* text, Pose& pose) {
    return std::sscanf(text, "%lf,%lf,%lf", &pose.x, &pose.y, &pose.theta) == 3;
  };
  if (argc != 4 || !read_pose(argv[2], request.start) || !read_pose(argv[3], request.goal))
  {
    std::fprintf(stderr, "usage: plan_from_map MAP.yaml START GOAL, each X,Y,YAW in m, m, rad\n");
    return 2;
  }
  try
  {
    const Robot robot;
    const PlannerOptions options;
    const World world(read_map_file(argv[1]), robot, options);
    const PlanResult plan = Planner(options).plan(world, request);
    std::printf("%s: %.2f m in %.2f s, planned in %.1f ms\n", to_string(plan.status), plan.metrics.length,
                plan.metrics.arrival_time, plan.metrics.total_ms);
    if (plan.status == PlanStatus::succeeded) return 0;
    std::printf("%s\n", plan.message.c_str());
    return 1;
  }
  catch (const MapFileError& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
