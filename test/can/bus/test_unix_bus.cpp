#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "../../support/fuzz_rounds.h"
#include "../../support/random.h"
#include "bus_laws.h"
#include "temporary_directory.h"

namespace fourwis::can
{
namespace
{

namespace fs = std::filesystem;

/// The bus `unix:test` in a directory of its own. It goes down when a file replaces the directory.
class UnixRig
{
public:
  UnixRig() { setenv("XDG_RUNTIME_DIR", directory_.path().c_str(), 1); }

  std::unique_ptr<Bus> open() { return open_bus("unix:test"); }
  void take_down()
  {
    fs::remove_all(ends());
    fs::create_directory(ends().parent_path());
    fs::permissions(ends().parent_path(), fs::perms::owner_all);
    std::ofstream(ends()) << "not a directory";
  }
  void bring_up() { fs::remove(ends()); }

  fs::path ends() const { return fs::path(directory_.path()) / "fourwis_can" / "test"; }
  std::size_t files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(ends()), fs::directory_iterator()));
  }

private:
  TemporaryDirectory directory_;
};
INSTANTIATE_TYPED_TEST_SUITE_P(Unix, BusLaws, UnixRig);

using UnixBusTest = BusLaws<UnixRig>;

/// Runs `child` in a process of its own, which never returns.
template <typename Child>
pid_t in_another_process(Child child)
{
  const pid_t process = fork();
  if (process != 0) return process;
  child();
  _exit(0);
}

TEST_F(UnixBusTest, ReachesOtherProcesses)
{
  const auto here = rig.open();
  const pid_t echo = in_another_process([this] {
    const auto there = rig.open();
    there->send({0x10, false, false, false, 0, {}});
    Frame frame = next_frame(*there);
    frame.id = 0x12;
    there->send(frame);
  });
  EXPECT_EQ(next_frame(*here).id, 0x10u);
  const Frame question{0x11, false, false, false, 3, {1, 2, 3}};
  here->send(question);
  const Frame answer = next_frame(*here);
  EXPECT_EQ(answer.id, 0x12u);
  EXPECT_EQ(answer.data, question.data);
  waitpid(echo, nullptr, 0);
}

TEST_F(UnixBusTest, OutlivesAKilledProcessAndRemovesWhatItLeft)
{
  const auto here = rig.open(), other = rig.open();
  const pid_t process = in_another_process([this] {
    const auto there = rig.open();
    there->send({0x10, false, false, false, 0, {}});
    while (true) pause();
  });
  EXPECT_EQ(next_frame(*here).id, 0x10u);
  EXPECT_EQ(next_frame(*other).id, 0x10u);
  EXPECT_EQ(rig.files(), 3u);
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  expect_connected(*here, *other);
  EXPECT_EQ(rig.files(), 2u);
  const auto late = rig.open();
  expect_connected(*here, *late);
}

TEST_F(UnixBusTest, ANewEndRemovesWhatKilledOnesLeft)
{
  for (int n = 0; n < 3; ++n)
  {
    const pid_t process = in_another_process([this] {
      const auto there = rig.open();
      raise(SIGKILL);
    });
    waitpid(process, nullptr, 0);
  }
  const auto first = rig.open(), second = rig.open();
  EXPECT_EQ(rig.files(), 2u);
  expect_connected(*first, *second);
}

TEST_F(UnixBusTest, AnEndThatLeavesTakesItsFileAlong)
{
  {
    const auto first = rig.open(), second = rig.open();
    EXPECT_EQ(rig.files(), 2u);
  }
  EXPECT_EQ(rig.files(), 0u);
}

TEST_F(UnixBusTest, HoldsSomeCyclesForAnEndThatIsBusy)
{
  const auto sender = rig.open(), busy = rig.open();
  for (int n = 0; n < 200; ++n) ASSERT_EQ(sender->send(numbered(0, n)), BusStatus::ok);
  for (int n = 0; n < 200; ++n) ASSERT_EQ(next_frame(*busy), numbered(0, n));
  EXPECT_EQ(busy->counters().dropped, 0u);
}

