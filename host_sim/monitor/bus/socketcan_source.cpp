#include "host_sim/monitor/bus/socketcan_source.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <thread>
#include <utility>

#include "hal/linux/can_calls.hpp"
#include "hal/linux/device_error.hpp"
#include "host_sim/monitor/bus/can_packet.hpp"

namespace host_sim::monitor {
namespace {

using hal::linux_os::Descriptor;
using hal::linux_os::DeviceError;

constexpr std::chrono::milliseconds kTryAgain{100};
/// Room for some seconds of a full bus.
constexpr int kReceiveBytes = 8 << 20;

std::int64_t clock_ns(clockid_t clock) {
  ::timespec time{};
  ::clock_gettime(clock, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

::ifreq request_for(const std::string& interface) {
  ::ifreq request{};
  interface.copy(request.ifr_name, sizeof request.ifr_name - 1);
  return request;
}

/// errno, or 0 where it is a CAN interface that is up.
int look_at(int socket, const std::string& interface) {
  ::ifreq request = request_for(interface);
  if (interface.size() >= IFNAMSIZ || ::ioctl(socket, SIOCGIFHWADDR, &request) != 0) {
    return ENODEV;
  }
  if (request.ifr_hwaddr.sa_family != ARPHRD_CAN) {
    return EMEDIUMTYPE;
  }
  request = request_for(interface);
  const bool up = ::ioctl(socket, SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
  return up ? 0 : ENETDOWN;
}

template <class T>
int set_option(int socket, int level, int name, const T& value) {
  return ::setsockopt(socket, level, name, &value, sizeof value);
}

void ask_for_all(int socket) {
  constexpr int kOn = 1;
  constexpr can_err_mask_t kAllErrors = CAN_ERR_MASK;
  set_option(socket, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kAllErrors);
  set_option(socket, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, kOn);
  set_option(socket, SOL_SOCKET, SO_TIMESTAMPNS, kOn);
  set_option(socket, SOL_SOCKET, SO_RXQ_OVFL, kOn);
  if (set_option(socket, SOL_SOCKET, SO_RCVBUFFORCE, kReceiveBytes) != 0) {
    set_option(socket, SOL_SOCKET, SO_RCVBUF, kReceiveBytes);
  }
}

struct Extras {
  std::int64_t stamp_ns = 0;
  std::optional<std::uint32_t> overflows;
};

Extras extras_of(::msghdr& message) {
  Extras extras;
  for (::cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET) {
      continue;
    }
    if (part->cmsg_type == SO_TIMESTAMPNS) {
      ::timespec time{};
      std::memcpy(&time, CMSG_DATA(part), sizeof time);
      extras.stamp_ns = std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
    } else if (part->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t overflows = 0;
      std::memcpy(&overflows, CMSG_DATA(part), sizeof overflows);
      extras.overflows = overflows;
    }
  }
  return extras;
}

std::string trouble_of(int error) {
  switch (error) {
    case ENETDOWN:
      return "is down";
    case ENODEV:
    case ENXIO:
      return "is gone";
    default:
      return std::string("cannot be read: ") + std::strerror(error);
  }
}

}  // namespace

SocketCanSource::SocketCanSource(std::string interface)
    : interface_(std::move(interface)),
      epoch_ns_(clock_ns(CLOCK_REALTIME) - clock_ns(CLOCK_MONOTONIC)) {
  const std::string accepted = "a CAN interface; there are: " + hal::linux_os::can_interfaces();
  switch (const int error = open()) {
    case 0:
    case ENETDOWN:
      return;
    case ENODEV:
      throw DeviceError(interface_, "no such network interface", accepted);
    case EMEDIUMTYPE:
      throw DeviceError(interface_, "not a CAN interface", accepted);
    case EAFNOSUPPORT:
    case EPROTONOSUPPORT:
      throw DeviceError(interface_, "this kernel has no SocketCAN",
                        "a kernel with CONFIG_CAN and CONFIG_CAN_RAW (modprobe can_raw)");
    default:
      throw DeviceError(interface_, trouble_of(error), accepted);
  }
}

int SocketCanSource::open() {
  const Descriptor probe(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  int error = look_at(probe.get(), interface_);
  if (error == 0) {
    Descriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
    ::sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(::if_nametoindex(interface_.c_str()));
    if (!socket) {
      error = errno;
    } else {
      ask_for_all(socket.get());
      error =
          ::bind(socket.get(), reinterpret_cast<const ::sockaddr*>(&address), sizeof address) == 0
              ? 0
              : errno;
    }
    if (error == 0) {
      socket_ = std::move(socket);
      overflows_ = 0;
      trouble_.clear();
      return 0;
    }
  }
  lose(error);
  return error;
}

void SocketCanSource::lose(int error) {
  socket_ = Descriptor();
  trouble_ = trouble_of(error);
}

void SocketCanSource::try_again(std::chrono::milliseconds most) {
  if (open() != 0) {
    std::this_thread::sleep_for(std::min(most, kTryAgain));
  }
}

std::optional<SeenFrame> SocketCanSource::next(std::chrono::milliseconds most) {
  if (!trouble_.empty()) {
    try_again(most);
    return std::nullopt;
  }
  if (auto seen = receive()) {
    return seen;
  }
  ::pollfd waiting{.fd = socket_.get(), .events = POLLIN, .revents = 0};
  if (!trouble_.empty() || ::poll(&waiting, 1, static_cast<int>(most.count())) <= 0) {
    return std::nullopt;
  }
  return receive();
}

std::optional<SeenFrame> SocketCanSource::receive() {
  ::canfd_frame frame{};
  ::iovec place{&frame, sizeof frame};
  alignas(::cmsghdr) std::array<std::byte, 256> extras_bytes{};
  ::msghdr message{};
  message.msg_iov = &place;
  message.msg_iovlen = 1;
  message.msg_control = extras_bytes.data();
  message.msg_controllen = extras_bytes.size();
  const ssize_t size = ::recvmsg(socket_.get(), &message, MSG_DONTWAIT);
  if (size < 0) {
    if (errno != EAGAIN && errno != EINTR) {
      lose(errno);
    }
    return std::nullopt;
  }
  const Extras extras = extras_of(message);
  const std::span bytes(reinterpret_cast<const std::byte*>(&frame), static_cast<std::size_t>(size));
  std::optional<SeenFrame> seen = frame_of_packet(
      bytes, false, bytes.size() == CANFD_MTU ? PacketKind::flexible : PacketKind::classic);
  if (seen) {
    seen->time_ns = seen_at(extras.stamp_ns);
    const std::uint32_t overflows = extras.overflows.value_or(overflows_);
    seen->lost_before = overflows - std::exchange(overflows_, overflows);
  }
  return seen;
}

std::int64_t SocketCanSource::seen_at(std::int64_t stamp_ns) {
  constexpr std::int64_t kOldest_ns = 10'000'000'000;  // older: the clock of the kernel was set
  const std::int64_t age_ns = clock_ns(CLOCK_REALTIME) - stamp_ns;
  const bool sound = stamp_ns != 0 && age_ns >= 0 && age_ns < kOldest_ns;
  last_ns_ = std::max(last_ns_, now_ns() - (sound ? age_ns : 0));
  return last_ns_;
}

FrameSource::State SocketCanSource::state() const {
  return trouble_.empty() ? State::running : State::lost;
}

std::string SocketCanSource::description() const {
  return trouble_.empty() ? interface_ : interface_ + " " + trouble_;
}

std::int64_t SocketCanSource::now_ns() const {
  return epoch_ns_ + clock_ns(CLOCK_MONOTONIC);
}

}  // namespace host_sim::monitor
