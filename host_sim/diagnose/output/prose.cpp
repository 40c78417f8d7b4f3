#include "host_sim/diagnose/output/prose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "host_sim/effects/life_effect.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"

namespace host_sim::diagnose {
namespace {

using Good = MetricDescription::Good;

const std::pair<std::string_view, MetricDescription> kMetrics[] = {
    {"rmse_N", {"error of the output tension (RMSE)", "N", Good::low}},
    {"input_rmse_N", {"error of the input tension (RMSE)", "N", Good::low}},
    {"log_predictive_density", {"log predictive density", "", Good::high}},
    {"damage_error_percent", {"error of the damage", "%", Good::low}},
    {"b10_coverage", {"specimens broken before their B10", "", Good::goal, 0.1}},
};

/// Below it a ratio is reported as none.
constexpr double kSmallestChange = 0.005;

/// "1.16 times", "0.84 times".
std::string times(double ratio) {
  return fmt::format("{:.3g} times", ratio);
}

bool of_no_account(double ratio) {
  return !std::isfinite(ratio) || ratio <= 0 || std::abs(std::log(ratio)) < kSmallestChange;
}

/// What either catalogue says of an effect; nothing where none has this id.
struct InCatalogue {
  std::string_view term;
  std::span<const effects::Separation> separations;
};

InCatalogue in_catalogue(std::string_view id) {
  if (const effects::TensionEffect* const effect = effects::tension_effect(id)) {
    return {effect->term, effect->separations};
  }
  for (const auto& effect : effects::life_effects()) {
    if (effect->id() == id) {
      return {effect->term(), effect->separations()};
    }
  }
  return {};
}

std::string experiment_between(std::string_view one, std::string_view other) {
  return std::string(effects::experiment_against(other, in_catalogue(one).separations));
}

/// Adds what is neither empty nor there already.
void add_new(std::vector<std::string>& texts, const std::string& text) {
  if (!text.empty() && std::find(texts.begin(), texts.end(), text) == texts.end()) {
    texts.push_back(text);
  }
}

}  // namespace

MetricDescription description_of(std::string_view metric) {
  const auto* const known = std::find_if(std::begin(kMetrics), std::end(kMetrics),
                                         [metric](const auto& one) { return one.first == metric; });
  return known == std::end(kMetrics) ? MetricDescription{std::string(metric), "", Good::low}
                                     : known->second;
}

bool improved(const Metric& metric) {
  const MetricDescription description = description_of(metric.name);
  switch (description.good) {
    case Good::low:
      return std::abs(metric.after) < std::abs(metric.before);
    case Good::high:
      return metric.after > metric.before;
    case Good::goal:
      return std::abs(metric.after - description.goal) < std::abs(metric.before - description.goal);
  }
  return false;
}

std::string cost_prose(const TensionDiagnosis& tension) {
  if (tension.findings.extensions.empty()) {
    return "Nothing was extended, so that the damage of the recordings stays as it was computed.";
  }
  const double ratio = tension.damage_ratio;
  if (of_no_account(ratio)) {
    return "The extension does not change the damage of the recordings.";
  }
  return fmt::format(
      "In the geometric mean over recordings the nominal model computes {} the damage of the "
      "extended one, and so predicts {} the life.",
      times(ratio), times(1 / ratio));
}

std::string cost_prose(const LifeDiagnosis& lives) {
  if (lives.findings.extensions.empty()) {
    return "Nothing was extended, so that B10 stays as it was.";
  }
  if (of_no_account(lives.b10_ratio)) {
    return "The extension does not change B10 at the lowest level.";
  }
  return fmt::format(
      "At the lowest level the nominal model predicts {} the B10 of the extended one.",
      times(lives.b10_ratio));
}

std::string candidate_prose(std::string_view id) {
  std::string prose(id);
  for (std::size_t plus = prose.find('+'); plus != std::string::npos; plus = prose.find('+')) {
    prose.replace(plus, 1, " and ");
  }
  return prose;
}

std::string term_of(std::string_view id) {
  if (id == "none") {
    return "no effect";
  }
  if (id == "unknown") {
    return "an effect outside the catalogue";
  }
  if (const std::size_t plus = id.find('+'); plus != std::string_view::npos) {
    return term_of(id.substr(0, plus)) + " and " + term_of(id.substr(plus + 1));
  }
  const std::string_view term = in_catalogue(id).term;
  return std::string(term.empty() ? id : term);
}

std::string term_of(std::string_view id, const Findings& findings) {
  if (const std::size_t plus = id.find('+'); plus != std::string_view::npos) {
    return term_of(id.substr(0, plus), findings) + " and " + term_of(id.substr(plus + 1), findings);
  }
  const auto found = std::ranges::find(findings.effects, id, &FoundEffect::id);
  return found == findings.effects.end() || found->term.empty() ? term_of(id) : found->term;
}

std::string covariate_prose(std::string_view covariate) {
  std::string prose(covariate);
  std::ranges::replace(prose, '_', ' ');
  return prose;
}

std::string remainder_prose(const Remainder& remainder) {
  constexpr double kPercent = 100;
  constexpr double kFewPercent = 10;
  constexpr double kLeastP = 0.001;
  std::vector<std::string> parts;
  if (std::isfinite(remainder.share)) {
    const double percent = kPercent * remainder.share;
    parts.push_back(percent < kFewPercent ? fmt::format("{:.2g} % of the squared error", percent)
                                          : fmt::format("{:.0f} % of the squared error", percent));
  }
  if (std::isfinite(remainder.input_rmse_N)) {
    parts.push_back(fmt::format("{:.2g} N of input tension", remainder.input_rmse_N));
  }
  if (!remainder.covariate.empty()) {
    const std::string p = remainder.p < kLeastP ? fmt::format("below {}", kLeastP)
                                                : fmt::format("{:.2g}", remainder.p);
    parts.push_back(fmt::format("most against {}{}", covariate_prose(remainder.covariate),
                                std::isfinite(remainder.p) ? fmt::format(" (p {})", p) : ""));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string correction_summary(const Correction& correction) {
  return fmt::format("{} knots over {} by direction, input {:.3g} N -> {:.3g} N; no cause",
                     correction.knots, correction.covariate, correction.before_N,
                     correction.after_N);
}

std::string experiments_for(const std::vector<std::string>& ids) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (std::size_t j = i + 1; j < ids.size(); ++j) {
      const std::string text = experiment_between(ids[i], ids[j]);
      add_new(texts, text.empty() ? experiment_between(ids[j], ids[i]) : text);
    }
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace host_sim::diagnose
