#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include "ocp_elements.h"

namespace fourwis
{

/// The optimal-control problem of ocp/solver.h as a nonlinear program: first x_0, u_0, x_1, ... x_N, then the excesses.
/// Keeps a reference to the model. The sizes of problem and guess must fit.
template <class Model>
class OcpNlp
{
public:
  static constexpr int NX = Model::kStates, NU = Model::kControls, NZ = NX + NU;
  using Problem = ocp::Problem<NX, NU>;
  using Trajectory = ocp::Trajectory<NX, NU>;

  OcpNlp(const Model& model, const Problem& problem, const Trajectory& guess) : intervals_(problem.intervals())
  {
    for (std::size_t k = 0; k <= intervals_; ++k) add_variables(problem, guess, k);
    for (std::size_t k = 0; k < intervals_; ++k)
      nlp_.elements.push_back(std::make_unique<StageElement<Model>>(model, k, first_variable(k)));
    nlp_.elements.push_back(std::make_unique<TerminalElement<Model>>(model, leading(intervals_, NX)));
    auto limit = problem.rows.begin();
    for (std::size_t k = 0; k <= intervals_; limit += problem.row_counts[k], ++k)
      if (problem.row_counts[k] > 0) add_rows(model, k, {limit, limit + problem.row_counts[k]});
  }

  const Nlp& nlp() const { return nlp_; }

  /// What the program's variables mean.
  Trajectory trajectory(const std::vector<double>& x) const
  {
    Trajectory result;
    for (std::size_t k = 0; k <= intervals_; ++k)
    {
      result.states.emplace_back(Eigen::Map<const ocp::Vector<NX>>(&x[k * NZ]));
      if (k < intervals_) result.controls.emplace_back(Eigen::Map<const ocp::Vector<NU>>(&x[k * NZ + NX]));
    }
    return result;
  }

  /// Greatest excess of a row.
  double greatest_excess(const std::vector<double>& x) const
  {
    const auto first = x.begin() + first_variable(intervals_) + NX;
    return first == x.end() ? 0.0 : *std::max_element(first, x.end());
  }

private:
  /// Where the excesses start: inside of their bounds.
  static constexpr double kExcess = 1e-2;

  static int first_variable(std::size_t k) { return static_cast<int>(k) * NZ; }

  /// The first `count` components of (x_k, u_k), as far as there are as many.
  std::vector<int> leading(std::size_t k, int count) const
  {
    std::vector<int> result(static_cast<std::size_t>(k < intervals_ ? count : std::min(count, NX)));
    std::iota(result.begin(), result.end(), first_variable(k));
    return result;
  }

  void add_variables(const Problem& problem, const Trajectory& guess, std::size_t k)
  {
    for (int i = 0; i < (k < intervals_ ? NZ : NX); ++i)
    {
      double lower = problem.bounds[k].lower[i], upper = problem.bounds[k].upper[i];
      if (i < NX && k == 0) lower = upper = problem.initial_state[i];
      if (i < NX && k == intervals_ && problem.terminal_fixed[static_cast<std::size_t>(i)])
        lower = upper = problem.terminal_state[i];
      nlp_.add_variable(lower, upper, i < NX ? guess.states[k][i] : guess.controls[k][i - NX]);
    }
  }

  void add_rows(const Model& model, std::size_t k, const std::vector<ocp::RowLimit>& limits)
  {
    std::vector<int> excess;
    excess.reserve(limits.size());
    for (const ocp::RowLimit& limit : limits)
      excess.push_back(std::isfinite(limit.weight) ? nlp_.add_variable(0.0, ocp::kInfinity, kExcess) : -1);
    nlp_.elements.push_back(
        std::make_unique<RowsElement<Model>>(model, k, leading(k, Model::kRowPoint), excess, limits));
  }

  std::size_t intervals_;
  Nlp nlp_;
};

}  // namespace fourwis
