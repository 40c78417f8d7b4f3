#include "host_sim/model/model_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/toml_table.hpp"
#include "host_sim/model/life_interval.hpp"
#include "host_sim/model/watch.hpp"

namespace host_sim {

using hal::files::describe;
using hal::files::file_name;
using hal::files::NumberKey;
using hal::files::parse_toml;
using hal::files::read_text_file;
using hal::files::TomlTable;

namespace {

constexpr std::array<ModelKey, 14> kKeys{{
    {"cable",
     "diameter_mm",
     "mm",
     {0.01, 200.0},
     [](Model& m) -> double& { return m.cable.diameter_mm; }},
    {"cable",
     "ultimate_tension_N",
     "N",
     {1.0, 1e6},
     [](Model& m) -> double& { return m.cable.ultimate_tension_N; }},
    {"sheath",
     "friction_coefficient",
     "",
     {0.0, 1.0},
     [](Model& m) -> double& { return m.sheath.friction_coefficient; }},
    {"sheath",
     "bend_angle_deg",
     "deg",
     {0.0, 1800.0},
     [](Model& m) -> double& { return m.sheath.bend_angle_deg; }},
    {"drive",
     "torque_constant_Nm_per_A",
     "Nm_per_A",
     {1e-6, 100.0},
     [](Model& m) -> double& { return m.drive->torque_constant_Nm_per_A; }},
    {"drive",
     "gear_ratio",
     "",
     {0.001, 10000.0},
     [](Model& m) -> double& { return m.drive->gear_ratio; }},
    {"drive",
     "gear_efficiency",
     "",
     {0.01, 1.0},
     [](Model& m) -> double& { return m.drive->gear_efficiency; }},
    {"drive",
     "spool_radius_mm",
     "mm",
     {0.1, 1000.0},
     [](Model& m) -> double& { return m.drive->spool_radius_mm; }},
    {"drive",
     "current_offset_A",
     "A",
     {-100.0, 100.0},
     [](Model& m) -> double& { return m.drive->current_offset_A; }},
    {"counting",
     "sample_rate_Hz",
     "Hz",
     {0.1, 100000.0},
     [](Model& m) -> double& { return m.counting.sample_rate_Hz; }},
    {"counting",
     "hysteresis_N",
     "N",
     {0.0, 1e5},
     [](Model& m) -> double& { return m.counting.hysteresis_N; }},
    {"life",
     "ipl_scale",
     "",
     {0.0, 1e300, true},
     [](Model& m) -> double& { return m.life.ipl_scale; }},
    {"life",
     "ipl_exponent",
     "",
     {1.0, 12.0},
     [](Model& m) -> double& { return m.life.ipl_exponent; }},
    {"life",
     "weibull_shape",
     "",
     {0.5, 50.0},
     [](Model& m) -> double& { return m.life.weibull_shape; }},
}};

constexpr std::string_view kWatch = "watch";
constexpr std::array<std::string_view, 6> kTables{"cable",    "sheath", "drive",
                                                  "counting", "life",   kWatch};
constexpr std::string_view kMeanStress = "mean_stress";
constexpr std::string_view kInterval = "interval";
constexpr std::array kOthersOfLife{kMeanStress, kInterval};
constexpr std::array kMeanStressLaws{
    std::pair{Model::MeanStress::kGerber, std::string_view("gerber")}};

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
  return table == "life" ? std::span<const std::string_view>(kOthersOfLife)
                         : std::span<const std::string_view>();
}

Model::MeanStress mean_stress(const TomlTable& life) {
  constexpr std::string_view kAccepted = "mean_stress \"gerber\"";
  const toml::node& node = life.node(kMeanStress, kAccepted);
  if (const auto* const value = node.as_string()) {
    for (const auto& [law, name] : kMeanStressLaws) {
      if (value->get() == name) {
        return law;
      }
    }
  }
  life.fail(life.place_of(kMeanStress), fmt::format("{} is {}", kMeanStress, describe(node)),
            kAccepted);
}

constexpr std::string_view kSchema = "schema";

void refuse_unknown_tables(const TomlTable& top, std::span<const std::string_view> others) {
  std::vector<std::string_view> known{kSchema};
  known.insert(known.end(), model_table_names().begin(), model_table_names().end());
  known.insert(known.end(), others.begin(), others.end());
  top.refuse_unknown_keys({}, known);
}

void require_schema(const TomlTable& top) {
  constexpr std::string_view kAccepted = "schema = 1";
  const toml::node& schema = top.node(kSchema, kAccepted);
  const auto* const value = schema.as_integer();
  if (value == nullptr || value->get() != 1) {
    top.fail(top.place_of(kSchema), "schema is " + describe(schema), kAccepted);
  }
}

}  // namespace

std::span<const ModelKey> model_keys() {
  return kKeys;
}

void check_schema(const TomlTable& top) {
  if (top.has(kSchema)) {
    require_schema(top);
  }
}

NominalModel known_tables_of(const TomlTable& model) {
  model.refuse_unknown_keys({}, model_table_names());
  const ModelTables tables(model);
  Model values{};
  for (const std::string_view table : model_table_names()) {
    if (tables.has(table)) {
      tables.read(table, values);
    }
  }
  const auto known = [&](std::string_view table, const auto& read) {
    return tables.has(table) ? std::optional(read) : std::nullopt;
  };
  NominalModel nominal{
      known("cable", values.cable),       known("sheath", values.sheath), values.drive,
      known("counting", values.counting), known("life", values.life),     values.watch};
  if (nominal.cable && nominal.counting) {
    tables.check_hysteresis(values);
  }
  if (nominal.cable) {
    tables.check_watched_tensions(values);
  }
  return nominal;
}

std::string_view name_of(Model::MeanStress law) {
  return std::ranges::find(kMeanStressLaws, law, [](const auto& entry) { return entry.first; })
      ->second;
}

std::span<const std::string_view> model_table_names() {
  return kTables;
}

ModelTables::ModelTables(TomlTable above) : above_(std::move(above)) {
  for (const std::string_view table : kTables) {
    if (has(table) && table != kWatch) {
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
  if (table == kWatch) {
    model.watch = read_watch(values);
    return;
  }
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
    if (values.has(kInterval)) {
      model.life.interval = read_life_interval(values.table(kInterval), model.life);
    }
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

void ModelTables::check_watched_tensions(const Model& model) const {
  if (model.watch) {
    check_watch(above_.table(kWatch), *model.watch, model.cable);
  }
}

Model nominal_model_of(const TomlTable& top, std::span<const std::string_view> others) {
  require_schema(top);
  refuse_unknown_tables(top, others);
  const ModelTables tables(top);
  Model model{};
  for (const std::string_view table : model_table_names()) {
    if ((table != "drive" && table != kWatch) || tables.has(table)) {
      tables.read(table, model);
    }
  }
  tables.check_hysteresis(model);
  tables.check_watched_tensions(model);
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
