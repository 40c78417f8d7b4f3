#include "host_sim/monitor/bus/can_packet.hpp"

#include <linux/can.h>
#include <linux/can/error.h>

#include <algorithm>
#include <cstring>

#ifndef CAN_ERR_CNT  // of kernels before 6.0, whose drivers set the counters with CAN_ERR_CRTL
#define CAN_ERR_CNT 0x00000200U
#endif

#ifndef CANFD_FDF  // of kernels before 5.14
#define CANFD_FDF 0x04
#endif

namespace host_sim::monitor {
namespace {

constexpr std::size_t kHead = 8;

std::uint32_t id_of(std::span<const std::byte> packet, bool big_endian) {
  std::uint32_t id = 0;
  if (!big_endian) {
    std::memcpy(&id, packet.data(), sizeof id);
    return id;
  }
  for (const std::byte byte : packet.first(sizeof id)) {
    id = (id << 8) | std::to_integer<std::uint32_t>(byte);
  }
  return id;
}

bool is_fd_length(std::size_t length) {
  return length <= 8 || length == 12 || length == 16 || length == 20 || length == 24 ||
         length == 32 || length == 48 || length == 64;
}

bool is_flexible(PacketKind kind, std::size_t length, std::uint8_t flags) {
  if (kind == PacketKind::as_flag_says) {
    return length > 8 || (flags & CANFD_FDF) != 0;
  }
  return kind == PacketKind::flexible;
}

}  // namespace

BusError bus_error_of(const hal::CanFrame& frame) {
  const auto byte = [&frame](std::size_t i) {
    return std::to_integer<std::uint8_t>(frame.data[i]);
  };
  const auto has = [&frame](std::uint32_t kind) { return (frame.id & kind) != 0; };
  const std::uint8_t controller = has(CAN_ERR_CRTL) ? byte(1) : std::uint8_t{0};
  const auto says = [controller](int bits) { return (controller & bits) != 0; };
  BusError error{.bus_off = has(CAN_ERR_BUSOFF),
                 .restarted = has(CAN_ERR_RESTARTED),
                 .error_passive = says(CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE),
                 .error_warning = says(CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING),
                 .receive_overflow = says(CAN_ERR_CRTL_RX_OVERFLOW)};
  if (has(CAN_ERR_CNT) || has(CAN_ERR_CRTL)) {
    error.transmit_errors = byte(6);
    error.receive_errors = byte(7);
  }
  return error;
}

std::optional<SeenFrame> frame_of_packet(std::span<const std::byte> packet, bool big_endian,
                                         PacketKind kind) {
  if (packet.size() < kHead) {
    return std::nullopt;
  }
  const std::uint32_t id = id_of(packet, big_endian);
  const auto length = std::to_integer<std::size_t>(packet[4]);
  const auto flags = std::to_integer<std::uint8_t>(packet[5]);
  SeenFrame seen;
  seen.flexible_data_rate = is_flexible(kind, length, flags);
  seen.remote_request = (id & CAN_RTR_FLAG) != 0 && !seen.flexible_data_rate;
  const bool is_error = (id & CAN_ERR_FLAG) != 0;
  seen.frame.extended = (id & CAN_EFF_FLAG) != 0 && !is_error;
  seen.frame.id = id & (seen.frame.extended || is_error ? CAN_EFF_MASK : CAN_SFF_MASK);
  const std::size_t bytes = seen.remote_request ? 0 : length;
  if (packet.size() - kHead < bytes || !is_fd_length(length) ||
      (length > 8 && (is_error || !seen.flexible_data_rate))) {
    return std::nullopt;
  }
  const auto data = packet.subspan(kHead, bytes);
  if (seen.flexible_data_rate && !is_error) {
    seen.fd_flags = flags & (CANFD_BRS | CANFD_ESI);
    seen.fd_data.assign(data.begin(), data.end());
    return seen;
  }
  seen.flexible_data_rate = false;
  seen.frame.length = static_cast<std::uint8_t>(length);
  std::copy(data.begin(), data.end(), seen.frame.data.begin());
  if (is_error) {
    seen.error = bus_error_of(seen.frame);
  }
  return seen;
}

}  // namespace host_sim::monitor
