#include "search/pose_boxes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "../support/grids.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 34;
using State = PoseBoxes::State;

/// Splits mixed boxes around a pose down to a random level.
PoseBox split_down(PoseBoxes& boxes, const Pose& pose, Random& random)
{
  const int level = random.whole(0, PoseBoxes::kLevels - 1);
  PoseBox box = boxes.at(pose);
  while (box.level < level && boxes.state(box) == State::mixed)
  {
    boxes.split(box);
    box = boxes.at(pose);
  }
  return box;
}

Pose anywhere(const Site& site, Random& random)
{
  const double side = site.grid.width * site.grid.resolution;
  Pose pose = compose(site.grid.origin, {random.between(0.0, side), random.between(0.0, side), random.angle()});
  pose.theta = wrap_angle(pose.theta);
  return pose;
}

/// Two poses beside each other at obstacles, with different room.
std::vector<Pose> tight_poses(const Site& site, Random& random)
{
  std::vector<Pose> poses;
  const ExactRectangle body(site.grid, site.robot);
  while (poses.size() < 2)
  {
    const Pose pose = poses.empty() ? anywhere(site, random) : compose(poses.front(), random.pose(0.3));
    if (!body.collides(pose) && !site.checker.is_free(pose)) poses.push_back(pose);
  }
  return poses;
}

/// Visits checkers that go by the body, without tight poses and with two: visit(site, checker, boxes, random).
template <typename Visit>
void for_checkers(Visit visit)
{
  Random random(kSeed);
  for (double resolution : {0.03, 0.05, 0.1})
    for (double margin : {0.0, 0.02, 0.1})
      for (int tight : {0, 1})
      {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution) + ", margin " +
                     std::to_string(margin) + (tight ? ", two tight poses" : ""));
        Robot robot;
        robot.safety_margin = margin;
        const Site site(clutter(random, 4.0, resolution, 4, random.pose(10.0)), robot);
        const CollisionChecker checker(site.map, site.robot, tight ? tight_poses(site, random) : std::vector<Pose>());
        PoseBoxes boxes(checker);
        visit(site, checker, boxes, random);
        if (testing::Test::HasFatalFailure()) return;
      }
}

TEST(PoseBoxes, AFreeBoxHasNoPoseThatCollidesAndABlockedOneNoneThatIsFree)
{
  std::map<State, int> count;
  for_checkers([&](const Site& site, const CollisionChecker& checker, PoseBoxes& boxes, Random& random) {
    const ExactRectangle body(site.grid, site.robot);
    for (int k = 0; k < 4000; ++k)
    {
      const Pose pose = anywhere(site, random);
      const State state = boxes.state(split_down(boxes, pose, random));
      ASSERT_TRUE(state != State::free || (checker.is_free(pose) && !body.collides(pose))) << text(pose);
      ASSERT_TRUE(state != State::blocked || !checker.is_free(pose)) << text(pose);
      ++count[state];
    }
  });
  for (State state : {State::free, State::blocked, State::mixed}) EXPECT_GT(count[state], 1000);
}

/// The proof of unreachability goes by blocked boxes, so that what matters are poses that are only just free.
TEST(PoseBoxes, ABlockedBoxHasNoPoseThatIsOnlyJustFree)
{
  for_checkers([&](const Site&, const CollisionChecker& checker, PoseBoxes& boxes, Random& random) {
    for (int k = 0; k < 1500; ++k)
    {
      Pose free = free_pose(random, checker), other = compose(free, random.pose(1.0));
      for (int halving = 0; halving < 40; ++halving)
      {
        const Pose middle = {(free.x + other.x) / 2.0, (free.y + other.y) / 2.0, (free.theta + other.theta) / 2.0};
        (checker.is_free(middle) ? free : other) = middle;
      }
      ASSERT_NE(boxes.state(split_down(boxes, free, random)), State::blocked) << text(free);
    }
  });
}

