#include "answer.h"

#include <ctime>
#include <iomanip>
#include <sstream>

#include "../../support/random.h"
#include "../driven_body.h"
#include "exact_body.h"
#include "forked.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kPatience = 300.0;                        ///< [s]
constexpr double kEndGap = 0.001, kEndHeadingGap = 0.001;  ///< of a trajectory's ends [m], [rad]

double cpu_seconds()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

bool are_same(const Pose& a, const Pose& b)
{
  return distance(a, b) <= kEndGap && heading_gap(a.theta, b.theta) <= kEndHeadingGap;
}

/// A body that overlaps a little at the start, as an answer may say, is free from where it first is.
std::string violation_in(const Question& question, const PlanResult& result, const ObstacleRule& rule)
{
  if (result.status != PlanStatus::succeeded) return {};
  Trajectory trajectory = result.trajectory;
  if (trajectory.empty()) return "there is no trajectory";
  if (!are_same(trajectory.front().pose(), question.start)) return "it starts elsewhere";
  if (!are_same(trajectory.back().pose(), question.goal)) return "it ends elsewhere";
  const ExactBody body(*question.grid, rule, question.robot);
  for (TrajectoryPoint& point : trajectory)
  {
    const Pose centre = body.centre_of(point.pose());
    point.x = centre.x;
    point.y = centre.y;
  }
  bool was_free = !(result.overlap > 0.0);
  return fault_in_drive(trajectory, question.robot, [&](const Pose& pose) {
    const bool overlaps = body.overlaps(pose);
    was_free = was_free || !overlaps;
    return overlaps && was_free;
  });
}

std::string to_line(const Answer& answer)
{
  std::ostringstream out;
  out << std::setprecision(17) << std::quoted(answer.status) << ' ' << std::quoted(answer.message) << ' ' << answer.cpu
      << ' ' << answer.arrival << ' ' << answer.length << ' ' << answer.fallback_parts << ' ' << answer.degraded << ' '
      << std::quoted(answer.violation);
  return out.str();
}

Answer from_line(const std::string& line)
{
  Answer answer;
  std::istringstream in(line);
  in >> std::quoted(answer.status) >> std::quoted(answer.message) >> answer.cpu >> answer.arrival >> answer.length >>
      answer.fallback_parts >> answer.degraded >> std::quoted(answer.violation);
  return answer;
}

}  // namespace

Answer ask(const Question& question)
{
  PlannerOptions options;
  options.planner_patience = kPatience;
  PlanRequest request;
  request.start = question.start;
  request.goal = question.goal;
  request.modes = question.modes;
  const double begin = cpu_seconds();
  const World world(*question.grid, question.robot, options);
  const PlanResult result = Planner(options, 1).plan(world, request);
  Answer answer;
  answer.cpu = cpu_seconds() - begin;
  answer.status = to_string(result.status);
  answer.message = result.message;
  answer.arrival = result.metrics.arrival_time;
  answer.length = result.metrics.length;
  answer.fallback_parts = result.fallback_parts;
  answer.degraded = result.degraded;
  answer.violation = violation_in(question, result, options.obstacles);
  return answer;
}

std::vector<Answer> ask_all(const std::vector<Question>& questions)
{
  std::vector<Answer> answers(questions.size());
  in_child(
      questions.size(), [&](std::size_t k) { return to_line(ask(questions[k])); },
      [&](std::size_t k, const std::string& line) { answers[k] = from_line(line); }, [](std::size_t) {});
  return answers;
}

std::string described(const Question& question)
{
  return question.name + " " + text(question.start) + " to " + text(question.goal) + ", " + text(question.modes);
}

}  // namespace fourwis::nightly
