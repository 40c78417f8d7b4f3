#pragma once

#include <string>
#include <system_error>

namespace host_sim {

/// What the operating system says of one of its error numbers.
inline std::string reason_of(int error_number) {
  return std::generic_category().message(error_number);
}

}  // namespace host_sim
