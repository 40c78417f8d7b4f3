#include "host_sim/monitor/http/token.hpp"

#include <algorithm>
#include <cstddef>

#include "host_sim/io/input_error.hpp"

namespace host_sim::monitor {
namespace {

bool is_token_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
         std::string_view("-._~+/=").find(c) != std::string_view::npos;
}

}  // namespace

bool equal_in_constant_time(std::string_view one, std::string_view other) {
  unsigned different = one.size() == other.size() ? 0 : 1;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const char twin = other.empty() ? '\0' : other[i % other.size()];
    different |= static_cast<unsigned char>(one[i] ^ twin);
  }
  return different == 0;
}

std::string_view cookie_of(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find(';'), header.size());
    std::string_view pair = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    pair.remove_prefix(std::min(pair.find_first_not_of(' '), pair.size()));
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('=')) {
      return pair.substr(name.size() + 1);
    }
  }
  return {};
}

void check_token(std::string_view token) {
  constexpr std::size_t kShortest = 16;
  constexpr std::size_t kLongest = 256;
  if (token.size() < kShortest || token.size() > kLongest ||
      !std::all_of(token.begin(), token.end(), is_token_character)) {
    throw InputError("--http-token", 0, 0, "a token that cannot be used",
                     "16 to 256 letters, digits and -._~+/=");
  }
}

}  // namespace host_sim::monitor
