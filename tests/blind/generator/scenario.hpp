#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blind {

/// How much is hidden in a campaign.
enum class CampaignKind { none, one, two, three, outside };

enum class Design {
  crossed,    ///< poses, loads, speeds, temperatures and cycles apart from each other
  one_pose,   ///< a field log: one pose, and temperature rising with the cycles
  two_sided,  ///< crossed, of a drive that works in both directions
};

/// What measures the tension at the drive's end.
enum class Input { load_cell, motor_current };

enum class Data { recordings, lives };

std::string_view name_of(CampaignKind kind);
std::string_view name_of(Design design);
std::string_view name_of(Input input);
std::string_view name_of(Data data);

/// A departure from the nominal model, with the values of its table in a plan.
struct HiddenEffect {
  std::string id;
  bool outside = false;  ///< not of the catalogue
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> texts;
};

/// Factors on parameters that are no effects and that every analysis refits: the value that
/// campaign.toml gives over the true one.
struct NominalFactors {
  double friction_coefficient = 1;
  double torque_constant = 1;
  double ipl_scale = 1;
  double ipl_exponent = 1;
  double weibull_shape = 1;
};

/// All that a campaign is made of; a function of its seed alone.
struct Scenario {
  std::uint64_t seed = 0;
  Data data = Data::recordings;
  CampaignKind kind = CampaignKind::none;
  Design design = Design::crossed;
  Input input = Input::load_cell;  ///< of recordings
  bool temperatures = false;       ///< whether recordings hold them
  std::size_t specimens = 0;       ///< of lives
  std::vector<HiddenEffect> hidden;
  NominalFactors nominal;
  std::string plan;  ///< TOML text for host_sim::synth::parse_synth_plan()
};

/// Seeds to tune with and seeds to score with have nothing in common.
inline constexpr std::uint64_t kFirstTuningSeed = 1, kLastTuningSeed = 9'999;
inline constexpr std::uint64_t kFirstScoringSeed = 100'000;

/// A campaign of 12 .. 36 recordings.
Scenario draw_recordings(std::uint64_t seed);

/// The same of a drive that works in both directions.
Scenario draw_two_sided(std::uint64_t seed);

/// A campaign of 48 or 96 lives. Attempts differ in design and sizes, not in what is hidden.
Scenario draw_lives(std::uint64_t seed, std::uint64_t attempt);

/// Lines of a TOML file, one key or table each.
std::string table(std::string_view name);
std::string line(std::string_view key, double value);
std::string line(std::string_view key, const std::vector<double>& values);
std::string line(std::string_view key, std::string_view word);
std::string line(std::string_view key, const std::vector<std::string>& texts);

/// [effects.<id>] or [outside.<id>].
std::string table_of(const HiddenEffect& effect);

}  // namespace blind
