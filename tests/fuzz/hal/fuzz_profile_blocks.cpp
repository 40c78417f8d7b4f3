// Whatever the bytes, the pieces that they come in and the number of threads: the rows and the
// error are those of reading row by row by the book, with columns of others or without. The first
// two bytes choose pieces and threads.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/fuzz/io/require.hpp"
#include "tests/io/by_the_book.hpp"

namespace {

/// None, columns that are passed over, and these with maps of others.
const std::vector<hal::files::ColumnOptions>& columns_of_others() {
  using hal::files::column_map;
  static const std::vector<hal::files::ColumnOptions> all{
      {},
      {.maps = {}, .ignore_extra = true, .given_by_options = true},
      {.maps = {column_map("t in ms=time_s"), column_map("-2*f+1=input_tension_N")},
       .ignore_extra = true,
       .given_by_options = true}};
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using hal::files::InputKind;
  if (size < 2) {
    return 0;
  }
  constexpr std::array<std::optional<InputKind>, 4> kKinds{
      std::nullopt, InputKind::kInputTension, InputKind::kMotorCurrent, InputKind::kOutputTension};
  constexpr std::size_t kWhole = std::size_t{1} << 30;
  const std::string_view text(reinterpret_cast<const char*>(data) + 2, size - 2);
  const std::size_t piece = 1 + data[0];
  const unsigned threads = 1 + data[1] % 3;
  const auto kind = kKinds[data[1] / 3 % kKinds.size()];
  const std::vector<std::size_t> pieces =
      data[1] >= 128 ? std::vector{piece, kWhole} : std::vector{piece};
  for (const hal::files::ColumnOptions& columns : columns_of_others()) {
    const auto book = host_sim::test::read_by_the_book(text, {kind, 1, columns});
    const auto read = host_sim::test::read_profile(text, pieces, {kind, threads, columns});
    host_sim::fuzz::require(agree(read, book));
  }
  return 0;
}
