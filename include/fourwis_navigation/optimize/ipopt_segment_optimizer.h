#pragma once

#include "fourwis_navigation/optimize/segment_optimizer.h"

namespace fourwis
{

/// SegmentOptimizer's problem, the very same, on Ipopt: slower, but another algorithm: what tests compare the
/// structured solver with. Solves of several threads wait for one another.
class IpoptSegmentOptimizer
{
public:
  /// Keeps references to robot and options. Throws as their check() does, and unless the reference speed is positive and
  /// finite.
  IpoptSegmentOptimizer(const Robot& robot, const OptimizeOptions& options, double reference_speed);

  /// As SegmentOptimizer::solve(). A segment or corridor that makes no sense is not solved.
  /// Throws std::logic_error where has_ipopt() is false.
  SegmentSolution solve(const SegmentTask& task, double tolerance, const Interrupt& interrupt) const;

private:
  const Robot& robot_;
  const OptimizeOptions& options_;
  double reference_speed_;
};

}  // namespace fourwis
