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

/// A bus among the processes of one user on one machine, without CAN in the kernel and without a broker. Each end
/// listens at a socket in the BusDirectory and connects to those of all other ends. A process that died leaves its file
/// behind; the next end that sends to it removes the file. The bus is down when the directory is removed. The frames
/// that wait for a peer are limited by the send buffer of one connection (net.core.wmem_default). A datagram socket
/// would hold only ten (net.unix.max_dgram_qlen).
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
  /// A connection to another end. Its frames are numbered, so that the other end can count those that were lost.
  struct Connection
  {
    FileDescriptor socket;
    std::uint64_t next = 0;  ///< number of the next frame
    std::string file;        ///< of the other end
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
