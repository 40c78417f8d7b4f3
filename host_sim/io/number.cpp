#include "host_sim/io/number.hpp"

#include <charconv>

namespace host_sim {

bool parse_number(const char*& position, const char* end, double& value) {
  const char* begin = position;
  if (*begin == '+' && end - begin > 1 && begin[1] != '-') {
    ++begin;
  }
  const std::from_chars_result result = std::from_chars(begin, end, value);
  if (result.ec != std::errc()) {
    return false;
  }
  position = result.ptr;
  return true;
}

}  // namespace host_sim
