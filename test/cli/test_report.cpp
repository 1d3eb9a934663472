#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../support/random.h"
#include "cli/report.h"

namespace fourwis
{
namespace
{

using nlohmann::json;
using Keys = std::set<std::string>;

constexpr unsigned kSeed = 20240611;

Keys keys_of(const json& object)
{
  Keys keys;
  for (const auto& item : object.items()) keys.insert(item.key());
  return keys;
}

/// Points of every mode with numbers of every size.
Trajectory random_trajectory(int points)
{
  Random random(kSeed);
  const auto number = [&] {
    const double mantissa = random.unit();
    return mantissa * std::pow(10.0, random.between(-12.0, 6.0));
  };
  Trajectory trajectory(static_cast<std::size_t>(points));
  for (std::size_t i = 0; i < trajectory.size(); ++i)
  {
    TrajectoryPoint& point = trajectory[i];
    point.mode = kPlannedModes[i % kPlannedModes.size()];
    for (double* member : {&point.t, &point.x, &point.y, &point.theta, &point.v, &point.phi, &point.a, &point.omega})
      *member = number();
  }
  return trajectory;
}

json written(const PlanResult& result)
{
  std::ostringstream text;
  write_json(text, result);
  return json::parse(text.str());
}

TEST(Json, HasExactlyTheKeysOfTheContract)
{
  PlanResult result;
  result.trajectory = random_trajectory(7);
  const json document = written(result);
  EXPECT_EQ(keys_of(document),
            (Keys{"status", "message", "metrics", "candidate", "fallback_parts", "overlap_m", "degraded", "points"}));
  EXPECT_EQ(keys_of(document["metrics"]),
            (Keys{"SF", "TL", "AT", "AC", "MC", "TPE", "TYE", "SMR", "CT_ms", "frontend_ms", "backend_ms", "verify_ms",
                  "expansions", "switches", "outer_iterations", "ipopt_iterations", "min_clearance_m"}));
  ASSERT_EQ(document["points"].size(), 7u);
  for (const json& point : document["points"])
    EXPECT_EQ(keys_of(point), (Keys{"t", "mode", "x", "y", "theta", "v", "phi", "a", "omega"}));
}

TEST(Json, SaysWhichCandidateWonAndWhatIsNotAsItShouldBe)
{
  PlanResult result;
  EXPECT_EQ(written(result)["candidate"], "");
  EXPECT_EQ(written(result)["fallback_parts"], 0);
  EXPECT_EQ(written(result)["overlap_m"], 0.0);
  EXPECT_EQ(written(result)["degraded"], false);
  result.candidate = "ackermann by time";
  result.fallback_parts = 2;
  result.overlap = 0.0123;
  result.degraded = true;
  EXPECT_EQ(written(result)["candidate"], "ackermann by time");
  EXPECT_EQ(written(result)["fallback_parts"], 2);
  EXPECT_EQ(written(result)["overlap_m"], 0.0123);
  EXPECT_EQ(written(result)["degraded"], true);
}

TEST(Json, WithoutTrajectoryHasAnEmptyListOfPoints)
{
  const json document = written(PlanResult());
  EXPECT_TRUE(document["points"].is_array());
  EXPECT_TRUE(document["points"].empty());
}

TEST(Json, EveryStatusHasItsName)
{
  const std::vector<std::string> names = {
      "succeeded", "start_in_collision", "goal_in_collision",   "goal_unreachable", "no_path",
      "timeout",   "not_converged",      "verification_failed", "cancelled",        "invalid_input"};
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    PlanResult result;
    result.status = static_cast<PlanStatus>(i);
    EXPECT_EQ(written(result)["status"], names[i]);
  }
}

TEST(Json, EachMetricGoesToItsKey)
{
  PlanResult result;
  PlanMetrics& m = result.metrics;
  m.safe = true;
  double value = 1.5;
  const std::vector<std::pair<const char*, double*>> numbers = {{"TL", &m.length},
                                                                {"AT", &m.arrival_time},
                                                                {"AC", &m.mean_curvature},
                                                                {"MC", &m.max_curvature},
                                                                {"TPE", &m.terminal_position_error},
                                                                {"TYE", &m.terminal_yaw_error},
                                                                {"SMR", &m.standard_mode_rate},
                                                                {"CT_ms", &m.total_ms},
                                                                {"frontend_ms", &m.frontend_ms},
                                                                {"backend_ms", &m.backend_ms},
                                                                {"verify_ms", &m.verify_ms},
                                                                {"min_clearance_m", &m.min_clearance}};
  for (const auto& [key, member] : numbers) *member = value++;
  m.expansions = 101;
  m.switches = 102;
  m.outer_iterations = 103;
  m.ipopt_iterations = 104;

  const json metrics = written(result)["metrics"];
  EXPECT_EQ(metrics["SF"], true);
  for (const auto& [key, member] : numbers) EXPECT_EQ(metrics[key].get<double>(), *member) << key;
  EXPECT_EQ(metrics["expansions"], 101);
  EXPECT_EQ(metrics["switches"], 102);
  EXPECT_EQ(metrics["outer_iterations"], 103);
  EXPECT_EQ(metrics["ipopt_iterations"], 104);
}

void expect_same(const TrajectoryPoint& a, const TrajectoryPoint& b)
{
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.theta, b.theta);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.phi, b.phi);
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.omega, b.omega);
}

