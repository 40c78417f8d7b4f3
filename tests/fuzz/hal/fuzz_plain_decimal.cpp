// Whatever the bytes: a decimal that is taken ends with a field and has the bits of
// std::from_chars(), and one that is not is left alone.
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hal/files/plain_decimal.hpp"
#include "tests/fuzz/io/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using host_sim::fuzz::require;
  std::string text(reinterpret_cast<const char*>(data), size);
  text += ',';
  const char* const end = text.data() + text.size();
  double expected = 0;
  const auto slow = std::from_chars(text.data(), end, expected);
  const std::string number(static_cast<const char*>(text.data()), slow.ptr);
  text.append(hal::files::kPlainDecimalReach, '\0');
  const char* at = text.data();
  double value = 0;
  if (hal::files::parse_plain_decimal(at, value, ',')) {
    require(slow.ec == std::errc());
    require(at == text.data() + number.size());
    require(std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(expected));
    require(*at == ',' || *at == '\n' || *at == '\r' || *at == '"');
  } else {
    require(at == text.data());
  }
  return 0;
}
