#include "host_sim/io/model.hpp"

#include <span>
#include <string_view>
#include <vector>

#include "host_sim/io/model_tables.hpp"
#include "host_sim/io/text_file.hpp"
#include "host_sim/io/toml_table.hpp"

namespace host_sim {
namespace {

constexpr std::string_view kSchema = "schema";

void check_schema(const TomlTable& top) {
  constexpr std::string_view kAccepted = "schema = 1";
  const toml::node& schema = top.node(kSchema, kAccepted);
  const auto* const value = schema.as_integer();
  if (value == nullptr || value->get() != 1) {
    top.fail(top.place_of(kSchema), "schema is " + describe(schema), kAccepted);
  }
}

void refuse_unknown_tables(const TomlTable& top, std::span<const std::string_view> others) {
  std::vector<std::string_view> known{kSchema};
  known.insert(known.end(), model_table_names().begin(), model_table_names().end());
  known.insert(known.end(), others.begin(), others.end());
  top.refuse_unknown_keys({}, known);
}

}  // namespace

Model nominal_model_of(const TomlTable& top, std::span<const std::string_view> others) {
  check_schema(top);
  refuse_unknown_tables(top, others);
  const ModelTables tables(top);
  Model model{};
  for (const std::string_view table : model_table_names()) {
    if (table != "drive" || tables.has(table)) {
      tables.read(table, model);
    }
  }
  tables.check_hysteresis(model);
  return model;
}

Model parse_model(std::string_view text, std::string_view name) {
  const toml::table values = parse_toml(text, name);
  return nominal_model_of({name, values, "", {}}, {});
}

Model read_model(const std::filesystem::path& path) {
  return parse_model(read_text_file(path, "a model file (TOML) of at most 1 MiB"), file_name(path));
}

}  // namespace host_sim
