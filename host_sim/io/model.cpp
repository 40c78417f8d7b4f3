#include "host_sim/io/model.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "host_sim/io/byte_source.hpp"
#include "host_sim/io/input_error.hpp"
#include "host_sim/io/model_keys.hpp"
#include "host_sim/io/printable.hpp"
#include "host_sim/io/unit_suffix.hpp"

namespace host_sim {
namespace {

constexpr std::size_t kSizeLimit = std::size_t{1} << 20;
constexpr std::array<std::string_view, 5> kTables{"cable", "sheath", "drive", "counting", "life"};
constexpr std::string_view kMeanStress = "mean_stress";

std::string describe(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) {
    if constexpr (toml::is_string<decltype(value)>) {
      text << in_quotes(value.get());
    } else if constexpr (toml::is_table<decltype(value)>) {
      text << "a table";
    } else if constexpr (toml::is_array<decltype(value)>) {
      text << "an array";
    } else {
      text << value;
    }
  });
  return text.str();
}

class ModelReader {
 public:
  ModelReader(std::string_view text, std::string_view name) : name_(name), root_(parse(text)) {}

  Model read() {
    check_schema();
    check_tables();
    Model model{};
    if (root_.contains("drive")) {
      model.drive.emplace();
    }
    for (const ModelKey& key : model_keys()) {
      if (key.table != "drive" || model.drive) {
        key.value(model) = number(key);
      }
    }
    model.life.mean_stress = mean_stress();
    check_hysteresis(model);
    return model;
  }

 private:
  toml::table parse(std::string_view text) const {
    try {
      return toml::parse(text);
    } catch (const toml::parse_error& error) {
      fail(error.source().begin, error.description(), "TOML 1.0");
    }
  }

  [[noreturn]] void fail(toml::source_position at, std::string_view found,
                         std::string_view accepted) const {
    throw InputError(name_, at.line, at.column, found, accepted);
  }

  static toml::source_position place(const toml::table& table, std::string_view key) {
    const auto found = table.find(key);
    return found == table.end() ? table.source().begin : found->first.source().begin;
  }

  void check_schema() const {
    constexpr std::string_view kAccepted = "schema = 1";
    const toml::node* const schema = root_.get("schema");
    if (schema == nullptr) {
      fail({}, "no key schema", kAccepted);
    }
    const auto* const value = schema->as_integer();
    if (value == nullptr || value->get() != 1) {
      fail(place(root_, "schema"), "schema is " + describe(*schema), kAccepted);
    }
  }

  void check_tables() const {
    for (const auto& [key, node] : root_) {
      if (key == "schema") {
        continue;
      }
      if (std::find(kTables.begin(), kTables.end(), key.str()) == kTables.end()) {
        fail(key.source().begin,
             fmt::format("unknown {} {}", node.is_table() ? "table" : "key", in_quotes(key.str())),
             fmt::format("schema, {}", fmt::join(kTables, ", ")));
      }
      if (!node.is_table()) {
        fail(key.source().begin, fmt::format("{} is {}", key.str(), describe(node)),
             fmt::format("a table [{}]", key.str()));
      }
      check_keys(key.str(), *node.as_table());
    }
  }

  void check_keys(std::string_view table_name, const toml::table& table) const {
    for (const auto& [key, node] : table) {
      if (!is_known(table_name, key.str())) {
        fail_unknown(table_name, key);
      }
    }
  }

  static bool is_known(std::string_view table, std::string_view name) {
    if (table == "life" && name == kMeanStress) {
      return true;
    }
    for (const ModelKey& key : model_keys()) {
      if (key.table == table && key.key == name) {
        return true;
      }
    }
    return false;
  }

  [[noreturn]] void fail_unknown(std::string_view table, const toml::key& found) const {
    std::string accepted;
    for (const ModelKey& key : model_keys()) {
      if (key.table != table) {
        continue;
      }
      if (const auto unit = other_unit(found.str(), key.key, key.unit)) {
        fail(found.source().begin,
             unit->empty() ? fmt::format("key {} without its unit", in_quotes(found.str()))
                           : fmt::format("unknown unit {} of key {}", in_quotes(*unit),
                                         in_quotes(found.str())),
             fmt::format("{} {}", key.key, range_text(key)));
      }
      accepted += accepted.empty() ? "" : ", ";
      accepted += key.key;
    }
    if (table == "life") {
      accepted += fmt::format(", {}", kMeanStress);
    }
    fail(found.source().begin, fmt::format("unknown key {} in [{}]", in_quotes(found.str()), table),
         accepted);
  }

  const toml::table& table_of(std::string_view table, std::string_view key) const {
    const toml::node* const found = root_.get(table);
    if (found == nullptr) {
      fail({}, fmt::format("no table [{}]", table), fmt::format("[{}] with {}", table, key));
    }
    return *found->as_table();
  }

  const toml::node& node_of(std::string_view table_name, std::string_view key,
                            std::string_view accepted) const {
    const toml::node* const node = table_of(table_name, key).get(key);
    if (node == nullptr) {
      fail(place(root_, table_name), fmt::format("no key {} in [{}]", key, table_name), accepted);
    }
    return *node;
  }

  double number(const ModelKey& key) const {
    const std::string accepted = fmt::format("{} {}", key.key, range_text(key));
    const toml::node& node = node_of(key.table, key.key, accepted);
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    const bool inside = value && *value <= key.maximum &&
                        (key.above_minimum ? *value > key.minimum : *value >= key.minimum);
    if (!inside) {
      fail(place(table_of(key.table, key.key), key.key),
           fmt::format("{} is {}", key.key, describe(node)), accepted);
    }
    return *value;
  }

  Model::MeanStress mean_stress() const {
    constexpr std::string_view kAccepted = "mean_stress \"gerber\"";
    const toml::node& node = node_of("life", kMeanStress, kAccepted);
    const auto* const value = node.as_string();
    if (value == nullptr || value->get() != "gerber") {
      fail(place(table_of("life", kMeanStress), kMeanStress),
           fmt::format("{} is {}", kMeanStress, describe(node)), kAccepted);
    }
    return Model::MeanStress::kGerber;
  }

  void check_hysteresis(const Model& model) const {
    if (model.counting.hysteresis_N >= model.cable.ultimate_tension_N) {
      fail(
          place(table_of("counting", "hysteresis_N"), "hysteresis_N"),
          fmt::format("hysteresis_N is {}", model.counting.hysteresis_N),
          fmt::format("less than ultimate_tension_N, which is {}", model.cable.ultimate_tension_N));
    }
  }

  std::string name_;
  toml::table root_;
};

}  // namespace

Model parse_model(std::string_view text, std::string_view name) {
  return ModelReader(text, name).read();
}

Model read_model(const std::filesystem::path& path) {
  constexpr std::string_view kAccepted = "a model file (TOML) of at most 1 MiB";
  const auto source = open_source(path, kAccepted);
  std::string text(kSizeLimit + 1, '\0');
  std::size_t size = 0;
  while (size < text.size()) {
    const std::size_t count = source->read({text.data() + size, text.size() - size});
    if (count == 0) {
      text.resize(size);
      return parse_model(text, path == "-" ? "standard input" : path.string());
    }
    size += count;
  }
  throw InputError(path.string(), 0, 0, "larger than 1 MiB", kAccepted);
}

}  // namespace host_sim
