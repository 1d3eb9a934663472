#include "fourwis_navigation/search/hybrid_astar.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "closed_list.h"
#include "fourwis_navigation/model/option_range.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "mode_curves.h"
#include "motion_cost.h"

namespace fourwis
{
namespace
{

/// A primitive that does not fit is tried at these fractions of its length.
constexpr std::array<double, 3> kFractions = {1.0, 0.5, 0.25};
/// Directions of travel sampled on entering a mode that follows phi, when the wheels are free to be turned anywhere.
constexpr int kFan = 12;
/// Of them, this many that lead closest to the goal are tried.
constexpr int kFanTried = 4;
/// Curves tried in one terminal connection, cheapest first.
constexpr std::size_t kCurvesTried = 12;
/// The heuristic uses curves to the goal only within this distance of it, in sizes of the robot. Farther away the obstacles
/// matter more.
constexpr double kNearGoal = 4.0;

/// Shorter pieces are not worth a node [m].
constexpr double kShortest = 1e-3;

struct Node
{
  /// How the robot got here.
  enum class Kind : std::uint8_t
  {
    start,
    driven,   ///< along a piece
    switched  ///< by changing the mode at rest
  };

  PathPiece piece;  ///< from the parent to here, where it was driven
  Pose pose;
  double g = 0.0;
  double h = 0.0;
  int parent = -1;  ///< none at the start
  Mode mode = Mode::none;
  Kind kind = Kind::start;
};

struct OpenEntry
{
  double f;
  int node;
  bool operator<(const OpenEntry& other) const { return f != other.f ? f > other.f : node < other.node; }
};

class HybridAStar
{
public:
  HybridAStar(const SearchProblem& problem, const SearchOptions& options, const ModeSet& modes, const Guide& guide)
    : checker_(problem.checker),
      robot_(checker_.robot()),
      options_(options),
      limits_(robot_),
      primitive_length_(options.primitive_length(robot_)),
      cell_size_(options.cell_size(robot_)),
      near_goal_(kNearGoal * robot_.size()),
      request_{problem.start, problem.goal, modes},
      cost_(robot_, options),
      curves_(robot_, options, cost_, request_.modes),
      guide_(guide)
  {}

  SearchResult run(const Interrupt& interrupt, std::vector<Pose>* expanded)
  {
    push_start();
    while (const std::optional<int> popped = pop())
    {
      if (interrupt.cancelled()) return finish(PlanStatus::cancelled);
      if (interrupt.timed_out()) return finish(PlanStatus::timeout);
      if (expansions_ >= options_.max_expansions) return finish(PlanStatus::no_path);
      const int n = *popped;
      if (expanded) expanded->push_back(node(n).pose);
      ++expansions_;
      if (connects_to_goal(n)) return finish(PlanStatus::succeeded);
      for (Mode mode : kPlannedModes)
      {
        if (!request_.modes.contains(mode)) continue;
        if (mode == node(n).mode)
          expand_within_mode(n);
        else
          expand_switch(n, mode);
      }
    }
    return finish(PlanStatus::no_path);
  }

private:
  const Node& node(int n) const { return nodes_[static_cast<std::size_t>(n)]; }
  bool is_start(int n) const { return node(n).kind == Node::Kind::start; }

  /// The piece before a node, for costs that depend on it; null at the start and after a switch.
  const PathPiece* previous_piece(int n) const { return node(n).kind == Node::Kind::driven ? &node(n).piece : nullptr; }

  void push_start()
  {
    Node start;
    start.pose = request_.start;
    start.mode = request_.modes.first();
    start.h = heuristic(start);
    push(start);
  }

  /// The node of least f that is still the best of its cell.
  std::optional<int> pop()
  {
    while (!open_.empty())
    {
      const int n = open_.top().node;
      open_.pop();
      if (closed_[key(node(n))] == n) return n;
    }
    return std::nullopt;
  }

  void push(const Node& candidate)
  {
    int& best = closed_[key(candidate)];
    if (best >= 0 && node(best).g <= candidate.g) return;
    best = static_cast<int>(nodes_.size());
    nodes_.push_back(candidate);
    open_.push({candidate.g + options_.heuristic_weight * candidate.h, best});
  }

