#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/text.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::fleet {

/// That a plan can be made for.
inline constexpr hal::files::NumberRange kDamagePerHourRange{0, 100};

/// A tendon in the field.
struct Tendon {
  std::string name = {};
  double damage = 0;          ///< Miner, that its model gives for what it has done; 0 .. 100
  double damage_per_h = 0;    ///< mean, for each hour of operation, in kDamagePerHourRange
  double rate_log_sd = 0;     ///< how far the mean rate until the horizon may be from it, in ln
  double hours_per_day = 24;  ///< of operation, 0 .. 24
  std::optional<double> effective_tension_N = {};  ///< that its damage is from, where that is known
  std::optional<double> replacement_cost = {};     ///< of a planned replacement, where its own
  std::optional<double> break_cost = {};           ///< of a break with the replacement after it
  std::size_t model = 0;                           ///< in Fleet::models
};

/// A law of life that tendons share, and with it what is not known of it.
struct FleetModel {
  std::string file;
  Model model;
};

struct Fleet {
  std::vector<Tendon> tendons;  ///< in the order of the table, at least one
  std::vector<FleetModel> models;
  std::vector<std::string> broken;  ///< names of tendons that are left out, for theirs has broken
  std::vector<std::string> doubts;  ///< what the tendons are not sure by, in sentences
};

/// A row of a table, whose model is not read yet.
struct TendonRow {
  Tendon tendon;
  std::optional<double> age_h;  ///< hours of operation so far, where that is known
  std::string model;  ///< path from the folder of the table; empty where the row gives none
};

/// Reads a table of tendons (CSV): `tendon`, `damage`, `hours_per_day`, and `damage_per_h` or
/// `age_h`, the hours of operation in which a tendon has got its damage; optionally `rate_log_sd`,
/// `effective_tension_N`, `model`, `cost_replace`, `cost_break`.
/// @param name stands for the file in errors
/// @throws InputError for anything that is missing, unknown, out of range or there twice
std::vector<TendonRow> parse_fleet_table(std::unique_ptr<hal::files::ByteSource> source,
                                         std::string_view name);

/// A table of these tendons that parse_fleet_table() reads, with a comment that names the `broken`.
std::string fleet_table_text(const std::vector<TendonRow>& rows,
                             const std::vector<std::string>& broken);

/// The files of the models that rows name, each once, in order; `table` is where they are from.
std::vector<std::filesystem::path> models_of(const std::vector<TendonRow>& rows,
                                             const std::filesystem::path& table);

/// The fleet with its models. A row without a model takes `model`, which may be empty where every
/// row has its own.
/// @throws InputError
Fleet fleet_of(const std::vector<TendonRow>& rows, const std::filesystem::path& table,
               const std::string& model);

}  // namespace host_sim::fleet
