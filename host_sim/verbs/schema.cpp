#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/verbs/assets.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

struct SchemaOfVerb {
  std::string_view verb;
  std::string_view text;
};

const std::array<SchemaOfVerb, 9>& schemas() {
  static const std::array<SchemaOfVerb, 9> all{{{"calibrate", verb_assets::calibrate_schema},
                                                {"compare", verb_assets::compare_schema},
                                                {"design", verb_assets::design_schema},
                                                {"diagnose", verb_assets::diagnose_schema},
                                                {"fleet", verb_assets::fleet_schema},
                                                {"fmeca", verb_assets::fmeca_schema},
                                                {"monitor", verb_assets::monitor_schema},
                                                {"plan", verb_assets::plan_schema},
                                                {"replay", verb_assets::replay_schema}}};
  return all;
}

}  // namespace

void add_schema(CLI::App& app, int&) {
  auto verb_name = std::make_shared<std::string>();
  CLI::App* verb =
      app.add_subcommand("schema", "What a verb writes as JSON, as JSON Schema 2020-12");
  std::vector<std::string> names;
  for (const SchemaOfVerb& schema : schemas()) {
    names.emplace_back(schema.verb);
  }
  verb->add_option("VERB", *verb_name, "The verb; of monitor what its page and MQTT give")
      ->required()
      ->check(CLI::IsMember(names));
  verb->footer("Example: host_sim schema replay > replay.schema.json");
  verb->callback([verb_name] {
    std::cout << std::ranges::find(schemas(), *verb_name, &SchemaOfVerb::verb)->text;
  });
}

}  // namespace host_sim
