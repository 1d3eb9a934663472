#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// A lattice of poses over a grid whose origin is (0, 0, 0). The rectangle in its middle looks the same half a turn on, so that
/// headings are those of half a turn.
struct Lattice
{
  double step;   ///< between neighbours [m]
  int headings;  ///< in half a turn

  double turn() const;  ///< between neighbours [rad]
};

/// Which poses of a lattice are free: a bit each. Shares no code with the planner.
class FreePoses
{
public:
  enum class Edge
  {
    inner,  ///< grown by what lies between two neighbours: the motion from one free pose to the next is free
    outer   ///< shrunk by what lies around a pose: where it is not free, no pose nearer to it than to others is
  };

  /// Of the rectangle of the body with a margin on each side [m].
  static FreePoses of_rectangle(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot, double margin,
                                Edge edge);

  /// Of the paper's two discs with their margin, neither grown nor shrunk.
  static FreePoses of_discs(const OccupancyGrid& grid, const Lattice& lattice, const Robot& robot);

  const Lattice& lattice() const { return lattice_; }
  int rows() const { return rows_; }
  int words() const { return words_; }
  std::size_t index(int heading, int row, int word) const
  {
    return (static_cast<std::size_t>(heading) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row)) *
               static_cast<std::size_t>(words_) +
           static_cast<std::size_t>(word);
  }
  std::uint64_t operator[](std::size_t index) const { return bits_[index]; }
  std::size_t size() const { return bits_.size(); }

  /// Of the pose of the lattice next to one: the index of its word, and its bit.
  std::pair<std::size_t, std::uint64_t> at(const Pose& pose) const;

private:
  FreePoses(const OccupancyGrid& grid, const Lattice& lattice);

  /// What a shape cannot enter, as x of the pose between two ends, for a heading, an obstacle and y of the pose.
  struct Box
  {
    double left, right, bottom, top;
  };
  struct Interval;
  struct Rectangle;
  struct Disc;
  template <class Shape>
  void block(int heading, const Shape& shape);
  void block(int heading, int row, double low, double high);

  Lattice lattice_;
  int columns_, rows_, words_;
  std::vector<Box> obstacles_;
  std::vector<std::uint64_t> bits_;
};

/// How the body may turn: in place, or only by arcs of the tightest Ackermann and lateral motions. Arcs short enough turn it in
/// place, as good as, by going to and fro: so they have a least length.
struct Turning
{
  int degrees = 0;  ///< the least that it turns by at once, in steps of 2; 0: in place
};

/// Which of the poses are joined: the number of the component of each, 0 where it is not free.
std::vector<int> components(const FreePoses& free, const Robot& robot, Turning turning, const std::vector<Pose>& poses);

}  // namespace fourwis::nightly
