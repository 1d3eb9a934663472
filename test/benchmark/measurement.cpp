#include "measurement.h"

#include <cerrno>
#include <ctime>
#include <stdexcept>
#include <system_error>

namespace fourwis::benchmark
{
namespace
{

bool same(const PlanResult& a, const PlanResult& b)
{
  return a.status == b.status && a.metrics.expansions == b.metrics.expansions && a.metrics.length == b.metrics.length &&
         a.metrics.arrival_time == b.metrics.arrival_time;
}

}  // namespace

Measurement measure(const Setup& setup, const OccupancyGrid& grid, const Pose& start, const Pose& goal)
{
  const Planner planner(setup.options);
  Measurement measurement;
  for (int run = 0; run < setup.runs; ++run)
  {
    const double begin = cpu_ms();
    const World world(grid, setup.robot, setup.options);
    PlanResult result = planner.plan(world, {start, goal, setup.modes, setup.frontend_only});
    measurement.cpu_ms.push_back(cpu_ms() - begin);
    measurement.map_ms.push_back(result.metrics.map_ms);
    measurement.frontend_ms.push_back(result.metrics.frontend_ms);
    measurement.backend_ms.push_back(result.metrics.backend_ms);
    measurement.verify_ms.push_back(result.metrics.verify_ms);
    const bool by_clock = result.status == PlanStatus::timeout || measurement.result.status == PlanStatus::timeout;
    if (run > 0 && !by_clock && !same(result, measurement.result))
      throw std::logic_error("two runs of one problem differ");
    measurement.result = std::move(result);
  }
  return measurement;
}

double ms_since(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double cpu_ms()
{
  timespec used;
  if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used) != 0)
    throw std::system_error(errno, std::generic_category(), "CLOCK_PROCESS_CPUTIME_ID");
  return 1e3 * static_cast<double>(used.tv_sec) + 1e-6 * static_cast<double>(used.tv_nsec);
}

}  // namespace fourwis::benchmark
