#pragma once

#include <utility>

#include "fourwis_navigation/ocp/start.h"
#include "random_problem.h"

namespace fourwis::ocp
{

/// A random problem with curved dynamics and rows, at a random point inside of its bounds.
struct RandomPoint
{
  static constexpr int NX = 4, NU = 2, NR = 3, NW = 1, NZ = NX + NU;
  using Model = RandomModel<NX, NU, NR, NW>;
  using Point = Iterate<NX, NU>;

  Random random;
  std::size_t intervals = 5;
  Model model;
  Constraints<NX, NU> limits;
  Point point;

  explicit RandomPoint(unsigned seed) : random(seed), model(intervals, 4.0, 0.1, random)
  {
    limits.set(random_problem(model, Model::kMostRows, random));
    point = new_point();
    for (std::size_t k = 0; k <= intervals; ++k) set_stage(k);
    for (std::size_t i = 0; i < limits.rows.size(); ++i)
    {
      const double weight = limits.rows[i].weight, y = 2.0 + random.unit();
      point.rows[i] = {2.0 + random.unit(), std::isfinite(weight) ? 2.0 + random.unit() : 0.0, y, weight - y};
    }
    for (int i = 0; i < NX; ++i) point.nu[i] = limits.is_fixed(i) ? random.unit() : 0.0;
  }

  Point new_point() const
  {
    Point result;
    result.resize(intervals + 1, limits.rows.size());
    return result;
  }

  Values<NX> values(const Point& at) const
  {
    Values<NX> result;
    result.resize(intervals, limits.rows.size());
    evaluate(model, limits, at, result);
    return result;
  }

  Derivatives<Model> derivatives(const Point& at) const
  {
    Derivatives<Model> result;
    result.resize(intervals + 1, limits.rows.size());
    std::vector<double> y(limits.rows.size());
    differentiate(model, limits, at, y, result);
    return result;
  }

private:
  void set_stage(std::size_t k)
  {
    auto& stage = point.stages[k];
    stage.z = random_matrix<NZ, 1>(random);
    if (k == 0) stage.z.head<NX>() = limits.initial_state;
    if (k == intervals) stage.z.tail<NU>().setZero();
    stage.lambda = random_matrix<NX, 1>(random);
    for (int i = 0; i < NZ; ++i)
    {
      const double lower = limits.bounds[k].lower[i], upper = limits.bounds[k].upper[i];
      stage.z[i] = detail::moved_inside(stage.z[i], lower, upper, 0.1);
      stage.lower[i] = lower > -kInfinity ? 2.0 + random.unit() : 0.0;
      stage.upper[i] = upper < kInfinity ? 2.0 + random.unit() : 0.0;
    }
  }
};

}  // namespace fourwis::ocp