/// Motions that are found free are checked at some poses only; no pose between them may lie in a blocked box.
TEST(PoseBoxes, AMotionFoundFreeLeadsThroughNoBlockedBox)
{
  for_checkers([&](const Site& site, const CollisionChecker& checker, PoseBoxes& boxes, Random& random) {
    for (int k = 0; k < 150; ++k)
    {
      const Mode mode = random.mode();
      const PathPiece piece = {mode, free_pose(random, checker), random.steering(site.robot, mode),
                               random.between(-2.0, 2.0)};
      const Arc arc(site.robot, piece.start, mode, piece.phi);
      const double length = checker.free_length(piece);
      for (double s = 0.0; s < length; s += 0.004)
      {
        const Pose pose = arc.pose(std::copysign(s, piece.length));
        ASSERT_NE(boxes.state(split_down(boxes, pose, random)), State::blocked) << text(pose);
      }
    }
  });
}

TEST(PoseBoxes, ContainThePosesThatTheyAreAt)
{
  for_checkers([&](const Site& site, const CollisionChecker&, PoseBoxes& boxes, Random& random) {
    for (int k = 0; k < 1000; ++k)
    {
      const Pose pose = anywhere(site, random);
      const PoseBox box = split_down(boxes, pose, random);
      const Pose centre = relative_to(site.grid.origin, boxes.centre(box)), at = relative_to(site.grid.origin, pose);
      ASSERT_LE(std::abs(centre.x - at.x), boxes.width(box) / 2.0 + 1e-9);
      ASSERT_LE(std::abs(centre.y - at.y), boxes.width(box) / 2.0 + 1e-9);
      ASSERT_LE(heading_gap(centre.theta, at.theta), M_PI / (16 << box.level) + 1e-9);
    }
  });
}

/// A step over any side of a box leads into one of its neighbours, and each neighbour knows the box as one of its own.
TEST(PoseBoxes, HaveAllBoxesForNeighboursThatTouchTheirSides)
{
  for_checkers([&](const Site& site, const CollisionChecker&, PoseBoxes& boxes, Random& random) {
    for (int k = 0; k < 300; ++k) split_down(boxes, anywhere(site, random), random);
    std::vector<PoseBox> found, back;
    for (int k = 0; k < 500; ++k)
    {
      const PoseBox box = boxes.at(anywhere(site, random));
      boxes.neighbours(box, found);
      std::set<std::uint64_t> keys;
      for (const PoseBox& next : found)
      {
        ASSERT_TRUE(keys.insert(PoseBoxes::key(next)).second) << "named twice";
        ASSERT_EQ(boxes.at(boxes.centre(next)), next) << "a box that is split, or part of a whole one";
        boxes.neighbours(next, back);
        ASSERT_NE(std::find(back.begin(), back.end(), box), back.end());
      }
      const Pose centre = relative_to(site.grid.origin, boxes.centre(box));
      const double half = boxes.width(box) / 2.0, half_turn = M_PI / (16 << box.level);
      for (int axis = 0; axis < 3; ++axis)
      {
        Pose over = {centre.x + random.unit() * half, centre.y + random.unit() * half,
                     centre.theta + random.unit() * half_turn};
        double Pose::*part = axis == 0 ? &Pose::x : axis == 1 ? &Pose::y : &Pose::theta;
        over.*part = centre.*part + (random.chance(0.5) ? 1.0 : -1.0) * ((axis == 2 ? half_turn : half) + 1e-7);
        const double side = site.grid.width * site.grid.resolution;
        if (std::min(over.x, over.y) < 0.0 || std::max(over.x, over.y) > side) continue;
        const PoseBox next = boxes.at(compose(site.grid.origin, over));
        ASSERT_TRUE(keys.count(PoseBoxes::key(next)) > 0) << "over axis " << axis;
      }
    }
  });
}

}  // namespace
}  // namespace fourwis
