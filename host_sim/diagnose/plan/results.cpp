#include "host_sim/diagnose/plan/results.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace host_sim::diagnose {
namespace {

using nlohmann::ordered_json;

std::string experiments_of(const Audit& audit) {
  std::string text;
  for (const EquivalenceClass& same : audit.classes) {
    if (same.members.size() > 1) {
      for (const std::string& experiment : same.experiments) {
        text += text.empty() ? "" : "; ";
        text += experiment;
      }
    }
  }
  return text;
}

ordered_json sets_of(const Audit& audit) {
  ordered_json sets = ordered_json::array();
  for (const EquivalenceClass& same : audit.classes) {
    if (same.members.size() > 1) {
      ordered_json ids = ordered_json::array();
      for (const std::size_t member : same.members) {
        ids.push_back(audit.effects[member].effect->id());
      }
      sets.push_back(std::move(ids));
    }
  }
  return sets;
}

std::vector<const EffectAudit*> clearest_first(const Audit& audit) {
  std::vector<const EffectAudit*> effects;
  effects.reserve(audit.effects.size());
  for (const EffectAudit& effect : audit.effects) {
    effects.push_back(&effect);
  }
  std::stable_sort(effects.begin(), effects.end(), [](const auto* one, const auto* other) {
    return std::pair(one->visible(), one->sigmas) > std::pair(other->visible(), other->sigmas);
  });
  return effects;
}

}  // namespace

std::string foresight_json(const Foresight& foresight) {
  ordered_json effects = ordered_json::array();
  ordered_json invisible = ordered_json::array();
  for (const EffectAudit& effect : foresight.audit.effects) {
    effects.push_back({{"id", effect.effect->id()},
                       {"visible", effect.visible()},
                       {"share_left", effect.share},
                       {"standard_deviations", effect.sigmas},
                       {"words", effect.words}});
    if (!effect.visible()) {
      invisible.push_back(effect.effect->id());
    }
  }
  const ordered_json json{
      {"sessions", foresight.sessions},    {"samples", foresight.samples},
      {"effects", std::move(effects)},     {"equivalent_sets", sets_of(foresight.audit)},
      {"invisible", std::move(invisible)}, {"next_experiment", experiments_of(foresight.audit)}};
  return json.dump(2) + "\n";
}

void write_foresight(std::ostream& out, const Foresight& foresight) {
  fmt::print(out, "{} sessions, {} samples: what this campaign could show\n", foresight.sessions,
             foresight.samples);
  for (const EffectAudit* effect : clearest_first(foresight.audit)) {
    fmt::print(out, "  {:<22}{}{}\n", effect->effect->id(),
               effect->visible() ? "" : "invisible: ", effect->words);
  }
  bool all_apart = true;
  for (const EquivalenceClass& same : foresight.audit.classes) {
    if (same.members.size() > 1) {
      all_apart = false;
      fmt::print(out, "looks the same:");
      for (const std::size_t member : same.members) {
        fmt::print(out, " {}", foresight.audit.effects[member].effect->id());
      }
      fmt::print(out, "\n");
      for (const std::string& experiment : same.experiments) {
        fmt::print(out, "  to tell them apart: {}\n", experiment);
      }
    }
  }
  if (all_apart) {
    fmt::print(out, "each of the visible ones can be told from the others\n");
  }
}

}  // namespace host_sim::diagnose
