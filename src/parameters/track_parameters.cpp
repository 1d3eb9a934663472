#include "parameter_table.h"

namespace fourwis
{
namespace
{

/// The ranges are the tracker's own.
const ParameterTable<TrackOptions>& track_table()
{
  static const ParameterTable<TrackOptions> table = [] {
    ParameterTable<TrackOptions> rows;
    for (const TrackOptionRange& range : track_option_ranges())
    {
      const auto slot = [member = range.member](TrackOptions& options) {
        return std::visit([&](auto number) -> Slot { return &(options.*number); }, member);
      };
      rows.push_back({range.name, slot, range.min, range.max, range.unit});
    }
    return rows;
  }();
  return table;
}

}  // namespace

TrackOptions track_options_from(const ParameterMap& parameters)
{
  return options_from(track_table(), parameters);
}

}  // namespace fourwis
