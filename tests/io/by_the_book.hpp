#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/profile.hpp"
#include "hal/files/profile_rows.hpp"

/// The rows of a profile read one after the other, each by the book: what the reader is held to.
namespace host_sim::test {

struct ReadProfile {
  std::vector<hal::files::ProfileRow> rows;  ///< before the error
  std::string error;                         ///< empty where there is none
};

inline bool same_bits(const hal::files::ProfileRow& a, const hal::files::ProfileRow& b) {
  static_assert(sizeof a == 7 * sizeof(double) + sizeof a.line);
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool same_bits(const ReadProfile& a, const ReadProfile& b) {
  return a.error == b.error && a.rows.size() == b.rows.size() &&
         std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(),
                    [](const auto& x, const auto& y) { return same_bits(x, y); });
}

/// Hands out a text in pieces of the given sizes, over and over, as a file of known size.
class PieceSource final : public hal::files::ByteSource {
 public:
  PieceSource(std::string_view text, std::vector<std::size_t> sizes)
      : rest_(text), total_(text.size()), sizes_(std::move(sizes)) {}

  std::size_t read(std::span<char> buffer) override {
    const std::size_t wanted = std::min(sizes_[next_++ % sizes_.size()], buffer.size());
    const std::size_t count = rest_.copy(buffer.data(), wanted);
    rest_.remove_prefix(count);
    return count;
  }
  std::uint64_t total() const noexcept override { return total_; }

 private:
  std::string_view rest_;
  std::uint64_t total_;
  std::vector<std::size_t> sizes_;
  std::size_t next_ = 0;
};

/// By the reader, in pieces and by some threads. Rows of a block with an error are left out.
inline ReadProfile read_profile(std::string_view text, std::vector<std::size_t> pieces,
                                hal::files::ProfileOptions options) {
  ReadProfile result;
  try {
    hal::files::ProfileReader reader(std::make_unique<PieceSource>(text, std::move(pieces)),
                                     "p.csv", options);
    for (auto rows = reader.read_block(); !rows.empty(); rows = reader.read_block()) {
      result.rows.insert(result.rows.end(), rows.begin(), rows.end());
    }
  } catch (const hal::files::InputError& error) {
    result.error = error.what();
  }
  return result;
}

inline ReadProfile read_by_the_book(std::string_view text, hal::files::ProfileOptions options) {
  using namespace hal::files;
  ReadProfile result;
  try {
    const ProfileReader header(memory_source(text), "p.csv", options);
    LineBuffer lines(memory_source(text), "p.csv");
    const ProfileRowParser parser(read_profile_header(
        lines, "p.csv", "",
        [&](const TextPlace& line) { return parse_profile_columns(line, "", options.columns); }));
    const unsigned value = header.kind() == InputKind::kInputTension   ? kInputTensionColumn
                           : header.kind() == InputKind::kMotorCurrent ? kMotorCurrentColumn
                                                                       : kOutputTensionColumn;
    double last_time_s = -std::numeric_limits<double>::infinity();
    for (; lines.fill(); lines.next_line(lines.line_end())) {
      const TextPlace line{"p.csv", lines.line_number(), lines.line()};
      if (line.text.starts_with('#')) {
        refuse_nul(line);
        continue;
      }
      ProfileRowParser::Values values{};
      parser.by_the_book(line, last_time_s, values);
      last_time_s = values[kTime];
      result.rows.push_back({values[kTime], values[value], values[kTendonVelocity],
                             header.has_bend_angle() ? values[kBendAngle] : 0, values[kMotorAngle],
                             values[kSheathTemperature], values[kWindingTemperature], line.number});
    }
  } catch (const InputError& error) {
    result.error = error.what();
  }
  return result;
}

/// What the rows have in common where there is an error: the reader leaves out those of its block.
inline bool agree(const ReadProfile& reader, const ReadProfile& book) {
  return book.error.empty()
             ? same_bits(reader, book)
             : reader.error == book.error && reader.rows.size() <= book.rows.size() &&
                   std::equal(reader.rows.begin(), reader.rows.end(), book.rows.begin(),
                              [](const auto& x, const auto& y) { return same_bits(x, y); });
}

}  // namespace host_sim::test
