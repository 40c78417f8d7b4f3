// Writes specimens.csv of the example campaign: the paper's life tests, synthetic.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <iterator>
#include <string>
#include <string_view>

#include "host_sim/examples/tendon_alt_samples.hpp"
#include "host_sim/io/output_file.hpp"

namespace {

constexpr std::string_view kHeader =
    "# Synthetic, not measured: whole cycles drawn so that the Weibull fit of each level equals "
    "the\n"
    "# one printed in the paper's Table 4, 20 specimens a level under 49.0 N of output tension, "
    "and\n"
    "# the mean that of its Figure 10. 315 to 450 deg share the shape 5.94.\n"
    "# UA: the upper-arm application of section 4.1, mean life 1.00e3, 8 of 10 within B10 to B90.\n"
    "specimen,lot,bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N,cycles,status,"
    "role\n";

void append(std::string& text, std::string_view name, std::string_view load, std::string_view role,
            const host_sim::statistics::Sample& sample) {
  int number = 0;
  for (const host_sim::statistics::Observation& observation : sample) {
    fmt::format_to(std::back_inserter(text), "{}-{:02},1,{},{:.0f},failed,{}\n", name, ++number,
                   load, observation.value, role);
  }
}

std::string specimens() {
  std::string text(kHeader);
  const auto lives = tendon_alt::lives_by_level();
  for (std::size_t level = 0; level < lives.size(); ++level) {
    const int bend_angle_deg = tendon_alt::kPrinted[level].bend_angle_deg;
    append(text, fmt::format("T{}", bend_angle_deg), fmt::format("{}.0,49.0,0.0", bend_angle_deg),
           bend_angle_deg == 270 ? "validation" : "fit", lives[level]);
  }
  append(text, "UA", "270.0,38.5,10.0", "validation", tendon_alt::lives_of_upper_arm());
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} FILE.csv\n", argv[0]);
    return 2;
  }
  try {
    host_sim::write_file(argv[1], specimens());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
