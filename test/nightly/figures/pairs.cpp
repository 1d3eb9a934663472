// Random pairs of poses of the default robot, held against floods of the exact rectangle.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "../../support/random.h"
#include "figures.h"
#include "fourwis_navigation/map/map_file.h"
#include "maps.h"
#include "truth.h"

namespace fourwis::nightly
{
namespace
{

constexpr int kPairs = 3000;
constexpr int kMapsOfAKind = 6;
constexpr int kTimedMaps = 20;   ///< "20 small and medium maps": the first of each kind, then of the others
constexpr double kWindow = 7.0;  ///< side of what is taken of a greater third-party map [m]
constexpr double kSlow = 1.5;    ///< a case of its own from here on [s]

struct NamedMap
{
  std::string name;
  OccupancyGrid grid;
};

/// A part of a map, as floods of whole buildings take too long.
OccupancyGrid window(const OccupancyGrid& grid, Random& random)
{
  const int cells = static_cast<int>(kWindow / grid.resolution);
  OccupancyGrid part = grid;
  part.origin = {};
  part.width = std::min(grid.width, cells);
  part.height = std::min(grid.height, cells);
  const int left = random.whole(0, grid.width - part.width), bottom = random.whole(0, grid.height - part.height);
  part.data.clear();
  for (int row = 0; row < part.height; ++row)
    for (int column = 0; column < part.width; ++column) part.data.push_back(grid.at(left + column, bottom + row));
  return part;
}

int count_if_free(const OccupancyGrid& grid)
{
  const ObstacleRule rule;
  return static_cast<int>(
      std::count_if(grid.data.begin(), grid.data.end(), [&](std::int8_t cell) { return !rule.is_obstacle(cell); }));
}

/// A window of which at least a third is free.
OccupancyGrid free_window(const OccupancyGrid& grid, Random& random)
{
  for (int trial = 0;; ++trial)
  {
    const OccupancyGrid part = window(grid, random);
    if (trial > 100 || 3 * count_if_free(part) >= part.width * part.height) return part;
  }
}

std::vector<NamedMap> third_party_maps(const Figures& figures)
{
  std::vector<NamedMap> maps;
  for (const char* file : {"bit_4wis/maze", "bit_4wis/parking", "bit_4wis/reference_parking", "bit_4wis/tight_complex",
                           "mppi_swerve/maze", "mppi_swerve/cylinder_garden", "nav2/warehouse", "nav2/depot",
                           "nav2/tb3_sandbox", "nav2/100by100_10", "nav2/100by100_20"})
  {
    const std::string path = std::string("maps/") + file + ".yaml";
    if (!figures.finds(path)) continue;
    Random random(static_cast<unsigned>(maps.size()) + 1);
    std::string name = file;
    std::replace(name.begin(), name.end(), '/', '_');
    maps.push_back({name, free_window(read_map_file(figures.beside + "/" + path), random)});
  }
  return maps;
}

std::vector<NamedMap> all_maps(const Figures& figures)
{
  std::vector<NamedMap> maps;
  const int of_a_kind = figures.part_of(kMapsOfAKind);
  for (int k = 0; k < of_a_kind; ++k)
    for (std::size_t kind = 0; kind < map_kinds().size(); ++kind)
    {
      const unsigned seed = 100 * static_cast<unsigned>(kind) + static_cast<unsigned>(k) + 1;
      Random random(seed);
      maps.push_back({map_kinds()[kind].name + ("_seed_" + std::to_string(seed)), map_kinds()[kind].draw(random, 1.0)});
    }
  // After the first of each kind, as a run may be stopped.
  std::vector<NamedMap> others = third_party_maps(figures);
  maps.insert(maps.begin() + static_cast<std::ptrdiff_t>(map_kinds().size()), others.begin(), others.end());
  return maps;
}

/// What became of the pairs of one verdict.
using Counts = std::map<std::string, int>;

int sum(const Counts& counts)
{
  int all = 0;
  for (const auto& [status, count] : counts) all += count;
  return all;
}

int count_of(const Counts& counts, PlanStatus status)
{
  const auto found = counts.find(to_string(status));
  return found == counts.end() ? 0 : found->second;
}

std::string listed(const Counts& counts)
{
  std::string text;
  for (const auto& [status, count] : counts) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + status;
  return text.empty() ? "none" : text;
}

/// The longest arcs with which a pair can be done without turning in place.
std::string arcs_of(const Pair& pair)
{
  for (std::size_t k = kShunts.size(); k-- > 0;)
    if (pair.without_spin[k]) return " by arcs of " + std::to_string(kShunts[k]) + " degrees";
  return " with spin only";
}

class PairFigures
{
public:
  explicit PairFigures(const Figures& figures) : figures_(figures) {}

