#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// A box of poses, (i, j, k) in the lattice of its level: x, y and heading. Each level halves the one before.
struct PoseBox
{
  int level = 0, i = 0, j = 0, k = 0;

  friend bool operator==(const PoseBox& a, const PoseBox& b)
  {
    return a.level == b.level && a.i == b.i && a.j == b.j && a.k == b.k;
  }
};

/// Boxes that cover the poses of a body on a map, small ones where the body hardly fits. Coordinates are those of the map frame.
class PoseBoxes
{
public:
  /// What is known of the body at the poses of a box.
  enum class State : std::uint8_t
  {
    free,     ///< free at all
    blocked,  ///< free at none, as far as a motion is concerned that the checker found free
    mixed
  };

  static constexpr int kLevels = 7;

  /// Keeps a reference to the checker.
  explicit PoseBoxes(const CollisionChecker& checker);

  /// The smallest box that a pose lies in.
  PoseBox at(const Pose& pose) const;

  /// The middle of a box.
  Pose centre(const PoseBox& box) const;

  /// Between the middles of the sides of a box [m].
  double width(const PoseBox& box) const { return size_[static_cast<std::size_t>(box.level)]; }

  State state(const PoseBox& box);

  /// Replaces a box by its eight halves. It must not be on the last level.
  void split(const PoseBox& box);

  /// The boxes that touch a side of a box.
  void neighbours(const PoseBox& box, std::vector<PoseBox>& found) const;

  /// How many boxes the body has been looked at in.
  int looks() const { return looks_; }

  static std::uint64_t key(const PoseBox& box);

private:
  struct Shape
  {
    ConvexPolygon larger, smaller;  ///< than the body: free where the one is clear, blocked where the other is not
  };
  struct Spot
  {
    double x, y, margin;
    std::vector<Shape> shapes;
  };

  bool is_split(const PoseBox& box) const
  {
    const auto found = states_.find(key(box));
    return found != states_.end() && found->second == kSplit;
  }
  void append_facing(const PoseBox& box, int axis, int side, std::vector<PoseBox>& found) const;
  std::vector<Shape> shapes(const ConvexPolygon& body) const;
  State look(const PoseBox& box) const;

  static constexpr std::uint8_t kSplit = 3;

  const CollisionChecker& checker_;
  std::vector<double> size_, turn_;  ///< of the boxes of each level [m], [rad]
  std::vector<double> reach_;        ///< how far a point of the body is from where it is at the centre of a box [m]
  std::vector<Shape> shapes_;        ///< for each level
  std::vector<Spot> spots_;          ///< tight ones
  int columns_, rows_;               ///< of boxes of level 0
  std::unordered_map<std::uint64_t, std::uint8_t> states_;
  int looks_ = 0;
};

}  // namespace fourwis
