#include "host_sim/io/model_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "host_sim/io/model_keys.hpp"

namespace host_sim {
namespace {

constexpr std::array<std::string_view, 5> kTables{"cable", "sheath", "drive", "counting", "life"};
constexpr std::array<std::string_view, 1> kMeanStress{"mean_stress"};

NumberKey number_key(const ModelKey& key) {
  return {key.key, key.unit, key.range};
}

std::vector<NumberKey> number_keys(std::string_view table) {
  std::vector<NumberKey> keys;
  for (const ModelKey& key : model_keys()) {
    if (key.table == table) {
      keys.push_back(number_key(key));
    }
  }
  return keys;
}

std::span<const std::string_view> other_keys(std::string_view table) {
  return table == "life" ? std::span<const std::string_view>(kMeanStress)
                         : std::span<const std::string_view>();
}

Model::MeanStress mean_stress(const TomlTable& life) {
  constexpr std::string_view kAccepted = "mean_stress \"gerber\"";
  const std::string_view key = kMeanStress.front();
  const toml::node& node = life.node(key, kAccepted);
  const auto* const value = node.as_string();
  if (value == nullptr || value->get() != "gerber") {
    life.fail(life.place_of(key), fmt::format("{} is {}", key, describe(node)), kAccepted);
  }
  return Model::MeanStress::kGerber;
}

}  // namespace

std::span<const std::string_view> model_table_names() {
  return kTables;
}

ModelTables::ModelTables(TomlTable above) : above_(std::move(above)) {
  for (const std::string_view table : kTables) {
    if (has(table)) {
      above_.table(table).refuse_unknown_keys(number_keys(table), other_keys(table));
    }
  }
}

TomlTable ModelTables::existing(std::string_view table) const {
  if (!has(table)) {
    const std::string name =
        above_.name().empty() ? std::string(table) : fmt::format("{}.{}", above_.name(), table);
    above_.fail(above_.place(), fmt::format("no table [{}]", name),
                fmt::format("[{}] with {}", name, number_keys(table).front().name));
  }
  return above_.table(table);
}

void ModelTables::read(std::string_view table, Model& model) const {
  const TomlTable values = existing(table);
  if (table == "drive") {
    model.drive.emplace();
  }
  for (const ModelKey& key : model_keys()) {
    if (key.table == table) {
      key.value(model) = values.number(number_key(key));
    }
  }
  if (table == "life") {
    model.life.mean_stress = mean_stress(values);
  }
}

void ModelTables::check_hysteresis(const Model& model) const {
  if (model.counting.hysteresis_N >= model.cable.ultimate_tension_N) {
    above_.fail(
        existing("counting").place_of("hysteresis_N"),
        fmt::format("hysteresis_N is {}", model.counting.hysteresis_N),
        fmt::format("less than ultimate_tension_N, which is {}", model.cable.ultimate_tension_N));
  }
}

}  // namespace host_sim
