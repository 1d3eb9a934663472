#pragma once

#include <cstdint>

#include "fourwis_navigation/drives/nmt_state.h"
#include "heartbeat.h"
#include "pdo.h"

namespace fourwis::drives
{

/// Events for the other half of the device.
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

  /// Sends the boot-up message and becomes pre-operational.
  void boot();
  CommunicationEvent receive(double now, const can::Frame& frame);
  /// Sends the heartbeat when it is due, and watches that of the master.
  CommunicationEvent watch(double now);
  /// Sends process data that has changed.
  void publish(double now);

  void raise(std::uint16_t code);  ///< reports an error
  void clear();                    ///< reports that there is no error any more

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