TEST(Json, PointsReadBackExactly)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  PlanResult result;
  result.trajectory = random_trajectory(500);
  const json points = written(result)["points"];
  for (std::size_t i = 0; i < result.trajectory.size(); ++i)
  {
    const json& p = points[i];
    expect_same(result.trajectory[i], {p["t"], *mode_from_string(p["mode"]), p["x"], p["y"], p["theta"], p["v"],
                                       p["phi"], p["a"], p["omega"]});
  }
}

TEST(Json, AnyMessageIsEscaped)
{
  PlanResult result;
  result.message = "a \"quoted\"\\ line\n\tand \x01 control";
  EXPECT_EQ(written(result)["message"], result.message);
  result.message = "no UTF-8: \xff\xfe";
  EXPECT_NE(written(result)["message"].get<std::string>().find("no UTF-8: "), std::string::npos);
}

TEST(Json, NumberThatIsNotFiniteIsABug)
{
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    PlanResult result;
    result.metrics.min_clearance = bad;
    std::ostringstream text;
    EXPECT_THROW(write_json(text, result), std::logic_error);
    result.metrics = {};
    result.trajectory = random_trajectory(3);
    result.trajectory[1].omega = bad;
    EXPECT_THROW(write_json(text, result), std::logic_error);
    EXPECT_THROW(write_csv(text, result.trajectory), std::logic_error);
  }
}

std::vector<std::string> split(const std::string& text, char separator)
{
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

TEST(Csv, ReadsBackExactly)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const Trajectory trajectory = random_trajectory(500);
  std::ostringstream text;
  write_csv(text, trajectory);
  const std::vector<std::string> lines = split(text.str(), '\n');
  ASSERT_EQ(lines.size(), trajectory.size() + 1);
  EXPECT_EQ(lines[0], "t,mode,x,y,theta,v,phi,a,omega");
  for (std::size_t i = 0; i < trajectory.size(); ++i)
  {
    const std::vector<std::string> w = split(lines[i + 1], ',');
    ASSERT_EQ(w.size(), 9u) << lines[i + 1];
    const auto number = [&](std::size_t column) { return std::stod(w[column]); };
    expect_same(trajectory[i], {number(0), *mode_from_string(w[1]), number(2), number(3), number(4), number(5),
                                number(6), number(7), number(8)});
  }
}

TEST(Csv, WithoutTrajectoryIsTheHeader)
{
  std::ostringstream text;
  write_csv(text, {});
  EXPECT_EQ(text.str(), "t,mode,x,y,theta,v,phi,a,omega\n");
}

}  // namespace
}  // namespace fourwis
