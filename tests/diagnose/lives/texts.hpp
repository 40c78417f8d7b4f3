#pragma once

#include <fmt/format.h>

#include <string>

#include "hal/files/input_file.hpp"
#include "host_sim/campaign/campaign_files.hpp"

namespace host_sim::diagnose::lives::test {

inline constexpr const char* kPaperLife =
    "[model.life]\nmean_stress = \"gerber\"\nipl_scale = 1.53e5\nipl_exponent = 1.38\n"
    "weibull_shape = 5.94\n";

/// A campaign of the text of specimens.csv, with T_u and, unless told otherwise, the law of the
/// paper.
inline Campaign campaign_of(const std::string& specimens, double ultimate_tension_N = 177.4,
                            const char* life = kPaperLife) {
  const std::string model = fmt::format(
      "[campaign]\nname = \"text\"\n[model.cable]\ndiameter_mm = 0.457\nultimate_tension_N = {}\n"
      "{}",
      ultimate_tension_N, life);
  return assemble(parse_campaign_file(model, "campaign.toml"),
                  parse_specimens(hal::files::memory_source(specimens), "specimens.csv"), {});
}

inline const std::string kHeader =
    "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status,role\n";

}  // namespace host_sim::diagnose::lives::test
