#include "sdo_client.h"

namespace fourwis::can
{
namespace
{

constexpr int kAttempts = 3;

bool writes(const SdoStep& step)
{
  return step.kind == SdoStep::Kind::write || step.kind == SdoStep::Kind::write_only;
}

bool is_missing_object(std::uint32_t abort_code)
{
  return abort_code == kNoSuchObject || abort_code == kNoSuchSubIndex;
}

}  // namespace

void SdoClient::start(const SdoScript& script, double now, Outbox& outbox)
{
  script_ = &script;
  position_ = 0;
  state_ = State::working;
  fault_ = Fault::count;
  detail_ = 0;
  reading_ = !writes(step());
  attempts_ = 0;
  request(now, outbox);
}

void SdoClient::receive(const Frame& frame, double now, Outbox& outbox)
{
  const auto reply = decode_sdo_reply(frame);
  // A late answer to an earlier request does not count.
  if (state_ != State::working || !reply || reply->object != step().object) return;
  accept(*reply, now, outbox);
}

void SdoClient::supervise(double now, Outbox& outbox)
{
  if (state_ != State::working || now - asked_ < timeout_) return;
  if (attempts_ >= kAttempts) return fail(Fault::sdo_timeout, 0);
  request(now, outbox);
}

void SdoClient::request(double now, Outbox& outbox)
{
  ++attempts_;
  asked_ = now;
  outbox.put(reading_ ? encode_sdo_read(node_, step().object)
                      : encode_sdo_write(node_, step().object, step().value, step().size));
}

void SdoClient::accept(const SdoReply& reply, double now, Outbox& outbox)
{
  switch (reply.kind)
  {
    case SdoReply::Kind::abort:
      if (step().optional && is_missing_object(reply.value)) return advance(now, outbox);
      return fail(Fault::sdo_abort, reply.value);
    case SdoReply::Kind::written:
      if (reading_) return;
      if (step().kind == SdoStep::Kind::write_only) return advance(now, outbox);
      reading_ = true;
      attempts_ = 0;
      return request(now, outbox);
    case SdoReply::Kind::value:
      if (!reading_) return;
      if (!is_as_wanted(reply.value)) return fail(step().mismatch, reply.value);
      return advance(now, outbox);
  }
}

void SdoClient::advance(double now, Outbox& outbox)
{
  if (++position_ == script_->size())
  {
    state_ = State::done;
    return;
  }
  reading_ = !writes(step());
  attempts_ = 0;
  request(now, outbox);
}

void SdoClient::fail(Fault fault, std::uint32_t detail)
{
  state_ = State::failed;
  fault_ = fault;
  detail_ = detail;
}

std::uint32_t SdoClient::object() const
{
  return static_cast<std::uint32_t>(step().object.index) << 8 | step().object.sub;
}

bool SdoClient::is_as_wanted(std::uint32_t value) const
{
  if (step().kind == SdoStep::Kind::expect_bits) return (value & step().value) == step().value;
  const std::uint32_t size = step().size < 4 ? (1u << (8 * step().size)) - 1u : 0xFFFFFFFF;
  return ((value ^ step().value) & step().compared & size) == 0;
}

}  // namespace fourwis::can
