#pragma once

#include <vector>

#include "fourwis_navigation/drives/drive_fault.h"

namespace fourwis::drives
{

/// Faults with their times.
class FaultSchedule
{
public:
  void add(const DriveFault& fault) { entries_.push_back({fault, Stage::to_come}); }
  void clear() { entries_.clear(); }

  /// Advances the time [s]. A fault whose beginning has passed begins now.
  void advance(double now)
  {
    for (Entry& entry : entries_)
    {
      const bool active = entry.fault.begin <= now && now < entry.fault.end;
      if (!active)
        entry.stage = entry.fault.begin <= now ? Stage::over : Stage::to_come;
      else
        entry.stage = entry.stage == Stage::to_come ? Stage::begins : Stage::goes_on;
    }
  }

  /// The active fault of this kind at this node; null if there is none.
  const DriveFault* active(DriveFaultKind kind, int node) const
  {
    for (const Entry& entry : entries_)
      if (entry.fault.kind == kind && entry.fault.node == node && is_active(entry)) return &entry.fault;
    return nullptr;
  }

  /// Calls act(fault, begins) for each active fault; `begins`: it begins with this step.
  template <class Function>
  void for_each_active(Function&& act) const
  {
    for (const Entry& entry : entries_)
      if (is_active(entry)) act(entry.fault, entry.stage == Stage::begins);
  }

private:
  enum class Stage
  {
    to_come,
    begins,
    goes_on,
    over
  };
  struct Entry
  {
    DriveFault fault;
    Stage stage;
  };
  static bool is_active(const Entry& entry) { return entry.stage == Stage::begins || entry.stage == Stage::goes_on; }

  std::vector<Entry> entries_;
};

}  // namespace fourwis::drives
