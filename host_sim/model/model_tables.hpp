#pragma once

#include <span>
#include <string_view>

#include "hal/files/text.hpp"
#include "hal/files/toml_table.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// A number in `model.toml`: where it stands, what it may be, and where it goes.
struct ModelKey {
  std::string_view table;
  std::string_view key;
  std::string_view unit;  ///< the suffix of `key`, empty if it has none
  hal::files::NumberRange range;
  double& (*value)(Model&);
};

/// All numbers of a model, grouped by table, in the order of the file format.
std::span<const ModelKey> model_keys();

/// The name of a law of mean stress, as files have it.
std::string_view name_of(Model::MeanStress law);

/// The names of the tables of a model, in the order of the file format.
std::span<const std::string_view> model_table_names();

/// The tables of a model: those at the top of model.toml, or those in [model] of a campaign.
class ModelTables {
 public:
  /// Throws InputError for unknown keys in a table of a model, and for one that is no table.
  explicit ModelTables(hal::files::TomlTable above);

  bool has(std::string_view table) const { return above_.has(table); }

  /// Reads all keys of one table into their places in `model`.
  /// @throws InputError for a table or key that is missing, of the wrong type or out of range
  void read(std::string_view table, Model& model) const;

  /// Throws InputError where the hysteresis is not below the ultimate tension.
  /// @pre [cable] and [counting] have been read into `model`
  void check_hysteresis(const Model& model) const;

  /// Throws InputError where a tension of [watch] is not below the ultimate one.
  /// @pre [cable] has been read into `model`, and [watch] where there is one
  void check_watched_tensions(const Model& model) const;

 private:
  hal::files::TomlTable existing(std::string_view table) const;

  hal::files::TomlTable above_;
};

/// Whether a file says nothing of its schema, or that it is of schema 1.
/// @throws InputError where it says anything else
void check_schema(const hal::files::TomlTable& top);

/// What the tables in [model] of a campaign or plan say.
/// @throws InputError as read_model(), but not for tables that are missing
NominalModel known_tables_of(const hal::files::TomlTable& model);

/// The nominal model in the tables of a whole model.toml, in which the tables `others` may stand
/// besides. @throws InputError as read_model()
Model nominal_model_of(const hal::files::TomlTable& top, std::span<const std::string_view> others);

}  // namespace host_sim
