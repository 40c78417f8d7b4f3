#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/profile.hpp"
#include "tests/io/support.hpp"

namespace host_sim {

using hal::files::ByteSource;
using hal::files::InputError;
using hal::files::ProfileRow;

namespace {

using test::rows_of;
using test::same;

/// Hands out a text in pieces of the given sizes, over and over.
class ChoppySource final : public ByteSource {
 public:
  ChoppySource(std::string_view text, std::vector<std::size_t> sizes)
      : rest_(text), sizes_(std::move(sizes)) {}

  std::size_t read(std::span<char> buffer) override {
    const std::size_t wanted = std::min(sizes_[next_++ % sizes_.size()], buffer.size());
    const std::size_t count = rest_.copy(buffer.data(), wanted);
    rest_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view rest_;
  std::vector<std::size_t> sizes_;
  std::size_t next_ = 0;
};

std::vector<ProfileRow> random_rows(std::size_t count) {
  std::vector<ProfileRow> rows;
  double time_s = *rc::gen::inRange(-1000, 1000) / 7.0;
  for (std::size_t i = 0; i < count; ++i) {
    rows.push_back({time_s, *rc::gen::inRange(-1'000'000, 1'000'000) / 3.0,
                    *rc::gen::inRange(-1000, 1000) / 11.0, *rc::gen::inRange(0, 1800) / 1.7});
    time_s += *rc::gen::inRange(1, 1000) / 13.0;
  }
  return rows;
}

std::string field(double value) {
  const std::string number = fmt::format("{}", value);
  return *rc::gen::element(0, 1) == 0 ? number : "\"" + number + "\"";
}

std::string csv_of(const std::vector<ProfileRow>& rows) {
  std::string text = "output_tension_N,bend_angle_deg,time_s,tendon_velocity_m_s\n";
  for (const ProfileRow& row : rows) {
    text += *rc::gen::element("", "", "", "# comment\n", "#\r\n");
    text += field(row.value) + "," + field(row.bend_angle_deg) + "," + field(row.time_s) + "," +
            field(row.tendon_velocity_m_s) + *rc::gen::element("\n", "\r\n");
  }
  return text;
}

RC_GTEST_PROP(ProfileProperty, GivesBackWhatWasWritten, ()) {
  const auto rows = random_rows(*rc::gen::inRange<std::size_t>(1, 20));
  RC_ASSERT(same(rows_of(csv_of(rows)), rows));
}

RC_GTEST_PROP(ProfileProperty, DoesNotDependOnThePiecesItIsReadIn, ()) {
  const std::string text = csv_of(random_rows(*rc::gen::inRange<std::size_t>(1, 20)));
  const auto sizes = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 50)));
  const auto chunk = *rc::gen::inRange<std::size_t>(1, 30);
  const auto pieces = rows_of(std::make_unique<ChoppySource>(text, sizes), {}, chunk);
  RC_ASSERT(same(pieces, rows_of(text)));
}

// Any damage to a good profile is refused, or what comes out is finite and runs forward in time.
RC_GTEST_PROP(ProfileProperty, NeverGivesRowsThatCannotBeTrusted, ()) {
  std::string text = csv_of(random_rows(*rc::gen::inRange<std::size_t>(1, 10)));
  const auto changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
    const std::string other(1, *rc::gen::oneOf(rc::gen::arbitrary<char>(),
                                               rc::gen::element(',', '\n', '"', '\r', '#', 'e')));
    text.replace(at, *rc::gen::inRange<std::size_t>(0, 3), other);
  }
  try {
    double last_s = -std::numeric_limits<double>::infinity();
    for (const ProfileRow& row : rows_of(text)) {
      RC_ASSERT(std::isfinite(row.value));
      RC_ASSERT(std::isfinite(row.tendon_velocity_m_s));
      RC_ASSERT(std::isfinite(row.bend_angle_deg));
      RC_ASSERT(row.time_s > last_s);
      last_s = row.time_s;
    }
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    RC_ASSERT(line.find('\n') == std::string_view::npos);
    RC_ASSERT(line.find("; accepted: ") != std::string_view::npos);
  }
}

// Larger than the reader's window, so that lines are cut at its end.
TEST(ProfileProperty, ReadsAcrossTheWindow) {
  std::string text = "time_s,input_tension_N\n";
  std::uint64_t state = 1;
  constexpr int kRows = 150'000;
  for (int i = 0; i < kRows; ++i) {
    state = state * 6'364'136'223'846'793'005U + 1U;
    text += fmt::format("{}.5,{}\n", i, state >> 45);
  }
  ASSERT_GT(text.size(), std::size_t{2} << 20);
  const auto whole = rows_of(text);
  ASSERT_EQ(whole.size(), static_cast<std::size_t>(kRows));
  state = 1;
  for (int i = 0; i < kRows; ++i) {
    state = state * 6'364'136'223'846'793'005U + 1U;
    const ProfileRow& row = whole[static_cast<std::size_t>(i)];
    ASSERT_EQ(row.time_s, i + 0.5);
    ASSERT_EQ(row.value, static_cast<double>(state >> 45));
  }
  const auto pieces = rows_of(
      std::make_unique<ChoppySource>(text, std::vector<std::size_t>{65536, 1, 4096, 700'000}), {},
      4096);
  EXPECT_TRUE(same(pieces, whole));
}

}  // namespace
}  // namespace host_sim
