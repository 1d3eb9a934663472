// Before floods judge a planner, their lattices are held against the exact body, pose by pose.

#include <cmath>

#include "../../support/random.h"
#include "exact_body.h"
#include "figures.h"
#include "lattice_flood.h"
#include "maps.h"

namespace fourwis::nightly
{
namespace
{

constexpr int kPoses = 20000;  ///< on a map of each kind

bool is_free(const FreePoses& free, const Pose& pose)
{
  const auto [word, bit] = free.at(pose);
  return (free[word] & bit) != 0;
}

/// Poses of a map of which an edge says more than it may.
int count_wrong(const OccupancyGrid& grid, const Robot& robot, Random& random)
{
  const Lattice lattice{0.02, 90};
  const FreePoses inner = FreePoses::of_rectangle(grid, lattice, robot, 0.0, FreePoses::Edge::inner);
  const FreePoses outer = FreePoses::of_rectangle(grid, lattice, robot, 0.0, FreePoses::Edge::outer);
  const ExactBody body(grid, {}, robot);
  const double half = lattice.step / 2.0, half_turn = lattice.turn() / 2.0;
  int wrong = 0;
  for (int k = 0; k < kPoses; ++k)
  {
    const Pose pose = {random.between(0.0, grid.width * grid.resolution),
                       random.between(0.0, grid.height * grid.resolution), random.angle()};
    if (!is_free(outer, pose) && !body.overlaps(pose)) ++wrong;
    if (!is_free(inner, pose)) continue;
    const Pose on_lattice = {std::round(pose.x / lattice.step) * lattice.step,
                             std::round(pose.y / lattice.step) * lattice.step,
                             std::round(pose.theta / lattice.turn()) * lattice.turn()};
    // There, and half way to each neighbour.
    for (const Pose& step : {Pose{}, Pose{half, 0.0, 0.0}, Pose{-half, 0.0, 0.0}, Pose{0.0, half, 0.0},
                             Pose{0.0, -half, 0.0}, Pose{0.0, 0.0, half_turn}, Pose{0.0, 0.0, -half_turn}})
      if (body.overlaps({on_lattice.x + step.x, on_lattice.y + step.y, on_lattice.theta + step.theta})) ++wrong;
  }
  return wrong;
}

}  // namespace

void floods_against_the_exact_body(const Figures& figures)
{
  const Robot robot;
  int wrong = 0, poses = 0;
  for (const MapKind& kind : map_kinds())
  {
    Random random(1);
    const OccupancyGrid grid = kind.draw(random, 1.0);
    wrong += count_wrong(grid, robot, random);
    poses += kPoses;
  }
  figures.rows.add("floods: poses called free or not that are not, by the exact body", "0",
                   std::to_string(wrong) + " of " + std::to_string(poses), wrong == 0, Rows::Weight::wrong);
}

}  // namespace fourwis::nightly
