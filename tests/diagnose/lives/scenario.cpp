#include "tests/diagnose/lives/scenario.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "hal/files/input_file.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/campaign/make.hpp"

namespace host_sim::test {

using hal::files::memory_source;

namespace {

constexpr std::uint64_t kSizeStream = 77;

const char* const kModel = R"(schema = 1
[campaign]
name = "simulated"
[model.cable]
diameter_mm = 0.457
ultimate_tension_N = 177.4
[model.sheath]
friction_coefficient = 0.128
bend_angle_deg = 270.0
[model.life]
mean_stress = "gerber"
ipl_scale = 1.53e5
ipl_exponent = 1.38
weibull_shape = 5.94
[lives]
lots = 4
rigs = 2
storage_days = [1.0, 10.0, 60.0]
record_days = true
)";

/// T_eff of the fourth and of the last level.
constexpr double kLowest_N = 22.9;
constexpr double kHighest_N = 78.1;

struct Level {
  double angle_deg, mean_N, amplitude_N, ratio, suspend_cycles;
};
constexpr Level kLevels[] = {{90, 24.5, 24.5, 0.03, 3500},   {270, 24.5, 24.5, 0.03, 20000},
                             {270, 24.5, 24.5, 0.08, 20000}, {45, 60, 14, 0.05, 20000},
                             {180, 35, 20, 0.03, 20000},     {450, 24.5, 24.5, 0.05, 20000}};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed, kSizeStream, 0) {}
  double between(double low, double high) { return low + (high - low) * random_.uniform(); }

 private:
  statistics::Random random_;
};

std::string table_of(const std::string& id, Draw& draw) {
  if (id == "mean_stress") {
    const double law = draw.between(0, 3);
    return law < 1   ? fmt::format("walker_exponent = {}\n", draw.between(0.4, 0.8))
           : law < 2 ? "law = \"goodman\"\n"
                     : "law = \"swt\"\n";
  }
  if (id == "bending_fatigue") {
    const double share = std::exp(draw.between(std::log(100), std::log(800))) / 9500;
    return fmt::format("metal_area_mm2 = 0.1\nshare = {}\n", share);
  }
  if (id == "endurance_limit") {
    return fmt::format("limit_N = {}\nlog_sd = {}\n", kLowest_N * draw.between(0.35, 0.9),
                       draw.between(0.02, 0.2));
  }
  if (id == "load_sequence") {
    return fmt::format("exponent = {}\n", draw.between(0.2, 0.6));
  }
  if (id == "second_mode") {
    const bool from_top = draw.between(0, 1) < 0.7;
    const double reference_N = from_top ? kHighest_N : kLowest_N;
    const double life = 1.53e5 * std::pow(reference_N, -1.38) * std::exp(draw.between(-0.6, 0.1));
    return fmt::format("life_cycles = {}\nreference_N = {}\nexponent = {}\nshape = {}\n", life,
                       reference_N, from_top ? draw.between(3.5, 9) : 0, draw.between(1.5, 4.5));
  }
  if (id == "lot_frailty") {
    return fmt::format("log_sd = {}\n", draw.between(0.1, 0.4));
  }
  if (id == "ageing") {
    return fmt::format("rate_1_day = {}\n", draw.between(0.2, 0.9) / 60);
  }
  if (id == "rig_bias") {
    return fmt::format("share = {}\n",
                       draw.between(0.08, 0.2) * (draw.between(0, 1) < 0.5 ? 1 : -1));
  }
  if (id == "early_deaths") {
    return fmt::format("share = {}\nlife_left = {}\n", draw.between(0.08, 0.2),
                       draw.between(0.1, 0.5));
  }
  throw std::invalid_argument(id);
}

}  // namespace

std::string plan_text(const Scenario& scenario) {
  std::string text = kModel;
  constexpr std::size_t kParts = 8;
  for (const Level& level : kLevels) {
    text += fmt::format(
        "[[lives.level]]\nbend_angle_deg = {}\noutput_tension_mean_N = {}\n"
        "output_tension_amplitude_N = {}\nspecimens = {}\nsuspend_at_cycles = {}\n"
        "wire_to_bend_ratio = {}\n",
        level.angle_deg, level.mean_N, level.amplitude_N, scenario.specimens / kParts,
        level.suspend_cycles, level.ratio);
  }
  for (const char* program :
       {"levels = [6, 2]\ncycles = [150.0]", "levels = [2, 6]\ncycles = [500.0]"}) {
    text += fmt::format("[[lives.program]]\n{}\nspecimens = {}\n", program,
                        scenario.specimens / kParts);
  }
  Draw draw(scenario.seed);
  std::istringstream ids(scenario.hidden == "none" ? "" : scenario.hidden);
  for (std::string id; std::getline(ids, id, '+');) {
    const bool outside = id == "rig_bias" || id == "early_deaths";
    text += fmt::format("[{}.{}]\n{}", outside ? "outside" : "effects", id, table_of(id, draw));
  }
  return text;
}

Campaign simulated(const std::string& text, std::uint64_t seed) {
  const synth::SynthPlan plan = synth::parse_synth_plan(text, "plan");
  const synth::LifeTexts texts = synth::life_texts(plan, seed);
  return assemble(parse_campaign_file(campaign_text(plan), "campaign.toml"),
                  parse_specimens(memory_source(texts.specimens), "specimens.csv"),
                  parse_blocks(memory_source(texts.blocks), "blocks.csv"));
}

Campaign simulated(const Scenario& scenario) {
  return simulated(plan_text(scenario), scenario.seed);
}

}  // namespace host_sim::test
