#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bus_directory.h"
#include "fourwis_navigation/can/bus/bus.h"
#include "fourwis_navigation/can/bus/file_descriptor.h"

namespace fourwis::can
{

/// A bus among the processes of one user on one machine, without CAN in the kernel and without a broker: each end
/// listens at a socket in the BusDirectory and connects to those of all others. Of a process that died nothing remains
/// but its file, which the next to send to it removes. Down when the directory is taken away. What reaches a peer is
/// limited by the send buffer of one connection (net.core.wmem_default): a datagram socket would hold ten frames
/// (net.unix.max_dgram_qlen).
class UnixBus final : public Bus
{
public:
  explicit UnixBus(std::string name);
  ~UnixBus() override;

  BusStatus send(const Frame& frame) override;
  BusStatus receive(Frame& frame) override;
  int descriptor() const override { return events_.get(); }
  bool recover() override;
  BusCounters counters() const override { return counters_; }
  std::string_view last_error() const override { return error_; }

private:
  /// A connection to another end. Frames are numbered on each, so that the other knows of those it had no room for.
  struct Connection
  {
    FileDescriptor socket;
    std::uint64_t next = 0;  ///< number of the frame to come
    std::string file;        ///< of the end to send to
  };

  bool is_down() const { return directory_ == nullptr; }
  void open();
  void go_down(const std::string& why);
  void watch(int descriptor);
  void listen();
  bool accept();
  void notice();
  void connect_to_ends();
  void connect(const std::string& file);
  bool hand_over(const Frame& frame, Connection& to);
  bool take(int descriptor, Frame& frame);

  std::string name_;
  std::string error_;
  BusCounters counters_;
  std::unique_ptr<BusDirectory> directory_;  ///< none while down
  std::string own_file_;
  FileDescriptor events_;  ///< epoll over the directory, the listener and `from_`
  FileDescriptor listener_;
  std::vector<Connection> to_, from_;
  bool unconnected_ = false;  ///< there is an end to which the connection failed; it is tried again
};

}  // namespace fourwis::can
