#pragma once

#include <string>
#include <string_view>

#include "hal/clock.hpp"
#include "hal/linux/descriptor.hpp"

namespace hal::linux_os {

/// Reports to systemd how the service is, by the protocol of sd_notify(3): a datagram to the socket
/// that NOTIFY_SOCKET names. Does nothing where there is none.
class ServiceManager {
 public:
  /// Reads NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID of the environment.
  ServiceManager();
  explicit ServiceManager(std::string_view socket_path, Time watchdog = {});

  void ready(std::string_view status);
  void stopping();
  /// Feeds the watchdog of the service, at most four times within its time.
  void alive(Time now);

 private:
  void notify(std::string_view message) const;

  std::string path_;
  Descriptor socket_;
  Time watchdog_{};
  Time next_{};
};

}  // namespace hal::linux_os
