#include "host_sim/campaign/campaign_file.hpp"

#include <fmt/format.h>

#include <array>

#include "host_sim/campaign/load_model.hpp"
#include "host_sim/campaign/uses_table.hpp"
#include "host_sim/io/model_tables.hpp"
#include "host_sim/io/toml_table.hpp"

namespace host_sim {
namespace {

constexpr std::string_view kSchema = "schema";

void check_schema(const TomlTable& top) {
  if (!top.has(kSchema)) {
    return;
  }
  constexpr std::string_view kAccepted = "schema = 1";
  const toml::node& schema = top.node(kSchema, kAccepted);
  const auto* const value = schema.as_integer();
  if (value == nullptr || value->get() != 1) {
    top.fail(top.place_of(kSchema), "schema is " + describe(schema), kAccepted);
  }
}

Campaign::Nominal nominal_in(const TomlTable& model) {
  model.refuse_unknown_keys({}, model_table_names());
  const ModelTables tables(model);
  Model values{};
  for (const std::string_view table : model_table_names()) {
    if (tables.has(table)) {
      tables.read(table, values);
    }
  }
  Campaign::Nominal nominal;
  if (tables.has("cable")) {
    nominal.cable = values.cable;
  }
  if (tables.has("sheath")) {
    nominal.sheath = values.sheath;
  }
  if (tables.has("drive")) {
    nominal.drive = values.drive;
  }
  if (tables.has("counting")) {
    nominal.counting = values.counting;
  }
  if (tables.has("life")) {
    nominal.life = values.life;
  }
  if (nominal.cable && nominal.counting) {
    tables.check_hysteresis(values);
  }
  return nominal;
}

}  // namespace

CampaignFile parse_campaign_file(std::string_view text, std::string_view file) {
  constexpr std::array<std::string_view, 4> kTop{"campaign", "model", "use", kSchema};
  constexpr std::array<std::string_view, 1> kCampaign{"name"};
  const toml::table values = parse_toml(text, file);
  const TomlTable top(file, values, "", {});
  check_schema(top);
  top.refuse_unknown_keys({}, kTop);
  const TomlTable campaign = top.table("campaign");
  campaign.refuse_unknown_keys({}, kCampaign);
  CampaignFile result;
  result.name = campaign.text("name");
  const toml::source_position place = top.place_of("model");
  result.model = {std::string(file), place.line, place.column};
  if (top.has("model")) {
    result.nominal = nominal_in(top.table("model"));
  }
  result.uses = uses_in(top, LoadModel(result.nominal, result.model));
  return result;
}

}  // namespace host_sim
