#include "hal/linux/service_manager.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace hal::linux_os {
namespace {

std::string_view environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

std::uint64_t number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && at == text.data() + text.size() ? value : 0;
}

Time watchdog_of_environment() {
  const std::string_view process = environment("WATCHDOG_PID");
  if (!process.empty() && number(process) != static_cast<std::uint64_t>(::getpid())) {
    return {};
  }
  return microseconds(number(environment("WATCHDOG_USEC")));
}

}  // namespace

ServiceManager::ServiceManager()
    : ServiceManager(environment("NOTIFY_SOCKET"), watchdog_of_environment()) {}

ServiceManager::ServiceManager(std::string_view socket_path, Time watchdog)
    : path_(socket_path), watchdog_(watchdog) {
  if (!path_.empty()) {
    socket_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  }
}

void ServiceManager::notify(std::string_view message) const {
  ::sockaddr_un address{};
  if (!socket_ || path_.size() >= sizeof address.sun_path) {
    return;
  }
  address.sun_family = AF_UNIX;
  path_.copy(address.sun_path, path_.size());
  // A leading @ stands for the NUL of an abstract name.
  if (address.sun_path[0] == '@') {
    address.sun_path[0] = '\0';
  }
  const auto size = static_cast<socklen_t>(offsetof(::sockaddr_un, sun_path) + path_.size());
  // A manager that does not listen is no reason to stop controlling.
  static_cast<void>(::sendto(socket_.get(), message.data(), message.size(), MSG_NOSIGNAL,
                             reinterpret_cast<const ::sockaddr*>(&address), size));
}

void ServiceManager::ready(std::string_view status) {
  notify(std::string("READY=1\nSTATUS=").append(status));
}

void ServiceManager::stopping() {
  notify("STOPPING=1");
}

void ServiceManager::alive(Time now) {
  if (watchdog_.us != 0 && now >= next_) {
    next_ = now + microseconds(watchdog_.us / 4);
    notify("WATCHDOG=1");
  }
}

}  // namespace hal::linux_os
