#include "host_sim/synth/plan/plan.hpp"

#include <array>

#include "host_sim/io/model_tables.hpp"
#include "host_sim/io/text_file.hpp"
#include "host_sim/synth/plan/tables.hpp"

namespace host_sim::synth {
namespace {

constexpr std::string_view kSchema = "schema";
constexpr std::array<std::string_view, 10> kTop{kSchema,      "campaign", "model",   "thermal",
                                                "recordings", "noise",    "scatter", "lives",
                                                "effects",    "outside"};
constexpr std::array<std::string_view, 1> kCampaign{"name"};

void check_schema(const TomlTable& top) {
  constexpr std::string_view kAccepted = "schema = 1";
  if (!top.has(kSchema)) {
    return;
  }
  const toml::node& schema = top.node(kSchema, kAccepted);
  const auto* const value = schema.as_integer();
  if (value == nullptr || value->get() != 1) {
    top.fail(top.place_of(kSchema), "schema is " + describe(schema), kAccepted);
  }
}

void read_model(const TomlTable& table, SynthPlan& plan) {
  table.refuse_unknown_keys({}, model_table_names());
  const ModelTables tables(table);
  Model model{};
  for (const std::string_view name : model_table_names()) {
    if (tables.has(name)) {
      tables.read(name, model);
    }
  }
  const auto take = [&](std::string_view name, auto& part, const auto& value) {
    if (tables.has(name)) {
      part.emplace(value);
    }
  };
  take("cable", plan.cable, model.cable);
  take("sheath", plan.sheath, model.sheath);
  take("counting", plan.counting, model.counting);
  take("life", plan.life, model.life);
  if (model.drive) {
    plan.drive.emplace(*model.drive);
  }
  if (plan.cable && plan.counting) {
    tables.check_hysteresis(model);
  }
}

void append(std::vector<Hidden>& to, std::vector<Hidden> from) {
  for (Hidden& hidden : from) {
    to.push_back(std::move(hidden));
  }
}

}  // namespace

SynthPlan parse_synth_plan(std::string_view text, std::string_view name) {
  const toml::table values = parse_toml(text, name);
  const TomlTable top(name, values, "", {});
  check_schema(top);
  top.refuse_unknown_keys({}, kTop);
  SynthPlan plan;
  plan.file = name;
  const TomlTable campaign = top.table("campaign");
  campaign.refuse_unknown_keys({}, kCampaign);
  plan.name = campaign.text("name");
  read_model(top.table("model"), plan);
  const auto read = [&](std::string_view key, const auto& into) {
    if (top.has(key)) {
      into(top.table(key));
    }
  };
  read("thermal", [&](const TomlTable& table) { plan.thermal = thermal_in(table); });
  read("recordings",
       [&](const TomlTable& table) { plan.recordings.emplace(recordings_in(table)); });
  read("noise", [&](const TomlTable& table) { plan.noise = noise_in(table); });
  read("scatter", [&](const TomlTable& table) { plan.scatter = scatter_in(table); });
  read("lives", [&](const TomlTable& table) { plan.lives.emplace(lives_in(table)); });
  read("effects", [&](const TomlTable& table) { append(plan.hidden, hidden_in(table, false)); });
  read("outside", [&](const TomlTable& table) { append(plan.hidden, hidden_in(table, true)); });
  check_agreement(top, plan);
  return plan;
}

SynthPlan read_synth_plan(const std::filesystem::path& path) {
  return parse_synth_plan(read_text_file(path, "a plan (TOML) of at most 1 MiB"), file_name(path));
}

}  // namespace host_sim::synth
