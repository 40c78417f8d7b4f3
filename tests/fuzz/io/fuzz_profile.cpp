// Whatever the bytes: rows that can be trusted or an InputError, the same in any pieces.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/profile.hpp"
#include "tests/fuzz/io/require.hpp"

namespace {

using hal::files::ByteSource;
using hal::files::InputKind;
using hal::files::ProfileReader;
using hal::files::ProfileRow;
using host_sim::fuzz::require;

class PiecewiseSource final : public ByteSource {
 public:
  PiecewiseSource(std::string_view text, std::size_t piece) : rest_(text), piece_(piece) {}

  std::size_t read(std::span<char> buffer) override {
    const std::size_t count = rest_.copy(buffer.data(), std::min(piece_, buffer.size()));
    rest_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view rest_;
  std::size_t piece_;
};

struct Outcome {
  std::vector<ProfileRow> rows;
  std::string error;
};

void require_trustworthy(const ProfileRow& row, double last_time_s) {
  require(std::isfinite(row.time_s) && row.time_s > last_time_s);
  require(std::abs(row.value) <= 1e6);
  require(std::abs(row.tendon_velocity_m_s) <= 1000.0);
  require(row.bend_angle_deg >= 0.0 && row.bend_angle_deg <= 1800.0);
}

Outcome outcome_of(std::unique_ptr<ByteSource> source, std::optional<InputKind> kind,
                   std::size_t chunk) {
  Outcome outcome;
  double last_time_s = -std::numeric_limits<double>::infinity();
  try {
    ProfileReader reader(std::move(source), "fuzz", {kind});
    require(!kind || reader.kind() == *kind);
    std::array<ProfileRow, 16> rows{};
    while (const std::size_t count = reader.read(std::span(rows).first(chunk))) {
      for (const ProfileRow& row : std::span(rows).first(count)) {
        require_trustworthy(row, last_time_s);
        last_time_s = row.time_s;
        outcome.rows.push_back(row);
      }
    }
    require(!outcome.rows.empty());
  } catch (const hal::files::InputError& error) {
    outcome.error = error.what();
    host_sim::fuzz::require_one_line(outcome.error);
  }
  return outcome;
}

bool same(const ProfileRow& a, const ProfileRow& b) {
  return a.time_s == b.time_s && a.value == b.value &&
         a.tendon_velocity_m_s == b.tendon_velocity_m_s && a.bend_angle_deg == b.bend_angle_deg;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr std::array<std::optional<InputKind>, 4> kKinds{
      std::nullopt, InputKind::kInputTension, InputKind::kMotorCurrent, InputKind::kOutputTension};
  const auto kind = kKinds[size % kKinds.size()];
  const Outcome whole = outcome_of(hal::files::memory_source(text), kind, 16);
  const Outcome pieces = outcome_of(std::make_unique<PiecewiseSource>(text, 3), kind, 1);
  require(whole.error == pieces.error);
  require(whole.rows.size() == pieces.rows.size() || !whole.error.empty());
  require(whole.rows.size() <= pieces.rows.size());
  require(std::equal(whole.rows.begin(), whole.rows.end(), pieces.rows.begin(), same));
  return 0;
}
