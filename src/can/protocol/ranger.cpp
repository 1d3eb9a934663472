#include "fourwis_navigation/can/protocol/ranger.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bytes.h"

namespace fourwis::can
{
namespace
{

constexpr std::uint32_t kMotionCommand = 0x111, kModeCommand = 0x141, kControlCommand = 0x421, kClearErrors = 0x441;
constexpr std::uint32_t kState = 0x211, kMotion = 0x221, kAngles = 0x271, kSpeeds = 0x281, kMode = 0x291;
constexpr double kThousandth = 1e-3, kTenth = 0.1;

Frame frame_of(std::uint32_t id, std::uint8_t size)
{
  Frame frame;
  frame.id = id;
  frame.size = size;
  return frame;
}

Frame frame_of(std::uint32_t id, std::uint8_t size, std::uint8_t first)
{
  Frame frame = frame_of(id, size);
  frame.data[0] = first;
  return frame;
}

bool is(const Frame& frame, std::uint32_t id)
{
  return frame.id == id && frame.size == 8 && !frame.extended && !frame.remote && !frame.error;
}

std::int16_t thousandths(double value)
{
  using Limits = std::numeric_limits<std::int16_t>;
  if (std::isnan(value)) return 0;
  return static_cast<std::int16_t>(std::lround(std::clamp<double>(value / kThousandth, Limits::min(), Limits::max())));
}

std::array<double, 4> four_thousandths(const Frame& frame)
{
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = get_big_endian<std::int16_t>(&frame.data[2 * i]) * kThousandth;
  return values;
}

}  // namespace

Frame encode_ranger_motion(const RangerMotion& motion)
{
  Frame frame = frame_of(kMotionCommand, 8);
  std::uint8_t* to = frame.data.data();
  for (const double value : {motion.speed, motion.yaw, motion.lateral, motion.steering})
    to = put_big_endian(thousandths(value), to);
  return frame;
}

Frame encode_ranger_mode(RangerMode mode)
{
  return frame_of(kModeCommand, 1, static_cast<std::uint8_t>(mode));
}

Frame encode_ranger_can_control()
{
  return frame_of(kControlCommand, 1, 1);
}

Frame encode_ranger_clear_errors()
{
  return frame_of(kClearErrors, 1, 0);
}

std::optional<RangerState> decode_ranger_state(const Frame& frame)
{
  if (!is(frame, kState)) return std::nullopt;
  return RangerState{frame.data[0], frame.data[1], get_big_endian<std::uint16_t>(&frame.data[2]) * kTenth,
                     get_big_endian<std::uint16_t>(&frame.data[4])};
}

std::optional<RangerMotion> decode_ranger_motion(const Frame& frame)
{
  if (!is(frame, kMotion)) return std::nullopt;
  const auto [speed, yaw, lateral, steering] = four_thousandths(frame);
  return RangerMotion{speed, yaw, lateral, steering};
}

std::optional<PerWheel> decode_ranger_angles(const Frame& frame)
{
  if (!is(frame, kAngles)) return std::nullopt;
  return four_thousandths(frame);
}

std::optional<PerWheel> decode_ranger_speeds(const Frame& frame)
{
  if (!is(frame, kSpeeds)) return std::nullopt;
  return four_thousandths(frame);
}

std::optional<RangerModeState> decode_ranger_mode(const Frame& frame)
{
  if (!is(frame, kMode)) return std::nullopt;
  return RangerModeState{frame.data[0], frame.data[1] == 1};
}

}  // namespace fourwis::can
