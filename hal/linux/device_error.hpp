#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace hal::linux_os {

/// A device of this machine that cannot be set up. what() is one line:
/// `device: what was found; accepted: what is accepted`.
class DeviceError : public std::runtime_error {
 public:
  DeviceError(std::string_view device, std::string_view found, std::string_view accepted)
      : std::runtime_error(std::string(device)
                               .append(": ")
                               .append(found)
                               .append("; accepted: ")
                               .append(accepted)) {}
};

}  // namespace hal::linux_os
