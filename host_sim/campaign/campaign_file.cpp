#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "hal/files/text.hpp"
#include "hal/files/toml_table.hpp"
#include "host_sim/campaign/campaign_files.hpp"
#include "host_sim/campaign/load.hpp"
#include "host_sim/model/model_tables.hpp"

namespace host_sim {

using hal::files::describe;
using hal::files::in_quotes;
using hal::files::NumberKey;
using hal::files::parse_toml;
using hal::files::TomlTable;

namespace {

constexpr NumberKey kShare{"share", "", {0.0, 1.0, true}};
constexpr double kShareTolerance = 1e-9;

FilePosition to_place(const TomlTable& table, toml::source_position at) {
  return {table.file(), at.line, at.column};
}

GivenLoad given_load(const TomlTable& table) {
  GivenLoad load;
  load.accepted = load_keys_prose_of_use();
  for (std::size_t id = 0; id < kLoadKeyCount; ++id) {
    const NumberKey& key = load_keys()[id];
    GivenLoad::Number& number = load.numbers[id];
    number.place = to_place(table, table.place_of(key.name));
    number.given = table.has(key.name);
    if (number.given) {
      number.value = table.number(key);
    }
  }
  return load;
}

Campaign::Use::Part part_in(const TomlTable& table, const LoadModel& model) {
  std::vector<NumberKey> known(load_keys().begin(), load_keys().end());
  known.push_back(kShare);
  table.refuse_unknown_keys(known, {});
  Campaign::Use::Part part;
  part.share = table.number(kShare);
  const GivenLoad load = given_load(table);
  if (load.kind() == LoadKind::none) {
    table.fail(table.place(), "a part without a load", load.accepted);
  }
  part.load = model.load(load);
  return part;
}

std::vector<Campaign::Use::Part> mix_in(const TomlTable& use, const LoadModel& model) {
  constexpr std::string_view kAccepted =
      "parts = [{ share, load }, ...], at least two whose shares of the cycles sum to 1";
  std::vector<Campaign::Use::Part> parts;
  double sum = 0;
  for (const TomlTable& table : use.tables("parts", kAccepted)) {
    parts.push_back(part_in(table, model));
    sum += parts.back().share;
  }
  if (parts.size() < 2) {
    use.fail(use.place_of("parts"), fmt::format("{} parts", parts.size()), kAccepted);
  }
  if (!(std::abs(sum - 1.0) <= kShareTolerance)) {
    use.fail(use.place_of("parts"), fmt::format("the shares sum to {}", sum), kAccepted);
  }
  return parts;
}

Campaign::Use use_in(const TomlTable& table, const LoadModel& model) {
  constexpr std::array<std::string_view, 2> kOthers{"name", "parts"};
  table.refuse_unknown_keys(load_keys(), kOthers);
  Campaign::Use use;
  use.name = table.text("name");
  const GivenLoad load = given_load(table);
  const bool one_load = load.kind() != LoadKind::none;
  if (one_load == table.has("parts")) {
    table.fail(table.place(), one_load ? "a load beside parts" : "a use without a load",
               fmt::format("{}, or parts of a mix", load.accepted));
  }
  if (one_load) {
    use.parts.push_back({.load = model.load(load)});
  } else {
    use.parts = mix_in(table, model);
  }
  return use;
}

/// The tables [[use]] at the top of campaign.toml.
/// @throws InputError
std::vector<Campaign::Use> uses_in(const TomlTable& top, const LoadModel& model) {
  std::vector<Campaign::Use> uses;
  if (!top.has("use")) {
    return uses;
  }
  for (const TomlTable& table : top.tables("use", "tables [[use]]")) {
    Campaign::Use use = use_in(table, model);
    for (const Campaign::Use& earlier : uses) {
      if (earlier.name == use.name) {
        table.fail(table.place_of("name"), fmt::format("use {} a second time", in_quotes(use.name)),
                   "a name for each use");
      }
    }
    uses.push_back(std::move(use));
  }
  return uses;
}

}  // namespace

CampaignFile parse_campaign_file(std::string_view text, std::string_view file) {
  constexpr std::array<std::string_view, 4> kTop{"campaign", "model", "use", "schema"};
  constexpr std::array<std::string_view, 2> kCampaign{"name", "two_sided"};
  const toml::table values = parse_toml(text, file);
  const TomlTable top(file, values, "", {});
  check_schema(top);
  top.refuse_unknown_keys({}, kTop);
  const TomlTable campaign = top.table("campaign");
  campaign.refuse_unknown_keys({}, kCampaign);
  CampaignFile result;
  result.name = campaign.text("name");
  result.two_sided = campaign.flag("two_sided");
  const toml::source_position place = top.place_of("model");
  result.model = {std::string(file), place.line, place.column};
  if (top.has("model")) {
    result.nominal = known_tables_of(top.table("model"));
  }
  result.uses = uses_in(top, LoadModel(result.nominal, result.model));
  return result;
}

}  // namespace host_sim
