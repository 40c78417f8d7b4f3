// Whatever the type attribute says: refused, or values within its bits out of any element.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hal/linux/iio.hpp"
#include "tests/fuzz/io/require.hpp"

using hal::linux_os::IioType;
using host_sim::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(all.find('\n'), size);
  const auto type = hal::linux_os::parse_iio_type(all.substr(0, end));
  if (!type) {
    return 0;
  }
  require(type->bits >= 1 && type->bits + type->shift <= 8 * type->storage_bytes);
  require(type->storage_bytes <= 8);
  std::array<std::byte, 8> element{};
  for (std::size_t i = 0; i < element.size() && end + 1 + i < size; ++i) {
    element[i] = static_cast<std::byte>(data[end + 1 + i]);
  }
  const std::int64_t value =
      hal::linux_os::iio_value(*type, std::span(element).first(type->storage_bytes));
  if (type->bits < 63) {
    const std::int64_t limit = std::int64_t{1} << (type->is_signed ? type->bits - 1 : type->bits);
    require(value < limit && value >= (type->is_signed ? -limit : 0));
  }
  return 0;
}
