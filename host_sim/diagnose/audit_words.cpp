#include "host_sim/diagnose/audit_words.hpp"

#include <fmt/format.h>

namespace host_sim::diagnose {
namespace {

std::string advice(const effects::TensionEffect& effect) {
  const auto separations = effect.separations();
  return separations.empty() ? std::string() : fmt::format("; {}", separations.front().experiment);
}

/// Three digits or all before the point, never an exponent.
std::string sigmas_text(double sigmas) {
  constexpr double kWhole = 100;
  return sigmas < kWhole ? fmt::format("{:.3g}", sigmas) : fmt::format("{:.0f}", sigmas);
}

std::string names_of(const EquivalenceClass& members, const std::vector<EffectAudit>& effects) {
  std::string names;
  for (const std::size_t member : members.members) {
    names += names.empty() ? "" : ", ";
    names += effects[member].effect->id();
  }
  return names;
}

std::string sentence_for(const EquivalenceClass& members, const std::vector<EffectAudit>& effects) {
  std::string text = names_of(members, effects);
  text += " look the same in this campaign; to tell them apart:";
  for (const std::string& experiment : members.experiments) {
    text += &experiment == &members.experiments.front() ? " " : "; ";
    text += experiment;
  }
  text += ".\n";
  return text;
}

}  // namespace

std::string words_for(const EffectAudit& effect) {
  switch (effect.verdict) {
    case EffectAudit::Verdict::missing_channel:
      return effect.words;
    case EffectAudit::Verdict::nothing_left:
      return fmt::format(
          "{:.1f} % of its signature is left once gain and friction coefficient are refitted{}",
          100 * effect.share, advice(*effect.effect));
    case EffectAudit::Verdict::too_weak:
      return fmt::format(
          "even the largest that physics allows makes {:.1f} standard deviations: what it depends "
          "on hardly changes, or the noise is too large",
          effect.sigmas_at_bound);
    case EffectAudit::Verdict::visible:
      return fmt::format("a usual one makes {} standard deviations", sigmas_text(effect.sigmas));
  }
  return {};
}

std::string words_for(const Audit& audit) {
  std::string text;
  for (const EffectAudit& effect : audit.effects) {
    if (!effect.visible()) {
      text += fmt::format("{} cannot be shown: {}.\n", effect.effect->id(), effect.words);
    }
  }
  for (const EquivalenceClass& members : audit.classes) {
    if (members.members.size() > 1) {
      text += sentence_for(members, audit.effects);
    }
  }
  return text;
}

}  // namespace host_sim::diagnose
