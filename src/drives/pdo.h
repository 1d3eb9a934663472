#pragma once

#include <array>
#include <optional>
#include <vector>

#include "drive_objects.h"
#include "fourwis_navigation/can/protocol/frame.h"
#include "frames.h"

namespace fourwis::drives
{

/// Writes received process data into the objects to which it is mapped.
class ReceivePdos
{
public:
  explicit ReceivePdos(ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  enum class Outcome
  {
    not_ours,
    taken,     ///< written at once, or with the next SYNC
    too_short  ///< fewer bytes than are mapped; more bytes are allowed
  };
  Outcome receive(const can::Frame& frame);

  /// Writes the data that came since the last SYNC.
  void sync();
  void reset() { waiting_ = {}; }

private:
  void apply(int pdo, const can::Frame& frame);

  ObjectDictionary& dictionary_;
  std::array<std::optional<can::Frame>, kPdos> waiting_;
};

/// Sends the mapped objects, with SYNC or when they have changed. Times in s.
class TransmitPdos
{
public:
  explicit TransmitPdos(const ObjectDictionary& dictionary) : dictionary_(dictionary) {}

  /// The node has become operational: all data counts as new.
  void start();
  /// Sends with every n-th SYNC if the transmission type is n.
  void sync(const FrameSink& send);
  /// Sends event-driven PDOs: on change, at intervals of at least the inhibit time and at most the event timer.
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
