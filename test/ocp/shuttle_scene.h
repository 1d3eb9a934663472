#pragma once

#include <functional>

#include "models.h"

namespace fourwis::ocp
{

/// A problem that has a solution, to be spoilt.
struct ShuttleScene
{
  static constexpr std::size_t kIntervals = 10;

  Problem<2, 2> problem = Shuttle::problem(1.0, 2.0, kIntervals);
  Trajectory<2, 2> guess = Shuttle::guess(1.0, kIntervals);
  Options options;

  ShuttleScene()
  {
    options.max_iterations = 200;
    for (auto& bounds : problem.bounds) bounds.upper[1] = 5.0;
  }

  template <class Model = Shuttle>
  Solution<2, 2> solve(const Model& model = {}) const
  {
    Solver<Model> solver;
    return solver.solve(model, problem, guess, options);
  }

  using Change = std::function<void(ShuttleScene&)>;

  static Solution<2, 2> solved_after(const Change& change)
  {
    ShuttleScene scene;
    change(scene);
    return scene.solve();
  }
};

}  // namespace fourwis::ocp
