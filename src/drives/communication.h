#pragma once

#include <cstdint>

#include "fourwis_navigation/drives/nmt_state.h"
#include "heartbeat.h"
#include "pdo.h"

namespace fourwis::drives
{

/// What the other half of the device must know of.
enum class CommunicationEvent
{
  none,
  connection_lost,  ///< the master's heartbeat is lost, or it has stopped the node
  reset_node,
  reset_communication
};

/// The CiA 301 half of a device: NMT, SDO, PDO, SYNC, EMCY, heartbeats. Times in s.
class Communication
{
public:
  Communication(ObjectDictionary& dictionary, std::uint8_t node, FrameSink send);

  /// Says hello and is pre-operational from here on.
  void boot();
  CommunicationEvent receive(double now, const can::Frame& frame);
  /// Sends the heartbeat that is due, watches the master's.
  CommunicationEvent watch(double now);
  /// Sends process data that has changed.
  void publish(double now);

  void raise(std::uint16_t code);  ///< an error
  void clear();                    ///< no error any more

  NmtState state() const { return state_; }

private:
  CommunicationEvent manage(std::uint8_t command);
  void enter(NmtState state);
  void receive_process_data(const can::Frame& frame);
  void watch_heartbeat(double now, const can::Frame& frame);
  void lose_master(double now);
  void send_emergency(const can::Frame& frame);

  ObjectDictionary& dictionary_;
  std::uint8_t node_;
  FrameSink send_;
  NmtState state_ = NmtState::initialising;
  ReceivePdos receive_pdos_;
  TransmitPdos transmit_pdos_;
  HeartbeatProducer producer_;
  HeartbeatConsumer consumer_;
};

}  // namespace fourwis::drives
