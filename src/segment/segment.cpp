#include "fourwis_navigation/segment/segment.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "parallel_angle.h"

namespace fourwis
{
namespace
{

/// Shorter pieces are rounding [m].
constexpr double kNoLength = 1e-6;
/// Pieces further apart do not follow one another [m, rad].
constexpr double kGap = 1e-3;
/// See split_at_switches().
constexpr int kLeastIntervals = 4;
constexpr double kMostIntervals = 1e6;
/// An interval may be longer than `spacing` by this share of it, because of rounding.
constexpr double kRounding = 1e-9;

bool is_usable(const PathPiece& piece, const Robot& robot)
{
  return is_planned(piece.mode) && is_finite(piece.start) && std::isfinite(piece.phi) && std::isfinite(piece.length) &&
         std::isfinite(curvature(robot, piece.mode, piece.phi));
}

Pose end_of(const PathPiece& piece, const Robot& robot)
{
  return advance(robot, piece.start, piece.mode, piece.phi, piece.length);
}

/// The pieces that move the robot, headings continued without a jump; none when the path is unusable.
std::vector<PathPiece> clean(const std::vector<PathPiece>& pieces, const Robot& robot, double spacing)
{
  std::vector<PathPiece> kept;
  double length = 0.0;
  for (PathPiece piece : pieces)
  {
    if (!is_usable(piece, robot)) return {};
    length += std::abs(piece.length);
    if (length > kMostIntervals * spacing) return {};
    if (std::abs(piece.length) < kNoLength) continue;
    if (!kept.empty())
    {
      const Pose end = end_of(kept.back(), robot);
      const double turn = wrap_angle(piece.start.theta - end.theta);
      if (!(distance(end, piece.start) <= kGap) || !(std::abs(turn) <= kGap)) return {};
      piece.start.theta = end.theta + turn;
    }
    kept.push_back(piece);
  }
  return kept;
}

/// Pieces of one mode and one driving direction, by the distance that C, the centre of the wheels, has travelled along
/// them.
class Run
{
public:
  using Piece = std::vector<PathPiece>::const_iterator;

  Run(const Robot& robot, Piece begin, Piece end) : robot_(robot), begin_(begin), end_(end)
  {
    for (Piece piece = begin; piece != end; ++piece) length_ += std::abs(piece->length);
  }

  double length() const { return length_; }
  double direction() const { return begin_->length < 0.0 ? -1.0 : 1.0; }

  Pose at(double s) const
  {
    Piece piece = begin_;
    for (; piece + 1 != end_ && s > std::abs(piece->length); ++piece) s -= std::abs(piece->length);
    const double within = std::min(s, std::abs(piece->length));
    return advance(robot_, piece->start, piece->mode, piece->phi, direction() * within);
  }

  /// Mean of the steering angle between two distances, weighted by length.
  double mean_phi(double from, double to) const
  {
    double sum = 0.0, weight = 0.0, s = 0.0;
    for (Piece piece = begin_; piece != end_; ++piece)
    {
      const double next = s + std::abs(piece->length);
      const double overlap = std::max(0.0, std::min(to, next) - std::max(from, s));
      sum += overlap * piece->phi;
      weight += overlap;
      s = next;
    }
    return sum / weight;
  }

private:
  const Robot& robot_;
  Piece begin_, end_;
  double length_ = 0.0;
};

void append(const Run& run, double spacing, Segment& segment)
{
  const int count = std::max(kLeastIntervals, static_cast<int>(std::ceil(run.length() / spacing - kRounding)));
  const double step = run.length() / count;
  for (int k = 0; k < count; ++k)
  {
    segment.knots.push_back(run.at(step * (k + 1)));
    segment.phi.push_back(run.mean_phi(step * k, step * (k + 1)));
    segment.length.push_back(run.direction() * step);
  }
}

/// The segment of pieces of one mode.
Segment resample(const std::vector<PathPiece>& pieces, const Robot& robot, double spacing)
{
  Segment segment;
  segment.mode = pieces.front().mode;
  segment.knots.push_back(pieces.front().start);
  for (auto begin = pieces.begin(); begin != pieces.end();)
  {
    const bool backward = std::signbit(begin->length);
    const auto turns = [&](const PathPiece& piece) { return std::signbit(piece.length) != backward; };
    const auto end = std::find_if(begin, pieces.end(), turns);
    append(Run(robot, begin, end), spacing, segment);
    begin = end;
  }
  return segment;
}

}  // namespace

std::vector<Segment> split_at_switches(const Path& path, const Robot& robot, double spacing)
{
  require_positive("spacing", spacing);
  const std::vector<PathPiece> pieces = clean(path.pieces, robot, spacing);
  std::vector<Segment> segments;
  for (auto begin = pieces.begin(); begin != pieces.end();)
  {
    const auto end = std::find_if(begin, pieces.end(), [&](const PathPiece& p) { return p.mode != begin->mode; });
    std::vector<PathPiece> part(begin, end);
    if (traits_of(begin->mode).follows_phi) keep_angle_near(part, robot.wheel_max_angle);
    segments.push_back(resample(part, robot, spacing));
    begin = end;
  }
  return segments;
}

double travel_length(const Segment& segment)
{
  return std::accumulate(segment.length.begin(), segment.length.end(), 0.0,
                         [](double sum, double length) { return sum + std::abs(length); });
}

double reference_duration(const Segment& segment, double v_ref)
{
  require_positive("v_ref", v_ref);
  return travel_length(segment) / v_ref;
}

}  // namespace fourwis
