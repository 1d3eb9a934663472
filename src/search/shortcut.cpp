#include "shortcut.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fourwis
{
namespace
{

/// Curves tried between two places, cheapest first.
constexpr std::size_t kCurvesTried = 6;
/// A shortcut has to save this much [m]. Less may be rounding.
constexpr double kLeastGain = 1e-6;
/// Headings that differ by no more are the same [rad].
constexpr double kExactHeading = 1e-9;
/// Long pieces are split, so that curves may leave and join them about this far apart [m].
constexpr double kPlaceSpacing = 0.5;

/// A place where pieces meet, and the cheapest known way to get there.
struct Place
{
  Pose pose;
  double cost = std::numeric_limits<double>::infinity();  ///< from the start
  std::size_t from = 0;                                   ///< the place before
  ModeCurve curve;                                        ///< from there to here
};

class Shortcut
{
public:
  Shortcut(const CollisionChecker& checker, const ModeCurves& curves, const Path& path)
    : checker_(checker),
      curves_(curves),
      cost_(curves.cost()),
      path_(path),
      start_mode_(curves.modes().first())
  {
    for (const PathPiece& piece : path.pieces) append_split(piece);
    places_.resize(pieces_.size() + 1);
    places_.front().cost = 0.0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) places_[i].pose = pieces_[i].start;
    places_.back().pose = path.goal;
    measure_original();
  }

  Path run(const Interrupt& interrupt)
  {
    const std::size_t last = places_.size() - 1;
    for (std::size_t i = 0; i < last; ++i)
    {
      if (interrupt.cancelled() || interrupt.timed_out()) break;
      keep_piece(i);
      for (std::size_t step = 2; i + step < last; step += (step + 1) / 2) join(i, i + step);
      if (i + 1 < last) join(i, last);
    }
    while (places_.back().cost == std::numeric_limits<double>::infinity()) keep_piece(unreached() - 1);
    return places_.back().cost < original_.back() ? collect() : path_;
  }

private:
  void append_split(const PathPiece& piece)
  {
    const int parts = std::max(1, static_cast<int>(std::lround(std::abs(piece.length) / kPlaceSpacing)));
    PathPiece part = piece;
    part.length /= parts;
    for (int k = 0; k < parts; ++k)
    {
      pieces_.push_back(part);
      part.start = curves_.end_of(part);
    }
  }

  /// Cost of the original path up to each place.
  void measure_original()
  {
    original_.assign(1, 0.0);
    Mode mode = start_mode_;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
    {
      const bool switches = pieces_[i].mode != mode;
      mode = pieces_[i].mode;
      original_.push_back(original_.back() + (switches ? cost_.mode_switch(i == 0) : 0.0) +
                          cost_.piece(pieces_[i], switches || i == 0 ? nullptr : &pieces_[i - 1]));
    }
  }

  /// The first place to which no way is known. There are such places after an interrupt.
  std::size_t unreached() const
  {
    std::size_t i = 0;
    while (places_[i].cost < std::numeric_limits<double>::infinity()) ++i;
    return i;
  }

  Mode mode_at(std::size_t i) const { return i == 0 ? start_mode_ : last_piece(i)->mode; }
  const PathPiece* last_piece(std::size_t i) const
  {
    if (i == 0) return nullptr;
    const ModeCurve& curve = places_[i].curve;
    return &curve.pieces[static_cast<std::size_t>(curve.count - 1)];
  }

  /// From a place to the next as the path did it.
  void keep_piece(std::size_t i)
  {
    const PathPiece& piece = pieces_[i];
    double cost = places_[i].cost;
    const bool switches = piece.mode != mode_at(i);
    if (switches) cost += cost_.mode_switch(i == 0);
    cost += cost_.piece(piece, switches ? nullptr : last_piece(i));
    if (cost >= places_[i + 1].cost) return;
    ModeCurve curve;
    curve.pieces[0] = piece;
    curve.count = 1;
    set(i + 1, cost, i, curve);
  }

  /// Whether a curve ends in exactly the heading of a place. At the goal a little rounding is allowed. On the way it
  /// would move the rest of the path aside.
  bool meets(const ModeCurve& curve, std::size_t place) const
  {
    if (place + 1 == places_.size()) return true;
    const Pose end = curves_.end_of(curve.pieces[static_cast<std::size_t>(curve.count - 1)]);
    return std::abs(wrap_angle(end.theta - places_[place].pose.theta)) < kExactHeading;
  }

  /// From a place straight to a later one, if that is cheaper.
  void join(std::size_t from, std::size_t to)
  {
    const double budget = std::min(places_[to].cost - places_[from].cost, original_[to] - original_[from]) - kLeastGain;
    if (budget <= distance(places_[from].pose, places_[to].pose)) return;
    curves_.candidates(places_[from].pose, {mode_at(from), last_piece(from), from == 0}, places_[to].pose, budget,
                       candidates_);
    for (std::size_t k = 0; k < std::min(kCurvesTried, candidates_.size()); ++k)
    {
      ModeCurve& curve = candidates_[k];
      curves_.place(places_[from].pose, curve);
      if (!meets(curve, to) || !is_free(checker_, curve)) continue;
      set(to, places_[from].cost + curve.cost, from, curve);
      return;
    }
  }

  void set(std::size_t i, double cost, std::size_t from, const ModeCurve& curve)
  {
    places_[i].cost = cost;
    places_[i].from = from;
    places_[i].curve = curve;
  }

  Path collect() const
  {
    std::vector<std::size_t> route;
    for (std::size_t i = places_.size() - 1; i != 0; i = places_[i].from) route.push_back(i);
    Path path;
    path.cost = places_.back().cost;
    for (auto i = route.rbegin(); i != route.rend(); ++i)
    {
      const ModeCurve& curve = places_[*i].curve;
      path.pieces.insert(path.pieces.end(), curve.pieces.begin(), curve.pieces.begin() + curve.count);
    }
    // A curve meets a later place up to full turns: carry the heading on without a jump.
    Pose pose = path_.pieces.front().start;
    for (PathPiece& piece : path.pieces)
    {
      piece.start = pose;
      pose = curves_.end_of(piece);
    }
    path.goal = pose;
    return path;
  }

  const CollisionChecker& checker_;
  const ModeCurves& curves_;
  const MotionCost& cost_;
  const Path& path_;
  const Mode start_mode_;
  std::vector<PathPiece> pieces_;  ///< of the path, the long ones split
  std::vector<double> original_;
  std::vector<Place> places_;  ///< one more than pieces
  std::vector<ModeCurve> candidates_;
};

}  // namespace

Path shortcut(const CollisionChecker& checker, const ModeCurves& curves, const Path& path, const Interrupt& interrupt)
{
  if (path.pieces.size() < 2) return path;
  return Shortcut(checker, curves, path).run(interrupt);
}

}  // namespace fourwis