  void add(const Pair& pair, const Question& question, const Answer& answer, bool timed)
  {
    wrongs_.count(question, answer, figures_.cases);
    all_times_.push_back(answer.cpu);
    if (timed) timed_.push_back(answer.cpu);
    ++verdicts_[to_string(pair.verdict)];
    const bool unreachable = answer.status == to_string(PlanStatus::goal_unreachable);
    std::string why;
    switch (pair.verdict)
    {
      case Verdict::with_margin:
        ++(pair.discs_can ? discs_can_ : tight_)[answer.status];
        if (!pair.discs_can) count_ceilings(pair);
        false_unreachable_ += unreachable ? 1 : 0;
        if (!answer.succeeded()) why = (unreachable ? "FALSE goal_unreachable" : "can, with margin") + arcs_of(pair);
        break;
      case Verdict::bare_only:
        ++(pair.end_is_tight ? tight_end_ : bare_)[answer.status];
        if (unreachable && answer.message.find("margin") == std::string::npos) ++unnamed_margin_;
        if (!answer.succeeded() && !unreachable) why = "can without margin only";
        break;
      case Verdict::impossible:
        ++impossible_[answer.status];
        if (answer.succeeded())
        {
          ++contradictions_;
          why = "SUCCEEDED though no flood can";
        }
        break;
      case Verdict::undecided: ++undecided_[answer.status]; break;
    }
    if (!why.empty())
      figures_.cases.add(why + (pair.discs_can ? ", discs can" : ""), question, answer);
    else if (answer.cpu > kSlow)
      figures_.cases.add(std::string("slow, ") + to_string(pair.verdict), question, answer);
  }

  void add_rows() const
  {
    using Weight = Rows::Weight;
    Rows& rows = figures_.rows;
    rows.note("random pairs, default robot: what floods say", listed(verdicts_));
    const int tight = sum(tight_), solved = count_of(tight_, PlanStatus::succeeded);
    rows.add("solved of those that the rectangle with its margin can do, not the discs", ">= 95 %",
             share(solved, tight) + ": " + listed(tight_), solved >= 0.95 * tight, Weight::goal);
    for (std::size_t k = 0; k < kShunts.size(); ++k)
      rows.note("of these: a flood without turning in place, by tightest arcs of " + std::to_string(kShunts[k]) +
                    " degrees or more",
                share(ceilings_[k], tight));
    rows.add("solved of those that the discs can do, too", "all",
             share(count_of(discs_can_, PlanStatus::succeeded), sum(discs_can_)) + ": " + listed(discs_can_),
             count_of(discs_can_, PlanStatus::succeeded) == sum(discs_can_), Weight::goal);
    rows.add("of those that only the bare rectangle can do, start or goal tight",
             "solved, or goal_unreachable where the way is tight as well", listed(tight_end_), only_good(tight_end_),
             Weight::goal);
    rows.add("the same, the way is tight", "goal_unreachable naming the margin, or solved",
             listed(bare_) + "; margin not named: " + std::to_string(unnamed_margin_),
             only_good(bare_) && unnamed_margin_ == 0, Weight::goal);
    rows.note("not even the bare rectangle can", listed(impossible_));
    rows.note("undecided by the floods", listed(undecided_));
    wrongs_.add_row("random pairs", rows);
    rows.add("random pairs: false goal_unreachable; succeeded though it cannot be", "0; 0",
             std::to_string(false_unreachable_) + "; " + std::to_string(contradictions_),
             false_unreachable_ + contradictions_ == 0, Weight::wrong);
    rows.add("CPU p50 / p95 / p99 / max, all pairs of " + std::to_string(kTimedMaps) + " small and medium maps",
             "15 / 150 / 600 / 1500 ms", percentiles(timed_) + ", " + std::to_string(timed_.size()) + " pairs",
             percentiles_hold(timed_, 0.015, 0.150, 0.600, 1.500), Weight::goal);
    rows.note("the same, all maps", percentiles(all_times_) + ", " + std::to_string(all_times_.size()) + " pairs");
  }

private:
  void count_ceilings(const Pair& pair)
  {
    for (std::size_t k = 0; k < kShunts.size(); ++k) ceilings_[k] += pair.without_spin[k] ? 1 : 0;
  }

  static bool only_good(const Counts& counts)
  {
    return count_of(counts, PlanStatus::succeeded) + count_of(counts, PlanStatus::goal_unreachable) == sum(counts);
  }

  const Figures& figures_;
  Wrongs wrongs_;
  Counts verdicts_, tight_, discs_can_, tight_end_, bare_, impossible_, undecided_;
  std::array<int, kShunts.size()> ceilings_ = {};
  int false_unreachable_ = 0, contradictions_ = 0, unnamed_margin_ = 0;
  std::vector<double> timed_, all_times_;
};

}  // namespace

void random_pairs_of_the_default_robot(const Figures& figures)
{
  const std::vector<NamedMap> maps = all_maps(figures);
  const int of_a_map = (figures.part_of(kPairs) + static_cast<int>(maps.size()) - 1) / static_cast<int>(maps.size());
  const Robot robot;
  PairFigures pairs_figures(figures);
  for (std::size_t k = 0; k < maps.size() && !Figures::stopped(); ++k)
  {
    Random random(1000 + static_cast<unsigned>(k));
    std::vector<Pair> pairs = random_pairs(maps[k].grid, robot, random, of_a_map);
    judge(maps[k].grid, robot, pairs);
    std::vector<Question> questions;
    for (const Pair& pair : pairs)
      questions.push_back({maps[k].name + "#" + std::to_string(questions.size()), &maps[k].grid, robot, pair.start,
                           pair.goal, ModeSet()});
    const std::vector<Answer> answers = ask_all(questions);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      pairs_figures.add(pairs[i], questions[i], answers[i], k < kTimedMaps);
    std::cout << "map " << k + 1 << " of " << maps.size() << ", " << maps[k].name << std::endl;
  }
  pairs_figures.add_rows();
}

}  // namespace fourwis::nightly
