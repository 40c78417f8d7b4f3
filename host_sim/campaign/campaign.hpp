#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hal/files/column_map.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// A test as its folder holds it: campaign.toml, specimens.csv with the lives, and blocks.csv where
/// specimens were loaded in blocks. Recordings, which sessions.csv names, are read elsewhere.
struct Campaign {
  enum class Status {
    failed,
    suspended,     ///< taken out before it failed
    left,          ///< found broken when first inspected
    interval,      ///< found broken, and not so at the inspection before
    trimmed_low,   ///< its life was dropped as one of the lowest of its level
    trimmed_high,  ///< the same, of the highest
  };
  enum class Role { fit, validation };

  /// A constant load. Input tension is what was given, or what (12) - (14) make of output tension
  /// and bend angle.
  struct Load {
    std::optional<double> bend_angle_deg;
    double input_tension_mean_N = 0;
    double input_tension_amplitude_N = 0;
    double effective_tension_N = 0;  ///< Gerber, eq. (11)
  };

  struct Block {
    Load load;
    double cycles = 0;
    std::uint64_t line = 0;  ///< in blocks.csv, or in specimens.csv where there is one load
  };

  struct Specimen {
    std::string name;
    std::string lot;
    std::string group;  ///< empty where none
    Status status = Status::failed;
    Role role = Role::fit;
    /// At least one, in order. Of a specimen found broken up to then; of one that was trimmed up to
    /// the lowest or highest life of its level that was kept.
    std::vector<Block> blocks;
    double from_cycles = 0;  ///< of status interval: when it was not broken yet
    std::optional<double> days;
    std::optional<double> wire_to_bend_ratio;
    std::uint64_t line = 0;  ///< in specimens.csv

    [[nodiscard]] bool constant_load() const { return blocks.size() == 1; }
    [[nodiscard]] bool trimmed() const {
      return status == Status::trimmed_low || status == Status::trimmed_high;
    }
    /// Known to be broken at its cycles, without its life being known.
    [[nodiscard]] bool found_broken() const {
      return status == Status::left || status == Status::interval;
    }
    [[nodiscard]] double cycles() const;  ///< of all blocks
  };

  /// A load that the life is wanted for: one load, or a mix of several.
  struct Use {
    struct Part {
      Load load;
      double share = 1;  ///< of the cycles; all parts sum to 1
    };
    std::string name;
    std::vector<Part> parts;  ///< at least one
  };

  std::string name;
  std::filesystem::path folder;
  hal::files::ColumnOptions columns;  ///< how those of recordings are taken
  /// Motor, gear and joint work in both directions, as an antagonistic pair does: forces have
  /// signs.
  bool two_sided = false;
  std::vector<Use> uses;  ///< [[use]] of campaign.toml
  NominalModel nominal;
  /// In order of their names, whatever the order in the file; none where the campaign holds
  /// recordings only: sessions.csv and no specimens.csv.
  std::vector<Specimen> specimens;
};

/// Reads and checks a campaign; refused whole with file, line and column for anything that cannot
/// be trusted.
/// @throws InputError
Campaign read_campaign(const std::filesystem::path& folder);

/// The specimens of one constant load.
struct Level {
  Campaign::Load load;
  Campaign::Role role = Campaign::Role::fit;
  std::vector<const Campaign::Specimen*> specimens;
};

/// Specimens of constant load by level and role, in order of effective tension; loads are one level
/// where bend angle and both tensions are equal.
std::vector<Level> levels_of(const Campaign& campaign);

/// Whether `folder` is a campaign: a folder that holds a campaign.toml.
bool is_campaign(const std::filesystem::path& folder);

/// The campaigns directly below `folder`, sorted by name; none is no error.
/// @throws InputError where `folder` is not a folder that can be read
std::vector<std::filesystem::path> list_campaigns(const std::filesystem::path& folder);

/// Whether a campaign has this file, be it one that can be read or not.
bool is_there(const std::filesystem::path& file);

}  // namespace host_sim
