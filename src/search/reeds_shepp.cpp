#include "reeds_shepp.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>

// Letters as in the paper: L, R, S turn left, right or not, + is forward, - backward; t, u, v are the lengths that are
// not fixed. (xi, eta) leads from the centre of the first circle to that of the last. Its length r alone fixes all but
// t and v, and its direction theta is added to t. So the inverse functions are needed once for each of four pairs of
// circles, and the 48 words are sums of angles. (8.3), (8.4) and (8.11), which are misprinted in the paper, follow from
// the triangles of the centres, and so do (8.7) and (8.8), in place of the paper's tau and omega.

namespace fourwis
{
namespace
{

constexpr int L = 1, S = 0, R = -1;
constexpr double pi = M_PI, half_pi = M_PI_2;

// Goals on the border of a word's domain (straight lines, single arcs, half turns) leave it by rounding. A word is
// taken if moving the goal by about this much brings it back, and then misses the goal by no more than that.
constexpr double tolerance = 1e-13;

// (xi, eta) in polar coordinates and what the formulas derive from r alone; a negative length is one that no word has.
struct Centres
{
  double r = 0.0, theta = 0.0;
  double slack = 0.0;     // turning the words by this moves their end by the tolerance
  double tangent = -1.0;  // sqrt(r^2 - 4): the straight between circles that are crossed
  double beta = 0.0;      // its angle to (xi, eta)
};

// For words that begin and end with the same turn.
struct SameCentres : Centres
{
  double middle = -1.0;  // -u of (8.3)
};

// For words that begin and end with opposite turns.
struct OppositeCentres : Centres
{
  double u_outer = -1.0;              // u of (8.7)
  double u_inner = -1.0, bend = 0.0;  // -u of (8.8), and by how much it turns t
};

// The goal as a symmetry shows it: its words are sought as if they began with L+ and are read back by flipping the
// sign of lengths (time), of turns (side), and the order of segments (backwards).
struct View
{
  double theta_same, theta_opposite, phi;
  int time, side;
  bool backwards;
};

// The first and the last arc of a word.
struct Ends
{
  double t, v;
  bool found;
};

// Into [-pi, pi] up to rounding, for sums of a few angles; std::remainder is too slow.
double wrap(double angle)
{
  return angle - 2.0 * pi * static_cast<int>(angle * (0.5 / pi) + std::copysign(0.5, angle));
}

// Brings `angle` into [0, pi] by whole turns and a `shift` of at most `slack`. False if it takes more.
bool settle(double& angle, double slack, double& shift)
{
  angle = wrap(angle);
  shift = 0.0;
  if (angle >= 0.0) return true;
  const bool to_zero = -angle <= slack;
  shift = to_zero ? -angle : -pi - angle;
  angle = to_zero ? 0.0 : pi;
  return std::abs(shift) <= slack;
}

// t in [0, pi] and v = k (t - a), up to half a turn of the given sign. When v is shifted, t is too: that keeps the
// heading exact, and only turns the word.
Ends ends(double t, double a, int k, int sign, double slack)
{
  double shift;
  if (!settle(t, slack, shift)) return {0.0, 0.0, false};
  double v = sign * k * (t - a);
  if (!settle(v, slack, shift)) return {0.0, 0.0, false};
  const double shifted = t + sign * k * shift;
  t = std::clamp(shifted, 0.0, pi);
  return {t, sign * v, std::abs(shifted - t) <= tolerance};
}

using Segment = ReedsSheppSegment;
using Segments = std::initializer_list<Segment>;

// The formulas, which hand the words they find to `sink`.
template <typename Sink>
struct Formulas
{
  const View& view;
  const SameCentres& same;
  const OppositeCentres& opposite;
  Sink& sink;

  // A word from L+ to `last`: t is by `turn` more than theta, v is t - a for R and a - t for L and has the given sign.
  template <typename... Middle>
  void word(int last, int sign, double turn, double a, Middle... middle)
  {
    const double theta = last == L ? view.theta_same : view.theta_opposite;
    const double slack = last == L ? same.slack : opposite.slack;
    if (const Ends e = ends(theta + turn, a, -last, sign, slack); e.found)
      sink(view, {Segment{L, e.t}, middle..., Segment{last, e.v}});
  }

  // Words that keep their form when they are read backwards.
  void symmetric_words()
  {
    const double phi = view.phi, straight = opposite.tangent, beta = opposite.beta;
    word(L, 1, 0.0, phi, Segment{S, same.r});                                                       // (8.1) L+ S+ L+
    if (straight >= 0.0) word(R, 1, beta, phi, Segment{S, straight});                               // (8.2) L+ S+ R+
    if (const double u = -same.middle; u <= 0.0) word(L, 1, pi + 0.5 * u, phi + u, Segment{R, u});  // (8.3) L+ R- L+
    if (const double u = opposite.u_outer; u >= 0.0)
      word(R, -1, half_pi + u, phi + 2.0 * u, Segment{R, u}, Segment{L, -u});  // (8.7) L+ R+u L-u R-
    if (const double u = -opposite.u_inner; u <= 0.0)
      word(R, 1, half_pi + opposite.bend, phi, Segment{R, u}, Segment{L, u});         // (8.8) L+ R-u L-u R+
    if (const double u = std::min(0.0, 4.0 - straight); straight >= 4.0 - tolerance)  // (8.11) L+ R- S- L- R+
      word(R, 1, half_pi + beta, phi, Segment{R, -half_pi}, Segment{S, u}, Segment{L, -half_pi});
  }