  /// Cell of (x, y, theta, mode), and of the direction of travel in a mode that follows phi.
  std::uint64_t key(const Node& n) const
  {
    const double turns = n.pose.theta / (2.0 * M_PI);
    const double heading = (turns - std::floor(turns)) * 2.0 * M_PI;
    std::uint64_t direction = 0;
    if (traits_of(n.mode).follows_phi)
    {
      direction = kFan;  // wheels free to choose
      if (n.kind == Node::Kind::driven)
        direction = static_cast<std::uint64_t>(std::lround(course_of(n.piece) * kFan / (2.0 * M_PI)) + kFan) % kFan;
    }
    const auto cell = [](double value, double size) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / size)) & 0xFFFFF);
    };
    return cell(n.pose.x - request_.goal.x, cell_size_) | cell(n.pose.y - request_.goal.y, cell_size_) << 20 |
           cell(heading, options_.heading_resolution) << 40 | static_cast<std::uint64_t>(n.mode) << 56 |
           direction << 59;
  }

  /// Direction of travel relative to the heading of a piece in a mode that follows phi.
  static double course_of(const PathPiece& piece) { return piece.length < 0.0 ? piece.phi + M_PI : piece.phi; }

  double heuristic(const Node& n) const
  {
    const double around = guide_.distance(n.pose);
    if (!options_.terminal_connection) return around;
    const double straight = distance(n.pose, request_.goal);
    if (straight > near_goal_) return around;
    return std::max(around, curves_.length_with_switches(n.pose, n.mode, request_.goal));
  }

  // --- paper Algorithm 1, lines 6 to 13 --------------------------------------------------------------------------
  bool connects_to_goal(int n)
  {
    if (!options_.terminal_connection) return is_within_tolerance(n);
    if (--until_connection_ > 0) return false;
    until_connection_ = 1 + static_cast<int>(node(n).h / (2.0 * primitive_length_));

    curves_.candidates(node(n).pose, {node(n).mode, previous_piece(n), is_start(n)}, request_.goal,
                       std::numeric_limits<double>::infinity(), candidates_);
    const std::size_t tried = std::min(kCurvesTried, candidates_.size());
    for (std::size_t i = 0; i < tried; ++i)
    {
      curves_.place(node(n).pose, candidates_[i]);
      if (!is_free(checker_, candidates_[i])) continue;
      last_ = n;
      connection_ = candidates_[i];
      return true;
    }
    return false;
  }

  bool is_within_tolerance(int n)
  {
    if (distance(node(n).pose, request_.goal) > options_.xy_goal_tolerance ||
        std::abs(wrap_angle(node(n).pose.theta - request_.goal.theta)) > options_.yaw_goal_tolerance)
      return false;
    last_ = n;
    return true;
  }

  // --- paper Algorithm 1, lines 15 to 26 -------------------------------------------------------------------------
  void expand_within_mode(int n)
  {
    if (traits_of(node(n).mode).follows_phi)
    {
      expand_translation(n);
      return;
    }
    const double phi_max = limits_[node(n).mode].phi;
    for (double phi : {0.0, phi_max, -phi_max})
      for (double direction : {1.0, -1.0})
        if (guide_.heading_step > 0.0 && phi != 0.0)
          push_turn(n, phi, direction);
        else
          push_primitive(n, phi, direction);
  }

  void expand_translation(int n)
  {
    if (guide_.way_ahead) follow_guide(n);
    if (node(n).kind == Node::Kind::driven)
    {
      const double course = course_of(node(n).piece);
      for (int turn : {0, 1, -1, 3, -3}) push_translation(n, course + turn * 2.0 * M_PI / kFan);
      return;
    }
    // At rest the wheels can be turned to any direction. Tried are those that lead closest to the goal, and straight to
    // it.
    std::array<std::pair<double, double>, kFan> fan;
    const Pose pose = node(n).pose;
    const double length = primitive_length_;
    for (int i = 0; i < kFan; ++i)
    {
      const double course = i * 2.0 * M_PI / kFan, direction = pose.theta + course;
      const Pose end = {pose.x + length * std::cos(direction), pose.y + length * std::sin(direction), pose.theta};
      fan[static_cast<std::size_t>(i)] = {guide_.distance(end), course};
    }
    std::sort(fan.begin(), fan.end());
    for (std::size_t i = 0; i < kFanTried; ++i) push_translation(n, fan[i].second);
    const Pose goal = relative_to(pose, request_.goal);
    push_translation(n, std::atan2(goal.y, goal.x));
  }

  void push_translation(int n, double course)
  {
    course = wrap_angle(course);
    const bool backward = std::abs(course) > M_PI_2 + 1e-9;
    const double phi = backward ? wrap_angle(course + M_PI) : course;
    if (std::abs(phi) <= limits_[node(n).mode].phi) push_primitive(n, phi, backward ? -1.0 : 1.0);
  }

  /// Straight to the farthest pose of the guide's way that can be seen from here.
  void follow_guide(int n)
  {
    const Pose pose = node(n).pose;
    guide_.way_ahead(pose, way_ahead_);
    for (std::size_t count = way_ahead_.size(); count > 0; count /= 2)
    {
      const Pose there = relative_to(pose, way_ahead_[count - 1]);
      const double course = std::atan2(there.y, there.x), length = std::hypot(there.x, there.y);
      const bool backward = std::abs(course) > M_PI_2 + 1e-9;
      const double phi = backward ? wrap_angle(course + M_PI) : course;
      if (std::abs(phi) > limits_[node(n).mode].phi || length < kShortest) continue;
      const PathPiece piece{node(n).mode, pose, phi, backward ? -length : length};
      if (!checker_.is_free(piece)) continue;
      push_piece(n, piece);
      return;
    }
  }

  /// An arc to the next heading in line with the guide's that is about a primitive away, or to one before it.
  void push_turn(int n, double phi, double direction)
  {
    const double step = guide_.heading_step, theta = node(n).pose.theta;
    PathPiece piece{node(n).mode, node(n).pose, phi, direction * primitive_length_};
    const double turn = curvature(robot_, piece.mode, phi) * piece.length, side = turn < 0.0 ? -1.0 : 1.0;
    const int steps = std::max(1, static_cast<int>(std::lround(std::abs(turn) / step)));
    // So many whole steps from the multiple nearest to theta.
    const double rest = std::round(theta / step) * step - theta;
    const auto length_of = [&](int count) {
      return std::max(0.0, side * rest + count * step) / std::abs(turn) * primitive_length_;
    };
    piece.length = direction * length_of(steps);
    const double free = checker_.free_length(piece);
    for (int count = steps; count > 0; count /= 2)
    {
      const double length = length_of(count);
      if (length > free + 1e-12 || length < kShortest) continue;
      piece.length = direction * length;
      push_piece(n, piece);
      return;
    }
  }

  void push_primitive(int n, double phi, double direction)
  {
    const double full = primitive_length_;
    PathPiece piece{node(n).mode, node(n).pose, phi, direction * full};
    const double free = checker_.free_length(piece);
    for (double fraction : kFractions)
    {
      if (fraction * full > free + 1e-12) continue;
      piece.length = direction * fraction * full;
      push_piece(n, piece);
      return;
    }
  }

  /// The node at the end of a piece that is free.
  void push_piece(int n, const PathPiece& piece)
  {
    Node next;
    next.piece = piece;
    next.pose = advance(robot_, piece.start, piece.mode, piece.phi, piece.length);
    next.g = node(n).g + cost_.piece(piece, previous_piece(n));
    next.parent = n;
    next.mode = piece.mode;
    next.kind = Node::Kind::driven;
    const int best = closed_[key(next)];
    if (best >= 0 && node(best).g <= next.g) return;
    next.h = heuristic(next);
    push(next);
  }

  void expand_switch(int n, Mode mode)
  {
    if (node(n).kind == Node::Kind::switched) return;  // one switch at a place is enough
    Node next;
    next.pose = node(n).pose;
    next.g = node(n).g + cost_.mode_switch(is_start(n));
    next.parent = n;
    next.mode = mode;
    next.kind = Node::Kind::switched;
    next.h = heuristic(next);
    push(next);
  }

  SearchResult finish(PlanStatus status) const
  {
    SearchResult result;
    result.status = status;
    result.expansions = expansions_;
    if (status != PlanStatus::succeeded) return result;
    std::vector<PathPiece>& pieces = result.path.pieces;
    for (int n = last_; n >= 0; n = node(n).parent)
      if (node(n).kind == Node::Kind::driven) pieces.push_back(node(n).piece);
    std::reverse(pieces.begin(), pieces.end());
    pieces.insert(pieces.end(), connection_.pieces.begin(), connection_.pieces.begin() + connection_.count);
    result.path.goal = pieces.empty() ? request_.start
                                      : advance(robot_, pieces.back().start, pieces.back().mode, pieces.back().phi,
                                                pieces.back().length);
    result.path.cost = node(last_).g + connection_.cost;
    return result;
  }

  const CollisionChecker& checker_;
  const Robot& robot_;
  const SearchOptions& options_;
  const DriveLimits limits_;
  const double primitive_length_, cell_size_, near_goal_;
  const PlanRequest request_;
  const MotionCost cost_;
  const ModeCurves curves_;
  const Guide& guide_;

  std::vector<Node> nodes_;
  std::priority_queue<OpenEntry> open_;
  ClosedList closed_;
  std::vector<ModeCurve> candidates_;
  std::vector<Pose> way_ahead_;
  ModeCurve connection_;
  int last_ = -1;
  int expansions_ = 0;
  int until_connection_ = 0;
};

}  // namespace

SearchResult hybrid_astar(const SearchProblem& problem, const SearchOptions& options, const ModeSet& modes,
                          const Guide& guide, std::vector<Pose>* expanded)
{
  const Robot& robot = problem.checker.robot();
  require_positive("reference_speed", options.v_ref(robot));
  require_positive("step_time", options.primitive_length(robot));
  require_positive("xy_resolution", options.cell_size(robot));
  require_positive("heading_resolution", options.heading_resolution);
  return HybridAStar(problem, options, modes, guide).run(problem.interrupt, expanded);
}

}  // namespace fourwis
