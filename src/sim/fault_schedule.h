#pragma once

#include <vector>

#include "fourwis_navigation/sim/drive_fault.h"

namespace fourwis::sim
{

/// Faults and when they are.
class FaultSchedule
{
public:
  void add(const DriveFault& fault) { faults_.push_back(fault); }
  void clear() { faults_.clear(); }

  /// Time goes on [s].
  void advance(double now)
  {
    before_ = now_;
    now_ = now;
  }

  /// The fault of this kind at this node that there is now; null where there is none.
  const DriveFault* active(DriveFaultKind kind, int node) const
  {
    for (const DriveFault& fault : faults_)
      if (fault.kind == kind && fault.node == node && is_active(fault)) return &fault;
    return nullptr;
  }

  template <class Function>
  void for_each_active(Function&& act) const
  {
    for (const DriveFault& fault : faults_)
      if (is_active(fault)) act(fault);
  }

  /// It began with the last step.
  bool has_just_begun(const DriveFault& fault) const { return fault.begin > before_ && is_active(fault); }

private:
  bool is_active(const DriveFault& fault) const { return fault.begin <= now_ && now_ < fault.end; }

  std::vector<DriveFault> faults_;
  double before_ = -1.0, now_ = -1.0;
};

}  // namespace fourwis::sim