  // Words that are different ones when they are read backwards.
  void asymmetric_words()
  {
    const double phi = view.phi;
    if (const double u = -same.middle; u <= 0.0) word(L, -1, pi + 0.5 * u, phi + u, Segment{R, u});  // (8.4) L+ R- L-
    if (const double u = std::min(0.0, 2.0 - same.tangent); same.tangent >= 2.0 - tolerance)  // (8.9) L+ R- S- L-
      word(L, -1, half_pi + same.beta, phi - half_pi, Segment{R, -half_pi}, Segment{S, u});
    if (const double u = std::min(0.0, 2.0 - opposite.r); opposite.r >= 2.0 - tolerance)  // (8.10) L+ R- S- R-
      word(R, -1, half_pi, phi - half_pi, Segment{R, -half_pi}, Segment{S, u});
  }
};

Centres centres(double xi, double eta)
{
  Centres c;
  const double square = xi * xi + eta * eta;
  c.r = std::sqrt(square);
  c.theta = std::atan2(eta, xi);
  c.slack = tolerance + tolerance / (c.r + std::numeric_limits<double>::min());
  if (square >= 4.0 - tolerance)
  {
    c.tangent = std::sqrt(std::max(0.0, square - 4.0));
    c.beta = std::atan2(2.0, c.tangent);
  }
  return c;
}

SameCentres same_centres(double xi, double eta)
{
  SameCentres c{centres(xi, eta)};
  if (c.r <= 4.0 + tolerance) c.middle = 2.0 * std::asin(std::min(1.0, 0.25 * c.r));
  return c;
}

OppositeCentres opposite_centres(double xi, double eta)
{
  OppositeCentres c{centres(xi, eta)};
  if (c.r <= 2.0 + tolerance) c.u_outer = std::acos(std::min(1.0, 0.5 + 0.25 * c.r));
  const double rho = (20.0 - c.r * c.r) / 16.0;
  if (rho >= -tolerance && rho <= 1.0 + tolerance)
  {
    c.u_inner = std::acos(std::clamp(rho, 0.0, 1.0));
    c.bend = std::asin(2.0 * std::sin(c.u_inner) / c.r);
  }
  return c;
}

// Hands every word to the goal to `sink`.
template <typename Sink>
void every_word(const Pose& goal, Sink& sink)
{
  if (!is_finite(goal)) throw std::invalid_argument("Reeds-Shepp goal is not finite");
  const double theta = std::remainder(goal.theta, 2.0 * pi), s = std::sin(theta), c = std::cos(theta);
  // (xi, eta) for words that begin to the left, and for their reflection.
  const SameCentres same[] = {same_centres(goal.x - s, goal.y + (c - 1.0)),
                              same_centres(goal.x + s, -goal.y + (c - 1.0))};
  const OppositeCentres opposite[] = {opposite_centres(goal.x + s, goal.y - 1.0 - c),
                                      opposite_centres(goal.x - s, -goal.y - 1.0 - c)};
  for (const int time : {1, -1})
  {
    // Flipping time negates xi.
    const auto seen = [time](const Centres& centres) { return time > 0 ? centres.theta : pi - centres.theta; };
    for (const int i : {0, 1})
    {
      const int side = i == 0 ? 1 : -1;
      const double phi = time * side * theta;
      const View view{seen(same[i]), seen(opposite[i]), phi, time, side, false};
      Formulas<Sink> formulas{view, same[i], opposite[i], sink};
      formulas.symmetric_words();
      formulas.asymmetric_words();
      // Backwards, (xi, eta) begins at the goal's circle and is seen from a heading turned by phi.
      const View back{phi - seen(same[i]), phi + seen(opposite[1 - i]), phi, time, side, true};
      Formulas<Sink>{back, same[i], opposite[1 - i], sink}.asymmetric_words();
    }
  }
}

double total(Segments segments)
{
  double length = 0.0;
  for (const Segment& segment : segments) length += std::abs(segment.length);
  return length;
}

// Undoes the symmetry; segments of no length are left out.
ReedsSheppPath read_back(const View& view, Segments segments)
{
  ReedsSheppPath path;
  for (const Segment& segment : segments)
    if (std::abs(segment.length) > tolerance)
      path.segments[path.count++] = {segment.turn * view.side, segment.length * view.time};
  if (view.backwards)
    std::reverse(path.segments.begin(), path.segments.begin() + static_cast<std::ptrdiff_t>(path.count));
  path.length = total(segments);
  return path;
}

}  // namespace

void reeds_shepp_words(const Pose& goal, ReedsSheppWords& words)
{
  words.count = 0;
  auto append = [&words](const View& view, Segments segments) {
    words.paths[words.count++] = read_back(view, segments);
  };
  every_word(goal, append);
}

double reeds_shepp_length(const Pose& goal)
{
  double shortest = std::numeric_limits<double>::infinity();
  auto keep = [&shortest](const View&, Segments segments) { shortest = std::min(shortest, total(segments)); };
  every_word(goal, keep);
  return shortest;
}

ReedsSheppPath shortest_reeds_shepp(const Pose& goal)
{
  ReedsSheppPath shortest;
  shortest.length = std::numeric_limits<double>::infinity();
  auto keep = [&shortest](const View& view, Segments segments) {
    if (total(segments) < shortest.length) shortest = read_back(view, segments);
  };
  every_word(goal, keep);
  return shortest;
}

}  // namespace fourwis