/// One of several ends that all send `frames` frames at once, and never more than a window ahead of what they have
/// read.
void take_part(Bus& bus, std::size_t self, std::size_t ends, int frames)
{
  constexpr int kWindow = 50;
  std::vector<int> read(ends, 0);
  read[self] = frames;
  const auto slowest = [&] { return *std::min_element(read.begin(), read.end()); };
  for (int sent = 0; sent < frames || slowest() < frames;)
  {
    Frame frame;
    if (sent < frames && sent < slowest() + kWindow)
    {
      frame = {static_cast<std::uint32_t>(self),
               false,
               false,
               false,
               2,
               {static_cast<std::uint8_t>(sent), static_cast<std::uint8_t>(sent >> 8)}};
      ASSERT_EQ(bus.send(frame), BusStatus::ok);
      ++sent;
    }
    if (bus.receive(frame) != BusStatus::ok) continue;
    ASSERT_NE(frame.id, self);
    ASSERT_EQ(frame.data[0] + 256 * frame.data[1], read[frame.id]++);
  }
}

TEST_F(UnixBusTest, LosesNothingWhileManySendAndOthersComeAndGo)
{
  constexpr int kEnds = 3, kFrames = 2000;
  std::vector<std::unique_ptr<Bus>> ends;
  for (int i = 0; i < kEnds; ++i) ends.push_back(rig.open());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kEnds; ++i) threads.emplace_back([&, i] { take_part(*ends[i], i, kEnds, kFrames); });
  for (int n = 0; n < 100; ++n) EXPECT_TRUE(rig.open()->recover());
  for (std::thread& thread : threads) thread.join();
  for (const auto& end : ends) EXPECT_EQ(end->counters().dropped, 0u);
  EXPECT_EQ(rig.files(), static_cast<std::size_t>(kEnds));
}

TEST_F(UnixBusTest, BusesOfDifferentNamesHearNothingOfEachOther)
{
  const auto a = rig.open(), b = rig.open(), other = open_bus("unix:other");
  expect_connected(*a, *b);
  expect_silence(*other);
}

/// A socket that belongs to no bus and is connected to the end `file`.
int connect_to(const fs::path& file)
{
  const int socket = ::socket(AF_UNIX, SOCK_SEQPACKET, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  file.string().copy(address.sun_path, sizeof address.sun_path - 1);
  EXPECT_EQ(connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return socket;
}

TEST_F(UnixBusTest, IgnoresGarbage)
{
  const auto end = rig.open();
  const int rogue = connect_to(fs::directory_iterator(rig.ends())->path());
  Random random(11);
  for (int n = 0; n < fuzz_rounds(5000); ++n)
  {
    unsigned char bytes[64];
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random.whole(0, 255));
    const std::size_t size = random.chance(0.5) ? 24 : static_cast<std::size_t>(random.whole(1, 64));
    if (send(rogue, bytes, size, MSG_DONTWAIT) < 0) break;
    Frame frame;
    const bool received = end->receive(frame) == BusStatus::ok;
    EXPECT_TRUE(!received || is_valid(frame));
  }
  EXPECT_GT(end->counters().invalid, 1000u);
  close(rogue);
  const auto other = rig.open();
  expect_connected(*end, *other);
}

TEST_F(UnixBusTest, IsPrivate)
{
  const auto end = rig.open();
  for (const fs::path& path : {rig.ends(), rig.ends().parent_path()})
  {
    struct stat found;
    ASSERT_EQ(stat(path.c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777, 0700u);
  }
  fs::create_directory(rig.ends().parent_path() / "open");
  fs::permissions(rig.ends().parent_path() / "open", fs::perms::all);
  const auto refused = open_bus("unix:open");
  EXPECT_FALSE(refused->recover());
  EXPECT_NE(refused->last_error().find("not private"), std::string::npos);
}

TEST_F(UnixBusTest, APathTooLongForASocketIsSaid)
{
  const fs::path deep = rig.ends().parent_path().parent_path() / std::string(100, 'x');
  fs::create_directory(deep);
  setenv("XDG_RUNTIME_DIR", deep.c_str(), 1);
  const auto end = rig.open();
  EXPECT_FALSE(end->recover());
  EXPECT_NE(end->last_error().find("too long"), std::string::npos) << end->last_error();
}

}  // namespace
}  // namespace fourwis::can
