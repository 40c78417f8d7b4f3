#pragma once

#include <span>
#include <string_view>

#include "host_sim/io/model.hpp"
#include "host_sim/io/toml_table.hpp"

namespace host_sim {

/// The names of the tables of a model, in the order of the file format.
std::span<const std::string_view> model_table_names();

/// The tables of a model: those at the top of model.toml, or those in [model] of a campaign.
class ModelTables {
 public:
  /// Throws InputError for unknown keys in a table of a model, and for one that is no table.
  explicit ModelTables(TomlTable above);

  bool has(std::string_view table) const { return above_.has(table); }

  /// Reads all keys of one table into their places in `model`.
  /// @throws InputError for a table or key that is missing, of the wrong type or out of range
  void read(std::string_view table, Model& model) const;

  /// Throws InputError where the hysteresis is not below the ultimate tension.
  /// @pre [cable] and [counting] have been read into `model`
  void check_hysteresis(const Model& model) const;

 private:
  TomlTable existing(std::string_view table) const;

  TomlTable above_;
};

/// The nominal model in the tables of a whole model.toml, in which the tables `others` may stand
/// besides. @throws InputError as read_model()
Model nominal_model_of(const TomlTable& top, std::span<const std::string_view> others);

}  // namespace host_sim
