#pragma once

#include <array>
#include <optional>
#include <vector>

#include "drive_objects.h"
#include "fourwis_navigation/can/protocol/frame.h"
#include "frames.h"

namespace fourwis::drives
{

/// Takes process data from the bus into the objects it is mapped to.
class ReceivePdos
{
public:
  explicit ReceivePdos(ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  enum class Outcome
  {
    not_ours,
    taken,     ///< at once, or at the next SYNC
    too_short  ///< fewer bytes than are mapped; more than that do no harm
  };
  Outcome receive(const can::Frame& frame);

  /// Puts into effect what came since the last SYNC.
  void sync();
  void forget() { waiting_ = {}; }

private:
  void apply(int pdo, const can::Frame& frame);

  ObjectDictionary& dictionary_;
  std::array<std::optional<can::Frame>, kPdos> waiting_;
};

/// Sends the objects mapped, with SYNC or when they have changed. Times in s.
class TransmitPdos
{
public:
  explicit TransmitPdos(const ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  /// Everything counts as new: the node has become operational.
  void start();
  /// With every n-th SYNC, where the transmission type is n.
  void sync(const FrameSink& send);
  /// What goes by event: on change, no more often than the inhibit time, no less often than the event timer.
  void poll(double now, const FrameSink& send);

private:
  struct Sent
  {
    std::optional<can::Frame> frame;
    double time = 0.0;
    int syncs = 0;  ///< since then
  };
  bool is_due(int pdo, const can::Frame& frame, double now) const;

  const ObjectDictionary& dictionary_;
  std::array<Sent, kPdos> last_;
};

}  // namespace fourwis::drives
