#include "hal/linux/can_calls.hpp"

#include <linux/can/error.h>
#include <linux/can/netlink.h>
#include <linux/can/raw.h>
#include <linux/if_link.h>
#include <linux/net_tstamp.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "hal/linux/can_wire.hpp"
#include "hal/linux/device_error.hpp"

namespace hal::linux_os {
namespace {

::ifreq request_for(const std::string& interface) {
  ::ifreq request{};
  interface.copy(request.ifr_name, sizeof request.ifr_name - 1);
  return request;
}

bool is_can(int socket, const std::string& interface) {
  ::ifreq request = request_for(interface);
  return ::ioctl(socket, SIOCGIFHWADDR, &request) == 0 &&
         request.ifr_hwaddr.sa_family == ARPHRD_CAN;
}

template <class T>
bool set_option(int socket, int level, int name, const T& value) {
  return ::setsockopt(socket, level, name, &value, sizeof value) == 0;
}

// Timestamps and counts of lost frames are extras: a kernel without them is used all the same.
void ask_for_extras(int socket) {
  constexpr int kStamps = SOF_TIMESTAMPING_RX_HARDWARE | SOF_TIMESTAMPING_RAW_HARDWARE |
                          SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE;
  set_option(socket, SOL_SOCKET, SO_TIMESTAMPING, kStamps);
  set_option(socket, SOL_SOCKET, SO_RXQ_OVFL, 1);
}

std::int64_t nanoseconds(const ::timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

// Of the three times of SCM_TIMESTAMPING the first is the kernel's and the last the controller's.
void take_times(const std::array<::timespec, 3>& times, CanReceipt& receipt) {
  if (const std::int64_t hardware_ns = nanoseconds(times[2]); hardware_ns != 0) {
    receipt.time_ns = hardware_ns;
    receipt.source = TimestampSource::hardware;
  } else if (const std::int64_t software_ns = nanoseconds(times[0]); software_ns != 0) {
    receipt.time_ns = software_ns;
    receipt.source = TimestampSource::software;
  }
}

void take_extras(::msghdr& message, CanReceipt& receipt) {
  for (::cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr;
       part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET) {
      continue;
    }
    if (part->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t dropped = 0;
      std::memcpy(&dropped, CMSG_DATA(part), sizeof dropped);
      receipt.dropped = dropped;
    } else if (part->cmsg_type == SO_TIMESTAMPING) {
      std::array<::timespec, 3> times{};
      std::memcpy(times.data(), CMSG_DATA(part), sizeof times);
      take_times(times, receipt);
    }
  }
}

}  // namespace

std::string can_interfaces() {
  std::string names;
  const Descriptor socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  struct ::if_nameindex* const all = ::if_nameindex();
  for (const struct ::if_nameindex* at = all; at != nullptr && at->if_index != 0; ++at) {
    if (is_can(socket.get(), at->if_name)) {
      names.append(names.empty() ? "" : ", ").append(at->if_name);
    }
  }
  ::if_freenameindex(all);
  return names.empty() ? "none" : names;
}

int CanCalls::configure() {
  const Descriptor probe(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const unsigned index = ::if_nametoindex(interface_.c_str());
  if (index == 0 || interface_.size() >= IFNAMSIZ) {
    return ENODEV;
  }
  if (!is_can(probe.get(), interface_)) {
    return EMEDIUMTYPE;
  }
  Descriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!socket) {
    return errno;
  }
  if (::setsockopt(socket.get(), SOL_CAN_RAW, CAN_RAW_FILTER, filters_.data(),
                   static_cast<socklen_t>(filters_.size() * sizeof filters_[0])) != 0 ||
      !set_option(socket.get(), SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kCanErrorClasses)) {
    return errno;
  }
  ask_for_extras(socket.get());
  ::sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(index);
  if (::bind(socket.get(), reinterpret_cast<const ::sockaddr*>(&address), sizeof address) != 0) {
    return errno;
  }
  socket_ = std::move(socket);
  return 0;
}

void CanCalls::open(const std::string& interface, std::span<const CanFilter> filters) {
  interface_ = interface;
  filters_.clear();
  for (const CanFilter& filter : filters) {
    filters_.push_back(to_kernel(filter));
  }
  const int error = configure();
  switch (error) {
    case 0:
      return;
    case ENODEV:
      throw DeviceError(interface, "no such network interface",
                        "a CAN interface; there are: " + can_interfaces());
    case EMEDIUMTYPE:
      throw DeviceError(interface, "not a CAN interface",
                        "a CAN interface; there are: " + can_interfaces());
    case EAFNOSUPPORT:
    case EPROTONOSUPPORT:
      throw DeviceError(interface, "this kernel has no SocketCAN",
                        "a kernel with CONFIG_CAN and CONFIG_CAN_RAW (modprobe can_raw)");
    default:
      throw DeviceError(interface, std::string("cannot be opened: ") + std::strerror(error),
                        "a CAN interface that this user may use");
  }
}

int CanCalls::reopen() {
  return configure();
}

int CanCalls::send(const ::can_frame& frame) {
  const ssize_t written = ::send(socket_.get(), &frame, sizeof frame, MSG_DONTWAIT | MSG_NOSIGNAL);
  return written == static_cast<ssize_t>(sizeof frame) ? 0 : (written < 0 ? errno : EIO);
}

CanReceipt CanCalls::receive() {
  CanReceipt receipt;
  ::iovec place{&receipt.frame, sizeof receipt.frame};
  alignas(::cmsghdr) std::array<std::byte, 256> extras{};
  ::msghdr message{};
  message.msg_iov = &place;
  message.msg_iovlen = 1;
  message.msg_control = extras.data();
  message.msg_controllen = extras.size();
  const ssize_t size = ::recvmsg(socket_.get(), &message, MSG_DONTWAIT);
  if (size != static_cast<ssize_t>(sizeof receipt.frame)) {
    receipt.error = size < 0 ? errno : EBADMSG;
    return receipt;
  }
  take_extras(message, receipt);
  return receipt;
}

bool CanCalls::is_up() const {
  ::ifreq request = request_for(interface_);
  return ::ioctl(socket_.get(), SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
}

CanRestart CanCalls::restart() {
  switch (request_can_restart(static_cast<int>(::if_nametoindex(interface_.c_str())))) {
    case 0:
      return CanRestart::asked;
    case EBUSY:
      return CanRestart::not_off;
    case EINVAL:
      return CanRestart::by_kernel;
    case EOPNOTSUPP:
      return CanRestart::no_controller;
    default:
      return CanRestart::refused;
  }
}

namespace {

/// A netlink message that grows by attributes, which may hold others (netlink(7), rtnetlink(7)).
class LinkRequest {
 public:
  explicit LinkRequest(int interface_index) {
    header().nlmsg_type = RTM_NEWLINK;
    header().nlmsg_flags = NLM_F_REQUEST | NLM_F_ACK;
    header().nlmsg_seq = 1;
    ::ifinfomsg link{};
    link.ifi_family = AF_UNSPEC;
    link.ifi_index = interface_index;
    std::memcpy(buffer_.data() + NLMSG_HDRLEN, &link, sizeof link);
    size_ = NLMSG_LENGTH(sizeof link);
  }

  std::size_t begin(std::uint16_t type) {
    const std::size_t at = size_ = NLMSG_ALIGN(size_);
    const ::rtattr attribute{RTA_LENGTH(0), type};
    std::memcpy(buffer_.data() + at, &attribute, sizeof attribute);
    size_ += sizeof attribute;
    return at;
  }
  void put(const void* data, std::size_t bytes) {
    std::memcpy(buffer_.data() + size_, data, bytes);
    size_ += bytes;
  }
  void end(std::size_t at) {
    const auto length = static_cast<std::uint16_t>(size_ - at);
    std::memcpy(buffer_.data() + at, &length, sizeof length);
  }
  [[nodiscard]] bool send(int socket) {
    header().nlmsg_len = static_cast<std::uint32_t>(size_);
    return ::send(socket, buffer_.data(), size_, 0) == static_cast<ssize_t>(size_);
  }

 private:
  ::nlmsghdr& header() { return *reinterpret_cast<::nlmsghdr*>(buffer_.data()); }

  alignas(::nlmsghdr) std::array<std::byte, 128> buffer_{};
  std::size_t size_ = 0;
};

void put_restart(LinkRequest& request) {
  constexpr std::string_view kKind = "can";
  constexpr std::uint32_t kRestart = 1;
  const std::size_t info = request.begin(IFLA_LINKINFO);
  const std::size_t kind = request.begin(IFLA_INFO_KIND);
  request.put(kKind.data(), kKind.size());
  request.end(kind);
  const std::size_t data = request.begin(IFLA_INFO_DATA);
  const std::size_t restart = request.begin(IFLA_CAN_RESTART);
  request.put(&kRestart, sizeof kRestart);
  request.end(restart);
  request.end(data);
  request.end(info);
}

int answer_of(int socket) {
  alignas(::nlmsghdr) std::array<std::byte, 1024> answer{};
  const ssize_t size = ::recv(socket, answer.data(), answer.size(), MSG_DONTWAIT);
  if (size < 0) {
    return errno;
  }
  const auto* const header = reinterpret_cast<const ::nlmsghdr*>(answer.data());
  if (static_cast<std::size_t>(size) < NLMSG_LENGTH(sizeof(::nlmsgerr)) ||
      header->nlmsg_type != NLMSG_ERROR) {
    return EBADMSG;
  }
  ::nlmsgerr error{};
  std::memcpy(&error, NLMSG_DATA(header), sizeof error);
  return -error.error;
}

}  // namespace

int request_can_restart(int interface_index) {
  const Descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
  if (!socket) {
    return errno;
  }
  LinkRequest request(interface_index);
  put_restart(request);
  // The kernel has handled the request, and its answer waits, when send() returns.
  return request.send(socket.get()) ? answer_of(socket.get()) : errno;
}

}  // namespace hal::linux_os
