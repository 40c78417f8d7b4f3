#pragma once

#include <string>

#include "tests/replay/program.hpp"

namespace host_sim_test {

/// host_sim with a campaign in its folder: `c`, three levels of five specimens.
class CampaignProgram : public Program {
 protected:
  static constexpr const char* kHead =
      "specimen,lot,input_tension_mean_N,input_tension_amplitude_N,cycles,status\n";

  void SetUp() override {
    Program::SetUp();
    write_campaign("c", specimens());
  }

  void write_campaign(const std::string& name, const std::string& specimens) const {
    fs::create_directories(folder_ / name);
    write(name + "/campaign.toml", toml());
    write(name + "/specimens.csv", kHead + specimens);
  }

  /// With all that `--out` needs.
  static std::string toml() {
    return "[campaign]\nname = \"small\"\n\n[model.cable]\ndiameter_mm = 0.457\n"
           "ultimate_tension_N = 177.4\n\n[model.sheath]\nfriction_coefficient = 0.128\n"
           "bend_angle_deg = 270.0\n\n[model.counting]\nsample_rate_Hz = 200.0\n"
           "hysteresis_N = 0.2\n";
  }

  static std::string specimens() {
    return level("a", 40, 800) + level("b", 50, 570) + level("c", 60, 430);
  }

  /// Five lives around `life_cycles`.
  static std::string level(const std::string& name, int tension_N, int life_cycles) {
    std::string text;
    int number = 0;
    for (const int permil : {780, 900, 1000, 1080, 1170}) {
      text += row(name + std::to_string(++number), tension_N,
                  std::to_string(life_cycles * permil / 1000), "failed");
    }
    return text;
  }

  static std::string row(const std::string& name, int tension_N, const std::string& cycles,
                         const std::string& status) {
    return name + ",1,0," + std::to_string(tension_N) + "," + cycles + "," + status + "\n";
  }
};

}  // namespace host_sim_test
