#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "hal/linux/can_calls.hpp"

namespace hal::linux_os {
namespace {

/// A netlink message that grows by attributes, which may hold others (netlink(7), rtnetlink(7)).
class Request {
 public:
  explicit Request(int interface_index) {
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

void put_restart(Request& request) {
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
  Request request(interface_index);
  put_restart(request);
  // The kernel has handled the request, and its answer waits, when send() returns.
  return request.send(socket.get()) ? answer_of(socket.get()) : errno;
}

}  // namespace hal::linux_os
