#include "heading_slices.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fourwis
{
namespace
{

constexpr int kInterruptInterval = 16;  ///< rows of cells between two looks at the interrupt
constexpr double kTouch = 1e-9;         ///< less overlap than this is none [m]
constexpr double kRounding = 1e-9;      ///< of lengths in spacings
constexpr int kWord = 64;

/// Obstacles of a row of the grid that lie side by side [m].
struct Run
{
  double begin, end;
};

std::vector<std::vector<Run>> runs_of(const ObstacleMap& map)
{
  std::vector<std::vector<Run>> rows(static_cast<std::size_t>(map.height()));
  for (int row = 0; row < map.height(); ++row)
    for (int column = map.next_obstacle(0, row); column < map.width(); column = map.next_obstacle(column, row))
    {
      const int begin = column;
      while (column < map.width() && map.next_obstacle(column, row) == column) ++column;
      rows[static_cast<std::size_t>(row)].push_back({begin * map.resolution(), column * map.resolution()});
      if (column >= map.width()) break;
    }
  return rows;
}

/// A body at one heading, in the frame of the grid: what it covers across between two heights above C.
class Outline
{
public:
  Outline() = default;
  Outline(const ConvexPolygon& body, double heading)
  {
    const double c = std::cos(heading), s = std::sin(heading);
    for (const Point2& p : body) corners_.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
    for (const Point2& p : corners_)
    {
      across_.add(p.x);
      along_.add(p.y);
    }
  }

  double low() const { return along_.least; }
  double high() const { return along_.greatest; }
  double left() const { return across_.least; }
  double right() const { return across_.greatest; }

  Extent between(double bottom, double top) const
  {
    return extent_between(corners_.data(), corners_.size(), bottom, top);
  }

private:
  std::vector<Point2> corners_;
  Extent across_, along_;
};

/// A row of cells at one heading, a bit for each cell.
class Bits
{
public:
  explicit Bits(int count) : count_(count), words_(static_cast<std::size_t>((count + kWord - 1) / kWord), 0) {}

  std::uint64_t word(std::size_t i) const { return words_[i]; }

  /// Sets the bits from `first` to `last`, as far as there are such.
  void set(double first, double last)
  {
    const int begin = static_cast<int>(std::max(0.0, first)), end = static_cast<int>(std::min(count_ - 1.0, last));
    if (!(first < count_) || !(last >= 0.0) || begin > end) return;
    const std::size_t from = static_cast<std::size_t>(begin / kWord), to = static_cast<std::size_t>(end / kWord);
    const std::uint64_t head = ~std::uint64_t{0} << begin % kWord,
                        tail = ~std::uint64_t{0} >> (kWord - 1 - end % kWord);
    if (from == to)
    {
      words_[from] |= head & tail;
      return;
    }
    words_[from] |= head;
    for (std::size_t i = from + 1; i < to; ++i) words_[i] = ~std::uint64_t{0};
    words_[to] |= tail;
  }

private:
  int count_;
  std::vector<std::uint64_t> words_;
};

/// Swaps rows and columns of a square of bits: Warren, "Hacker's Delight", section 7-3.
void transpose(std::array<std::uint64_t, kWord>& square)
{
  std::uint64_t mask = 0x00000000FFFFFFFFull;
  for (unsigned width = 32; width != 0; width /= 2, mask ^= mask << width)
    for (unsigned k = 0; k < kWord; k = (k + width + 1) & ~width)
    {
      const std::uint64_t swapped = (square[k] >> width ^ square[k + width]) & mask;
      square[k] ^= swapped << width;
      square[k + width] ^= swapped;
    }
}

}  // namespace

HeadingSlices::HeadingSlices(const ObstacleMap& map, double spacing, const ConvexPolygon& body,
                             const Interrupt& interrupt)
  : spacing_(spacing),
    columns_(static_cast<int>(std::ceil(map.width() * map.resolution() / spacing - kRounding)) + 1),
    rows_(static_cast<int>(std::ceil(map.height() * map.resolution() / spacing - kRounding)) + 1),
    clear_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kAllHeadings)
{
  const std::vector<std::vector<Run>> rows = runs_of(map);
  std::array<Outline, kHeadings> outlines;
  for (int k = 0; k < kHeadings; ++k)
    outlines[static_cast<std::size_t>(k)] = Outline(body, heading_of(k) - map.origin().theta);

  const double resolution = map.resolution(), width = map.width() * resolution, height = map.height() * resolution;
  for (int j = 0; j < rows_; ++j)
  {
    if (j % kInterruptInterval == 0 && (interrupt.cancelled() || interrupt.timed_out())) return;
    const double y = j * spacing;
    std::vector<Bits> blocked(kHeadings, Bits(columns_));
    for (std::size_t k = 0; k < kHeadings; ++k)
    {
      const Outline& outline = outlines[k];
      Bits& bits = blocked[k];
      if (y + outline.low() < -kTouch || y + outline.high() > height + kTouch)
      {
        bits.set(0.0, columns_);
        continue;
      }
      bits.set(0.0, std::ceil((-kTouch - outline.left()) / spacing) - 1.0);
      bits.set(std::floor((width + kTouch - outline.right()) / spacing) + 1.0, columns_);
      const int first_row = std::max(0, static_cast<int>(std::floor((y + outline.low() + kTouch) / resolution)));
      const int end_row =
          std::min(map.height(), static_cast<int>(std::ceil((y + outline.high() - kTouch) / resolution)));
      for (int row = first_row; row < end_row; ++row)
      {
        if (rows[static_cast<std::size_t>(row)].empty()) continue;
        const Extent covered = outline.between(row * resolution - y, (row + 1) * resolution - y);
        for (const Run& run : rows[static_cast<std::size_t>(row)])
          bits.set(std::floor((run.begin - covered.greatest + kTouch) / spacing) + 1.0,
                   std::ceil((run.end - covered.least - kTouch) / spacing) - 1.0);
      }
    }
    for (int first = 0; first < columns_; first += kWord)
    {
      std::array<std::uint64_t, kWord> square;
      for (std::size_t k = 0; k < kHeadings; ++k) square[k] = ~blocked[k].word(static_cast<std::size_t>(first / kWord));
      transpose(square);
      std::copy_n(square.begin(), std::min(kWord, columns_ - first), &clear_[index(first, j)]);
    }
  }
}

}  // namespace fourwis
