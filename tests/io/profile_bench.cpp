#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "hal/files/profile.hpp"

namespace {

using hal::files::ProfileReader;
using hal::files::ProfileRow;

constexpr int kRows = 200000;

std::string short_decimals() {
  std::string text = "time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg\n";
  for (int i = 0; i < kRows; ++i) {
    const double time_s = i * 0.005;
    text += fmt::format("{:.3f},{:.4f},{:.6f},270.0\n", time_s,
                        38.5 - 10.0 * std::cos(2.1 * time_s), 0.052 * std::sin(2.1 * time_s));
  }
  return text;
}

std::string two_columns() {
  std::string text = "time_s,motor_current_A\n";
  for (int i = 0; i < kRows; ++i) {
    text += fmt::format("{:.4f},{:.3f}\n", i * 0.001, 2.0 + std::sin(0.01 * i));
  }
  return text;
}

std::string full_precision() {
  std::string text = "time_s,input_tension_N\n";
  for (int i = 0; i < kRows; ++i) {
    text += fmt::format("{:.17g},{:.17g}\n", i * 0.001, 50.0 + 30.0 * std::sin(0.01 * i));
  }
  return text;
}

std::string quoted_fields() {
  std::string text = "\"time_s\",\"input_tension_N\"\r\n";
  for (int i = 0; i < kRows; ++i) {
    text += fmt::format("\"{:.3f}\",\"{:.3f}\"\r\n", i * 0.001, 50.0 + 30.0 * std::sin(0.01 * i));
  }
  return text;
}

void read_all(benchmark::State& state, const std::string& text) {
  std::array<ProfileRow, 4096> rows{};
  for (auto _ : state) {
    ProfileReader reader(hal::files::memory_source(text), "benchmark");
    while (const std::size_t count = reader.read(rows)) {
      benchmark::DoNotOptimize(rows[count - 1]);
    }
  }
  const auto iterations = static_cast<std::int64_t>(state.iterations());
  state.SetBytesProcessed(iterations * static_cast<std::int64_t>(text.size()));
  state.SetItemsProcessed(iterations * kRows);
}

BENCHMARK_CAPTURE(read_all, short_decimals, short_decimals());
BENCHMARK_CAPTURE(read_all, two_columns, two_columns());
BENCHMARK_CAPTURE(read_all, full_precision, full_precision());
BENCHMARK_CAPTURE(read_all, quoted_fields, quoted_fields());

}  // namespace

BENCHMARK_MAIN();
