#include <algorithm>
#include <array>
#include <cmath>

#include "lattice_flood.h"

namespace fourwis::nightly
{
namespace
{

/// Arcs are looked at where they have turned by multiples of this, on lattices of all sizes [degrees].
constexpr int kArcStep = 2;

/// Bits of three words in a row; the middle one has the number of the pose they came from.
using Strip = std::array<std::uint64_t, 3>;

/// Moves each bit to a greater column, or to a smaller one where `columns` is negative; by less than 64.
Strip moved(const Strip& from, int columns)
{
  Strip to = from;
  if (columns > 0)
    for (std::size_t k = 3; k-- > 0;) to[k] = from[k] << columns | (k > 0 ? from[k - 1] >> (64 - columns) : 0);
  if (columns < 0)
    for (std::size_t k = 0; k < 3; ++k) to[k] = from[k] >> -columns | (k < 2 ? from[k + 1] << (64 + columns) : 0);
  return to;
}

/// What can be reached from some bits of a word through its free ones, to the left and to the right.
std::uint64_t spread(std::uint64_t bits, std::uint64_t free)
{
  std::uint64_t up = bits, down = bits, free_up = free, free_down = free;
  for (int shift = 1; shift < 64; shift *= 2)
  {
    up |= free_up & up << shift;
    free_up &= free_up << shift;
    down |= free_down & down >> shift;
    free_down &= free_down >> shift;
  }
  return up | down;
}

class Flood
{
public:
  Flood(const FreePoses& free, const Robot& robot, Turning turning)
    : free_(free),
      turning_(turning),
      seen_(free.size(), 0),
      pending_(free.size(), 0)
  {
    least_ = std::max(1, turning.degrees / kArcStep);
    ackermann_ = robot.wheelbase / (2.0 * std::tan(robot.max_steering_angle));
    lateral_ = robot.track_width / (2.0 * std::tan(robot.max_steering_angle));
  }

  bool has_seen(const std::pair<std::size_t, std::uint64_t>& place) const
  {
    return (seen_[place.first] & place.second) != 0;
  }

  void fill_from(const std::pair<std::size_t, std::uint64_t>& place)
  {
    offer(place.first, place.second);
    while (!next_.empty())
    {
      std::vector<std::size_t> words;
      words.swap(next_);
      for (const std::size_t word : words) visit(word);
    }
  }

private:
  void offer(std::size_t word, std::uint64_t bits)
  {
    bits &= free_[word] & ~seen_[word];
    if (bits == 0) return;
    if (pending_[word] == 0) next_.push_back(word);
    pending_[word] |= bits;
    seen_[word] |= bits;
  }

  void visit(std::size_t index)
  {
    const std::uint64_t bits = spread(pending_[index], free_[index]);
    pending_[index] = 0;
    seen_[index] |= bits;
    const int word = static_cast<int>(index % static_cast<std::size_t>(free_.words()));
    const std::size_t line = index / static_cast<std::size_t>(free_.words());
    const int row = static_cast<int>(line % static_cast<std::size_t>(free_.rows()));
    const int heading = static_cast<int>(line / static_cast<std::size_t>(free_.rows()));
    if (word > 0) offer(index - 1, bits << 63);
    if (word + 1 < free_.words()) offer(index + 1, bits >> 63);
    if (row > 0) offer(free_.index(heading, row - 1, word), bits);
    if (row + 1 < free_.rows()) offer(free_.index(heading, row + 1, word), bits);
    for (int sense : {-1, 1})
    {
      if (turning_.degrees == 0)
        offer(free_.index(turned(heading, sense), row, word), bits);
      else
        for (double forward : {-1.0, 1.0})
        {
          shunt(heading, row, word, bits, sense, forward * ackermann_, 0.0);
          shunt(heading, row, word, bits, sense, forward * lateral_, M_PI_2);
        }
    }
  }

  int turned(int heading, int by) const
  {
    const int all = free_.lattice().headings;
    return ((heading + by) % all + all) % all;
  }

  /// Arcs in the direction `course` from the heading, forward or backward as the sign of the radius says: of the least length,
  /// and of all that two of them do not make.
  void shunt(int heading, int row, int word, std::uint64_t bits, int sense, double radius, double course)
  {
    const Lattice& lattice = free_.lattice();
    const int headings_of_a_step = kArcStep * lattice.headings / 180;
    Strip strip{0, bits, 0};
    int columns = 0;
    for (int step = 1; step < 2 * least_; ++step)
    {
      const double turned_by = step * headings_of_a_step * lattice.turn();
      const double direction = heading * lattice.turn() + course + sense * turned_by / 2.0;
      const double chord = 2.0 * radius * std::sin(turned_by / 2.0) / lattice.step;
      const int to_column = static_cast<int>(std::lround(chord * std::cos(direction)));
      const int to_row = row + static_cast<int>(std::lround(chord * std::sin(direction)));
      if (to_row < 0 || to_row >= free_.rows()) return;
      const int to_heading = turned(heading, sense * step * headings_of_a_step);
      strip = moved(strip, to_column - columns);
      columns = to_column;
      std::uint64_t left = 0;
      for (int k = -1; k <= 1; ++k)
      {
        std::uint64_t& part = strip[static_cast<std::size_t>(k + 1)];
        const bool outside = word + k < 0 || word + k >= free_.words();
        part = outside ? 0 : part & free_[free_.index(to_heading, to_row, word + k)];
        left |= part;
        if (step >= least_ && part != 0) offer(free_.index(to_heading, to_row, word + k), part);
      }
      if (left == 0) return;
    }
  }

  const FreePoses& free_;
  const Turning turning_;
  int least_;                   ///< steps of an arc
  double ackermann_, lateral_;  ///< least radii of the turns [m]
  std::vector<std::uint64_t> seen_, pending_;
  std::vector<std::size_t> next_;
};

}  // namespace

std::vector<int> components(const FreePoses& free, const Robot& robot, Turning turning, const std::vector<Pose>& poses)
{
  std::vector<int> component(poses.size(), 0);
  Flood flood(free, robot, turning);
  int last = 0;
  for (std::size_t k = 0; k < poses.size(); ++k)
  {
    const auto place = free.at(poses[k]);
    if (component[k] > 0 || (free[place.first] & place.second) == 0) continue;
    flood.fill_from(place);
    ++last;
    for (std::size_t i = k; i < poses.size(); ++i)
      if (component[i] == 0 && flood.has_seen(free.at(poses[i]))) component[i] = last;
  }
  return component;
}

}  // namespace fourwis::nightly
