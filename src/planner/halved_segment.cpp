#include "halved_segment.h"

#include "fourwis_navigation/optimize/simpson.h"

namespace fourwis
{
namespace
{

/// The motion from a point on, `t` later.
TrajectoryPoint later(const SimpsonDynamics& dynamics, const TrajectoryPoint& p, double t)
{
  SimpsonDynamics::State x;
  x << p.x, p.y, p.theta, p.v, p.phi;
  x = dynamics.next(x, SimpsonDynamics::Control(p.a, p.omega, t));
  return {p.t + t, p.mode, x[0], x[1], x[2], x[3], x[4], p.a, p.omega};
}

}  // namespace

HalvedSegment::HalvedSegment(const Robot& robot, const Trajectory& solution)
{
  reference.mode = solution.front().mode;
  const SimpsonDynamics dynamics(robot, reference.mode);
  for (std::size_t k = 0; k < solution.size(); ++k)
  {
    if (k > 0) points.push_back(later(dynamics, solution[k - 1], (solution[k].t - solution[k - 1].t) / 2.0));
    points.push_back(solution[k]);
  }
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    reference.knots.push_back(points[k].pose());
    if (k == 0) continue;
    const TrajectoryPoint &from = points[k - 1], &to = points[k];
    reference.phi.push_back((from.phi + to.phi) / 2.0);
    reference.length.push_back((from.v + to.v) / 2.0 * (to.t - from.t));
  }
}

}  // namespace fourwis
