#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <string>

#include "host_sim/replay/replay.hpp"

namespace host_sim {

using hal::files::ProfileReader;

namespace {

namespace fs = std::filesystem;

constexpr int kRows = 1'000'000;

Model model() {
  return {.cable = {.diameter_mm = 0.457, .ultimate_tension_N = 177.4},
          .sheath = {.friction_coefficient = 0.128, .bend_angle_deg = 270},
          .drive = std::nullopt,
          .counting = {.sample_rate_Hz = 1000, .hysteresis_N = 0.2},
          .life = {.mean_stress = Model::MeanStress::kGerber,
                   .ipl_scale = 1.53e5,
                   .ipl_exponent = 1.38,
                   .weibull_shape = 5.94}};
}

/// A million samples of 1 kHz, 19 MB, removed at the end.
class ProfileFile {
 public:
  ProfileFile()
      : path_(fs::temp_directory_path() / ("replay_bench-" + std::to_string(getpid()) + ".csv")) {
    std::ofstream out(path_);
    out << "time_s,input_tension_N\n" << std::fixed;
    for (int i = 0; i < kRows; ++i) {
      out << std::setprecision(3) << i * 1e-3 << ',' << std::setprecision(4)
          << 50 + 30 * std::sin(i * 0.01) + 5 * std::sin(i * 0.37) << '\n';
    }
  }
  ProfileFile(const ProfileFile&) = delete;
  ProfileFile& operator=(const ProfileFile&) = delete;
  ~ProfileFile() { fs::remove(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void whole_replay(benchmark::State& state) {
  const ProfileFile file;
  for (auto _ : state) {
    ProfileReader profile(file.path());
    benchmark::DoNotOptimize(replay(profile, model(), "model", {}));
  }
  state.SetItemsProcessed(state.iterations() * kRows);
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(fs::file_size(file.path())));
}
BENCHMARK(whole_replay)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace host_sim
