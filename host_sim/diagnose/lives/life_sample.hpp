#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::diagnose::lives {

/// The specimens of a campaign as every step of the diagnosis sees them.
struct LifeSample {
  struct Block {
    double mean_N = 0;       ///< T_m of input tension
    double amplitude_N = 0;  ///< T_a
    double effective_N = 0;  ///< T_eff by Gerber
    double cycles = 0;
    std::size_t level = 0;
    /// Of the first block that of the specimen; of a later one that of the specimens under its
    /// load alone, where they have one and the same.
    double wire_to_bend_ratio = 0;
  };
  enum class Order { constant, falling, rising };  ///< of the tensions of blocks, first to last

  struct Specimen {
    std::string name, lot;
    std::vector<Block> blocks;  ///< at least one, in order of loading
    Order order = Order::constant;
    bool failed = true;
    std::size_t load = 0;        ///< among equal loads; specimens in blocks have kNoLoad
    std::size_t lot_number = 0;  ///< in order of the names
    std::size_t group = 0;       ///< in order of the names
    double days = 0;

    [[nodiscard]] double cycles() const;
    [[nodiscard]] const Block& last() const { return blocks.back(); }
  };
  static constexpr std::size_t kNoLoad = static_cast<std::size_t>(-1);

  std::vector<Specimen> specimens;
  /// All that were there before some were left out: what a centre of tensions is the mean of.
  std::shared_ptr<const std::vector<Specimen>> reference;
  std::size_t levels = 0;  ///< T_eff more than 3 % apart, of all blocks
  std::size_t loads = 0;   ///< distinct pairs of mean and amplitude; the levels where too many
  std::size_t lots = 0;
  std::size_t groups = 0;
  bool has_days = false;               ///< of each specimen
  bool has_ratios = false;             ///< of each specimen
  double lowest_N = 0, highest_N = 0;  ///< T_eff of all blocks
  double ultimate_tension_N = 0;       ///< infinite where the campaign has none
  std::optional<Model::Life> nominal;  ///< what the campaign took to be the law

  [[nodiscard]] std::size_t size() const { return specimens.size(); }
  [[nodiscard]] std::size_t failures() const;
  /// The same with some specimens alone; levels, loads, lots and groups keep their numbers.
  [[nodiscard]] LifeSample with(const std::vector<std::size_t>& kept) const;
};

/// Specimens of one role.
LifeSample sample_of(const Campaign& campaign, Campaign::Role role);

}  // namespace host_sim::diagnose::lives
