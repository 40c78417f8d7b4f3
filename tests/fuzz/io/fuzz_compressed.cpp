// Whatever the bytes: the same bytes or the same error in any pieces; what is not compressed is
// given as it is.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/io/compressed.hpp"
#include "tests/fuzz/io/require.hpp"
#include "tests/io/by_the_book.hpp"

namespace {

struct Outcome {
  std::string bytes;
  std::string error;
};

Outcome outcome_of(std::string_view text, std::size_t given, std::size_t asked) {
  constexpr std::size_t kEnough = 1 << 20;
  Outcome outcome;
  const auto source = host_sim::decompressed(
      std::make_unique<host_sim::test::PieceSource>(text, std::vector<std::size_t>{given}), "fuzz");
  std::vector<char> buffer(asked);
  try {
    while (outcome.bytes.size() < kEnough) {
      const std::size_t count = source->read(buffer);
      if (count == 0) {
        break;
      }
      outcome.bytes.append(buffer.data(), count);
    }
  } catch (const hal::files::InputError& error) {
    outcome.error = error.what();
    host_sim::fuzz::require_one_line(outcome.error);
  }
  return outcome;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using host_sim::fuzz::require;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Outcome whole = outcome_of(text, std::size_t{1} << 30, 4096);
  const Outcome pieces = outcome_of(text, 1, 61);
  const std::size_t common = std::min(whole.bytes.size(), pieces.bytes.size());
  require(std::string_view(whole.bytes).substr(0, common) ==
          std::string_view(pieces.bytes).substr(0, common));
  require(whole.error == pieces.error || common >= (std::size_t{1} << 20) - 4096);
  if (!text.starts_with("\x1F\x8B") && !text.starts_with("\x28\xB5\x2F\xFD")) {
    require(whole.error.empty() && whole.bytes == text.substr(0, whole.bytes.size()));
  }
  return 0;
}
