#include "communication.h"

#include <cmath>

#include "errors.h"
#include "sdo_server.h"

namespace fourwis::drives
{
namespace
{

/// NMT commands.
constexpr std::uint8_t kStart = 1, kStop = 2, kPreOperational = 128, kResetNode = 129, kResetCommunication = 130;

/// Values of 1029:1: the change of the NMT state when the master is lost.
constexpr int kToPreOperational = 0, kToStopped = 2;

}  // namespace

Communication::Communication(ObjectDictionary& dictionary, std::uint8_t node, FrameSink send)
  : dictionary_(dictionary),
    node_(node),
    send_(std::move(send)),
    receive_pdos_(dictionary),
    transmit_pdos_(dictionary)
{}

void Communication::boot()
{
  send_(data_frame(cob::kHeartbeat + node_, 1));
  enter(NmtState::pre_operational);
}

CommunicationEvent Communication::receive(double now, const can::Frame& frame)
{
  if (!is_plain(frame) || state_ == NmtState::initialising) return CommunicationEvent::none;
  if (frame.id == cob::kNmt)
  {
    const bool for_us = frame.size == 2 && (frame.data[1] == 0 || frame.data[1] == node_);
    return for_us ? manage(frame.data[0]) : CommunicationEvent::none;
  }
  watch_heartbeat(now, frame);
  if (state_ == NmtState::stopped) return CommunicationEvent::none;
  if (frame.id == cob::kSdoRequest + node_)
  {
    if (const auto reply = answer_sdo(dictionary_, node_, frame)) send_(*reply);
  }
  else if (state_ == NmtState::operational)
    receive_process_data(frame);
  return CommunicationEvent::none;
}

CommunicationEvent Communication::manage(std::uint8_t command)
{
  switch (command)
  {
    case kStart: enter(NmtState::operational); break;
    case kPreOperational: enter(NmtState::pre_operational); break;
    case kStop: enter(NmtState::stopped); return CommunicationEvent::connection_lost;
    case kResetNode: return CommunicationEvent::reset_node;
    case kResetCommunication: return CommunicationEvent::reset_communication;
    default: break;
  }
  return CommunicationEvent::none;
}

void Communication::enter(NmtState state)
{
  if (state == state_) return;
  state_ = state;
  receive_pdos_.reset();
  transmit_pdos_.start();
}

/// With a SYNC, TPDOs are sampled before RPDOs take effect.
void Communication::receive_process_data(const can::Frame& frame)
{
  if (frame.id == cob::kSync)
  {
    transmit_pdos_.sync(send_);
    receive_pdos_.sync();
  }
  else if (receive_pdos_.receive(frame) == ReceivePdos::Outcome::too_short)
    raise(kPdoTooShort);
}

void Communication::watch_heartbeat(double now, const can::Frame& frame)
{
  consumer_.configure(dictionary_.get(object::kHeartbeatConsumer, 1));
  const bool is_heartbeat = frame.size == 1 && frame.data[0] != 0 && frame.id == cob::kHeartbeat + consumer_.node();
  if (!is_heartbeat) return;
  consumer_.heard(now);
  if (dictionary_.get(object::kErrorCode) == kHeartbeatLost) clear();
}

CommunicationEvent Communication::watch(double now)
{
  if (state_ == NmtState::initialising) return CommunicationEvent::none;
  if (producer_.is_due(now, dictionary_.get(object::kHeartbeatProducer)))
  {
    can::Frame heartbeat = data_frame(cob::kHeartbeat + node_, 1);
    heartbeat.data[0] = static_cast<std::uint8_t>(state_);
    send_(heartbeat);
  }
  consumer_.configure(dictionary_.get(object::kHeartbeatConsumer, 1));
  if (!consumer_.has_lost(now)) return CommunicationEvent::none;
  lose_master(now);
  return CommunicationEvent::connection_lost;
}

/// The emergency says for how long the master has been silent, [ms] in the manufacturer's bytes 3 and 4.
void Communication::lose_master(double now)
{
  can::Frame emergency = record_error(dictionary_, node_, kHeartbeatLost);
  put_bytes(emergency, 3, 2, static_cast<std::uint32_t>(std::lround(consumer_.silence(now) * 1e3)));
  send_emergency(emergency);
  const auto behaviour = dictionary_.get(object::kErrorBehaviour, 1);
  if (behaviour == kToStopped) enter(NmtState::stopped);
  if (behaviour == kToPreOperational && state_ == NmtState::operational) enter(NmtState::pre_operational);
}

void Communication::publish(double now)
{
  if (state_ == NmtState::operational) transmit_pdos_.poll(now, send_);
}

void Communication::raise(std::uint16_t code)
{
  send_emergency(record_error(dictionary_, node_, code));
}

void Communication::clear()
{
  send_emergency(clear_errors(dictionary_, node_));
}

/// A node that is stopped or boots does not send it.
void Communication::send_emergency(const can::Frame& frame)
{
  if (state_ == NmtState::operational || state_ == NmtState::pre_operational) send_(frame);
}

}  // namespace fourwis::drives
