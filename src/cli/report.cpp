#include "report.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace fourwis
{
namespace
{

using nlohmann::json;

/// The members of a JSON object in the order in which they are written; json itself would sort them.
using Members = std::vector<std::pair<const char*, json>>;

std::string text_of(const char* key, const json& value)
{
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw std::logic_error(std::string("result: '") + key + "' is not finite");
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string object(const Members& members)
{
  std::string text;
  for (const auto& [key, value] : members)
    text += (text.empty() ? "{" : ", ") + json(key).dump() + ": " + text_of(key, value);
  return text + "}";
}

std::string metrics_object(const PlanMetrics& metrics)
{
  return object({{"SF", metrics.safe},
                 {"TL", metrics.length},
                 {"AT", metrics.arrival_time},
                 {"AC", metrics.mean_curvature},
                 {"MC", metrics.max_curvature},
                 {"TPE", metrics.terminal_position_error},
                 {"TYE", metrics.terminal_yaw_error},
                 {"SMR", metrics.standard_mode_rate},
                 {"CT_ms", metrics.total_ms},
                 {"frontend_ms", metrics.frontend_ms},
                 {"backend_ms", metrics.backend_ms},
                 {"verify_ms", metrics.verify_ms},
                 {"expansions", metrics.expansions},
                 {"switches", metrics.switches},
                 {"outer_iterations", metrics.outer_iterations},
                 {"ipopt_iterations", metrics.ipopt_iterations},
                 {"min_clearance_m", metrics.min_clearance}});
}

Members members_of(const TrajectoryPoint& point)
{
  return {{"t", point.t},         {"mode", to_string(point.mode)},
          {"x", point.x},         {"y", point.y},
          {"theta", point.theta}, {"v", point.v},
          {"phi", point.phi},     {"a", point.a},
          {"omega", point.omega}};
}

}  // namespace

void write_json(std::ostream& out, const PlanResult& result)
{
  out << "{\"status\": " << text_of("status", to_string(result.status)) << ",\n"
      << " \"message\": " << text_of("message", result.message) << ",\n"
      << " \"metrics\": " << metrics_object(result.metrics) << ",\n"
      << " \"candidate\": " << text_of("candidate", result.candidate) << ",\n"
      << " \"fallback_parts\": " << result.fallback_parts << ",\n"
      << " \"overlap_m\": " << text_of("overlap_m", result.overlap) << ",\n"
      << " \"degraded\": " << text_of("degraded", result.degraded) << ",\n"
      << " \"points\": [";
  const char* separator = "\n  ";
  for (const TrajectoryPoint& point : result.trajectory)
  {
    out << separator << object(members_of(point));
    separator = ",\n  ";
  }
  out << "]}\n";
}

void write_csv(std::ostream& out, const Trajectory& trajectory)
{
  out << "t,mode,x,y,theta,v,phi,a,omega\n";
  for (const TrajectoryPoint& point : trajectory)
  {
    const char* separator = "";
    for (const auto& [key, value] : members_of(point))
    {
      // The shortest digits that read back to the same number; names without quotes.
      out << separator << (value.is_string() ? value.get<std::string>() : text_of(key, value));
      separator = ",";
    }
    out << '\n';
  }
}

}  // namespace fourwis
