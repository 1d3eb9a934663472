#include "truth.h"

#include <algorithm>
#include <cmath>

#include "exact_body.h"
#include "lattice_flood.h"

namespace fourwis::nightly
{
namespace
{

/// Each has the poses of those before it. Only what one leaves open is asked of the next.
constexpr Lattice kLattices[] = {{0.02, 90}, {0.01, 180}, {0.005, 360}};
constexpr double kMostPoses = 8e8;  ///< of a lattice: 100 MB, and three of them are held at once

double poses_of(const Lattice& lattice, const OccupancyGrid& grid)
{
  const double r = grid.resolution / lattice.step;
  return grid.width * r * grid.height * r * lattice.headings;
}

/// Asks one flood about all pairs that are still open.
class OpenPairs
{
public:
  OpenPairs(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot, std::vector<Pair*> open)
    : grid_(grid),
      lattice_(lattice),
      robot_(robot),
      open_(std::move(open))
  {
    for (const Pair* pair : open_)
    {
      poses_.push_back(pair->start);
      poses_.push_back(pair->goal);
    }
  }

  FreePoses rectangle(double margin, FreePoses::Edge edge) const
  {
    return FreePoses::of_rectangle(grid_, lattice_, robot_, margin, edge);
  }
  FreePoses discs() const { return FreePoses::of_discs(grid_, lattice_, robot_); }

  /// Whether it joins start and goal of each of the pairs.
  std::vector<bool> joined(const FreePoses& free, Turning turning = {}) const
  {
    const std::vector<int> component = components(free, robot_, turning, poses_);
    std::vector<bool> answer;
    for (std::size_t k = 0; k < open_.size(); ++k)
      answer.push_back(component[2 * k] > 0 && component[2 * k] == component[2 * k + 1]);
    return answer;
  }

private:
  const OccupancyGrid& grid_;
  const Lattice lattice_;
  const Robot robot_;
  const std::vector<Pair*> open_;
  std::vector<Pose> poses_;
};

std::vector<Pair*> open_ones(std::vector<Pair>& pairs)
{
  std::vector<Pair*> open;
  for (Pair& pair : pairs)
    if (pair.verdict == Verdict::undecided) open.push_back(&pair);
  return open;
}

/// Those that can with the margin. Whether they can without turning in place is asked of the same lattice.
void judge_with_margin(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot, std::vector<Pair>& pairs)
{
  const std::vector<Pair*> open = open_ones(pairs);
  if (std::all_of(open.begin(), open.end(), [](const Pair* pair) { return pair->end_is_tight; })) return;
  const OpenPairs question(grid, lattice, robot, open);
  const FreePoses free = question.rectangle(robot.safety_margin, FreePoses::Edge::inner);
  const std::vector<bool> joined = question.joined(free);
  if (std::none_of(joined.begin(), joined.end(), [](bool can) { return can; })) return;
  for (std::size_t k = 0; k < open.size(); ++k)
    if (joined[k]) open[k]->verdict = Verdict::with_margin;
  for (std::size_t i = 0; i < kShunts.size(); ++i)
  {
    const std::vector<bool> by_arcs = question.joined(free, Turning{kShunts[i]});
    for (std::size_t k = 0; k < open.size(); ++k) open[k]->without_spin[i] = joined[k] && by_arcs[k];
  }
}

void judge_bare(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot, std::vector<Pair>& pairs)
{
  const std::vector<Pair*> open = open_ones(pairs);
  if (open.empty()) return;
  const OpenPairs question(grid, lattice, robot, open);
  const std::vector<bool> bare = question.joined(question.rectangle(0.0, FreePoses::Edge::inner));
  const std::vector<bool> maybe_bare = question.joined(question.rectangle(0.0, FreePoses::Edge::outer));
  const bool asks = std::any_of(bare.begin(), bare.end(), [](bool can) { return can; });
  const std::vector<bool> maybe_with_margin =
      asks ? question.joined(question.rectangle(robot.safety_margin, FreePoses::Edge::outer)) : bare;
  for (std::size_t k = 0; k < open.size(); ++k)
  {
    if (!maybe_bare[k]) open[k]->verdict = Verdict::impossible;
    if (bare[k] && (open[k]->end_is_tight || !maybe_with_margin[k])) open[k]->verdict = Verdict::bare_only;
  }
}

}  // namespace

const char* to_string(Verdict verdict)
{
  switch (verdict)
  {
    case Verdict::undecided: return "undecided";
    case Verdict::with_margin: return "with margin";
    case Verdict::bare_only: return "bare only";
    case Verdict::impossible: return "impossible";
  }
  return "undecided";
}

std::vector<Pair> random_pairs(const OccupancyGrid& grid, const Robot& robot, Random& random, int count)
{
  const Lattice& lattice = kLattices[0];
  Robot grown = robot;
  grown.length += 2.0 * robot.safety_margin;
  grown.width += 2.0 * robot.safety_margin;
  const ExactBody body(grid, {}, robot), with_margin(grid, {}, grown);
  const auto on_lattice = [](double value, double step) { return std::round(value / step) * step; };
  const auto free_pose = [&] {
    for (int trial = 0;; ++trial)
    {
      const Pose pose = {on_lattice(random.between(0.0, grid.width * grid.resolution), lattice.step),
                         on_lattice(random.between(0.0, grid.height * grid.resolution), lattice.step),
                         wrap_angle(on_lattice(random.angle(), lattice.turn()))};
      if (!body.overlaps(pose) || trial > 100000) return pose;
    }
  };
  std::vector<Pair> pairs;
  for (int k = 0; k < count; ++k)
  {
    Pair pair;
    pair.start = free_pose();
    pair.goal = free_pose();
    pair.end_is_tight = with_margin.overlaps(pair.start) || with_margin.overlaps(pair.goal);
    pairs.push_back(pair);
  }
  return pairs;
}

void judge(const OccupancyGrid& grid, const Robot& robot, std::vector<Pair>& pairs)
{
  for (const Lattice& lattice : kLattices)
  {
    if (open_ones(pairs).empty() || poses_of(lattice, grid) > kMostPoses) break;
    judge_with_margin(grid, lattice, robot, pairs);
    judge_bare(grid, lattice, robot, pairs);
  }
  std::vector<Pair*> all;
  for (Pair& pair : pairs) all.push_back(&pair);
  const OpenPairs question(grid, kLattices[0], robot, all);
  const std::vector<bool> discs = question.joined(question.discs());
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].discs_can = discs[k];
}

}  // namespace fourwis::nightly
