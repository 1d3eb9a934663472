#pragma once

#include "fourwis_navigation/optimize/segment_optimizer.h"

namespace fourwis
{

/// The same problem as SegmentOptimizer's, on Ipopt. It is slower, but another algorithm, so tests compare the
/// structured solver with it. Only one thread solves at a time; others wait.
class IpoptSegmentOptimizer
{
public:
  /// Keeps references to robot and options. Throws as their check() does, and unless the reference speed is positive and
  /// finite.
  IpoptSegmentOptimizer(const Robot& robot, const OptimizeOptions& options, double reference_speed);

  /// As SegmentOptimizer::solve(). A segment or corridor that is not valid is not solved. Throws std::logic_error where
  /// has_ipopt() is false.
  SegmentSolution solve(const SegmentTask& task, double tolerance, const Interrupt& interrupt) const;

private:
  const Robot& robot_;
  const OptimizeOptions& options_;
  double reference_speed_;
};

}  // namespace fourwis
