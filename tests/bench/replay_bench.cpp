#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string>

#include "host_sim/replay/replay.hpp"

namespace host_sim {

using hal::files::ProfileReader;

namespace {

namespace fs = std::filesystem;

constexpr int kRows = 1'000'000;
constexpr double kHysteresis_N = 0.2;

Model model() {
  return {.cable = {.diameter_mm = 0.457, .ultimate_tension_N = 177.4},
          .sheath = {.friction_coefficient = 0.128, .bend_angle_deg = 270},
          .drive = std::nullopt,
          .counting = {.sample_rate_Hz = 1000, .hysteresis_N = kHysteresis_N},
          .life = {.mean_stress = Model::MeanStress::kGerber,
                   .ipl_scale = 1.53e5,
                   .ipl_exponent = 1.38,
                   .weibull_shape = 5.94}};
}

double tension_N(int sample) {
  return 50 + 30 * std::sin(sample * 0.01) + 5 * std::sin(sample * 0.37);
}

/// Root mean square from one sample to the next.
double step_N() {
  double square_N2 = 0;
  for (int i = 1; i < kRows; ++i) {
    square_N2 += std::pow(tension_N(i) - tension_N(i - 1), 2);
  }
  return std::sqrt(square_N2 / (kRows - 1));
}

/// A million samples of 1 kHz, 19 MB, removed at the end.
class ProfileFile {
 public:
  ProfileFile()
      : path_(fs::temp_directory_path() / ("replay_bench-" + std::to_string(getpid()) + ".csv")) {
    std::ofstream out(path_);
    out << "time_s,input_tension_N\n" << std::fixed;
    for (int i = 0; i < kRows; ++i) {
      out << std::setprecision(3) << i * 1e-3 << ',' << std::setprecision(4) << tension_N(i)
          << '\n';
    }
  }
  ProfileFile(const ProfileFile&) = delete;
  ProfileFile& operator=(const ProfileFile&) = delete;
  ~ProfileFile() { fs::remove(path_); }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// By the number of threads that parse it.
void whole_replay(benchmark::State& state) {
  const ProfileFile file;
  for (auto _ : state) {
    ProfileReader profile(file.path(), {{}, static_cast<unsigned>(state.range(0))});
    benchmark::DoNotOptimize(replay(profile, model(), "model", {}));
  }
  state.SetItemsProcessed(state.iterations() * kRows);
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(fs::file_size(file.path())));
  std::ostringstream label;
  label << std::setprecision(3) << "steps of " << step_N() << " N, hysteresis " << kHysteresis_N
        << " N";
  state.SetLabel(label.str());
}
BENCHMARK(whole_replay)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace host_sim
