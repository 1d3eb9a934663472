#include "../can/bus/bus_laws.h"
#include "vcan_rig.h"

namespace fourwis::can
{
namespace
{

/// vcan0 with a bus that is slower than any machine. Its queue holds `bytes`, 16 per frame.
class DisciplinedVcan : public VcanRig
{
public:
  explicit DisciplinedVcan(int bytes)
  {
    run("tc qdisc add dev vcan0 root tbf rate 8kbit burst 80 limit " + std::to_string(bytes));
  }
  ~DisciplinedVcan() { run("tc qdisc delete dev vcan0 root"); }
};

/// Sends until there is no room. Returns the number of frames.
int fill(Bus& bus)
{
  int sent = 0;
  while (sent < 10000 && bus.send(numbered(0, sent)) == BusStatus::ok) ++sent;
  return sent;
}

TEST(TransmitQueue, RefusesBeforeFramesGrowOldAndSaysWhenThereIsRoom)
{
  DisciplinedVcan rig(16000);
  const auto sender = rig.open(), reader = rig.open();
  const int sent = fill(*sender);
  EXPECT_GE(sent, 8) << "a cycle of commands has room";
  EXPECT_LE(sent, 25);
  EXPECT_EQ(sender->send(numbered(0, sent)), BusStatus::would_block);
  EXPECT_EQ(sender->counters().refused, 2u);
  for (int n = 0; n < sent; ++n) EXPECT_EQ(next_frame(*reader), numbered(0, n));
  pollfd wait{sender->descriptor(), POLLOUT, 0};
  EXPECT_EQ(poll(&wait, 1, 10000), 1);
  EXPECT_EQ(sender->send(numbered(0, 0)), BusStatus::ok);
  EXPECT_EQ(next_frame(*reader), numbered(0, 0));
}

TEST(TransmitQueue, AShortQueueRefusesWhileTheBufferHasRoom)
{
  DisciplinedVcan rig(64);
  const auto sender = rig.open(), reader = rig.open();
  const int sent = fill(*sender);
  EXPECT_GE(sent, 4);
  EXPECT_LE(sent, 12);
  for (int n = 0; n < sent; ++n) EXPECT_EQ(next_frame(*reader), numbered(0, n));
  expect_silence(*reader);
  EXPECT_EQ(sender->send(numbered(0, 0)), BusStatus::ok);
}

}  // namespace
}  // namespace fourwis::can
