// Writes synthetic campaigns for batches: make_campaigns FOLDER COUNT. Each has five levels of 20
// specimens that follow an inverse power law with one Weibull shape, whole cycles, some suspended.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "hal/files/output_file.hpp"
#include "host_sim/statistics/random.hpp"

namespace {

namespace fs = std::filesystem;
using host_sim::statistics::Random;

constexpr double kScale = 2e5;
constexpr double kExponent = 1.5;
constexpr double kShape = 6;
constexpr int kSpecimensInLevel = 20;
constexpr double kLongest_cycles = 1200;  // where a test is stopped

void write(const fs::path& path, const std::string& text) {
  hal::files::OutputFile file(path);
  file.write(text);
  file.commit();
}

std::string specimens(Random& random) {
  std::string text = "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status\n";
  int number = 0;
  for (const double tension_N : {30.0, 40.0, 50.0, 60.0, 70.0}) {
    for (int i = 0; i < kSpecimensInLevel; ++i) {
      const double life = kScale / std::pow(tension_N, kExponent) *
                          std::pow(-std::log(random.uniform()), 1 / kShape);
      const bool failed = life < kLongest_cycles;
      text +=
          fmt::format("s{},1,0,{},{:.0f},{}\n", ++number, tension_N,
                      std::ceil(failed ? life : kLongest_cycles), failed ? "failed" : "suspended");
    }
  }
  return text;
}

void make_campaign(const fs::path& folder, std::uint64_t number) {
  fs::create_directories(folder);
  Random random(1, 0, number);
  write(folder / "campaign.toml",
        fmt::format("[campaign]\nname = \"synthetic {}\"\n\n[model.cable]\ndiameter_mm = 0.457\n"
                    "ultimate_tension_N = 177.4\n",
                    number));
  write(folder / "specimens.csv", specimens(random));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "make_campaigns FOLDER COUNT\n";
    return 2;
  }
  try {
    const auto count = std::strtoull(argv[2], nullptr, 10);
    for (std::uint64_t i = 0; i < count; ++i) {
      make_campaign(fs::path(argv[1]) / fmt::format("campaign_{:04}", i), i);
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
