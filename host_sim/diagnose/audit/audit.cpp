#include "host_sim/diagnose/audit/audit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/diagnose/audit/projection.hpp"
#include "host_sim/statistics/eigen_system.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

/// Of the energy before the projection: what is smaller is no direction of its own.
constexpr double kNoDirection = 1e-9;

/// One case of an effect as the campaign shows it.
struct CaseView {
  Index first = 0;
  double energy = 0;  ///< that is left
  double share = 0;   ///< see EffectAudit
  double sigmas = 0;
  double sigmas_at_bound = 0;
  /// Takes the columns of the case to an orthonormal base of what is left of them, count x rank.
  Eigen::MatrixXd base;
};

Eigen::MatrixXd base_of(const Eigen::MatrixXd& left, double least) {
  const auto [values, vectors] = statistics::eigen_system(left);
  const Index size = left.rows();
  Index kept = 0;
  while (kept < size && values(size - 1 - kept) > least) {
    ++kept;
  }
  return vectors.rightCols(kept) * values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

CaseView view_of(const GramLayout::Case& one, const Projection& projection) {
  const auto first = static_cast<Index>(one.first);
  const auto count = static_cast<Index>(one.count);
  CaseView view{.first = first, .base = {}};
  const double before = projection.before(first, first);
  view.energy = std::max(0.0, projection.left(first, first));
  view.share = before > 0 ? std::min(1.0, std::sqrt(view.energy / before)) : 0;
  view.sigmas = std::sqrt(view.energy);
  view.sigmas_at_bound = one.most * view.sigmas;
  // Each column by its own size: parameters have units of their own.
  Eigen::VectorXd unit(count);
  double least = kNoDirection;
  for (Index k = 0; k < count; ++k) {
    const double square = projection.before(first + k, first + k);
    unit(k) = square > 0 ? 1 / std::sqrt(square) : 0;
    least = std::max(least, projection.rounding(first + k) * unit(k) * unit(k));
  }
  const Eigen::MatrixXd left = projection.left.block(first, first, count, count);
  view.base = unit.asDiagonal() * base_of(unit.asDiagonal() * left * unit.asDiagonal(), least);
  return view;
}

/// Share of the energy of `one` that the columns of `other` explain.
double imitated(const CaseView& one, const CaseView& other, const Projection& projection) {
  const Eigen::RowVectorXd cross =
      projection.left.block(one.first, other.first, 1, other.base.rows());
  return one.energy > 0 ? (cross * other.base).squaredNorm() / one.energy : 0;
}

/// See PairAudit.
double cosine_of(const CaseView& one, const CaseView& other, const Projection& projection) {
  const double least = std::min(imitated(one, other, projection), imitated(other, one, projection));
  return std::sqrt(std::clamp(least, 0.0, 1.0));
}

std::string advice(const effects::TensionEffect& effect) {
  return effect.separations.empty() ? std::string()
                                    : fmt::format("; {}", effect.separations.front().experiment);
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
    names += effects[member].effect->id;
  }
  return names;
}

std::string sentence_for(const EquivalenceClass& members, const std::vector<EffectAudit>& effects) {
  std::string text = names_of(members, effects);
  text += " cannot be distinguished in this campaign; to distinguish them:";
  for (const std::string& experiment : members.experiments) {
    text += &experiment == &members.experiments.front() ? " " : "; ";
    text += experiment;
  }
  text += ".\n";
  return text;
}

/// Why an effect is invisible and what would show it, or how clearly it shows. Where a channel is
/// missing, `effect.prose` holds what is missing.
std::string prose_of(const EffectAudit& effect) {
  switch (effect.verdict) {
    case EffectAudit::Verdict::missing_channel:
      return effect.prose;
    case EffectAudit::Verdict::nothing_left:
      return fmt::format(
          "{:.1f} % of what it does is left once gain and friction coefficient are refitted{}",
          100 * effect.share, advice(*effect.effect));
    case EffectAudit::Verdict::too_weak:
      return fmt::format(
          "even the largest effect that physics allows would stand out by {:.1f} standard "
          "deviations: what it depends "
          "on hardly changes, or the noise is too large",
          effect.sigmas_at_bound);
    case EffectAudit::Verdict::visible:
      return fmt::format("an effect of typical size would stand out by {} standard deviations",
                         sigmas_text(effect.sigmas));
  }
  return {};
}

/// The whole audit: a sentence for each invisible effect and for each class of more than one.
std::string prose_of(const Audit& audit) {
  std::string text;
  for (const EffectAudit& effect : audit.effects) {
    if (!effect.visible()) {
      text += fmt::format("{} is not detectable: {}.\n", effect.effect->id, effect.prose);
    }
  }
  for (const EquivalenceClass& members : audit.classes) {
    if (members.members.size() > 1) {
      text += sentence_for(members, audit.effects);
    }
  }
  return text;
}

/// The least member of each effect's class.
std::vector<std::size_t> least_members(std::size_t count, const std::vector<PairAudit>& pairs) {
  std::vector<std::size_t> least(count);
  std::iota(least.begin(), least.end(), std::size_t{0});
  for (const PairAudit& pair : pairs) {
    if (pair.cosine > Audit::kSameCosine) {
      const auto [kept, joined] = std::minmax({least[pair.first], least[pair.second]});
      std::ranges::replace(least, joined, kept);
    }
  }
  return least;
}

/// The cases of one effect that physics makes visible, and which of them stands for it.
struct EffectView {
  std::vector<CaseView> cases;
  std::size_t typical = 0;
};

bool shows(const CaseView& one) {
  return one.share >= Audit::kLeastShare && one.sigmas_at_bound >= Audit::kLeastSigmas;
}

EffectAudit::Verdict verdict_of(const CaseView& best) {
  if (best.share < Audit::kLeastShare) {
    return EffectAudit::Verdict::nothing_left;
  }
  return best.sigmas_at_bound < Audit::kLeastSigmas ? EffectAudit::Verdict::too_weak
                                                    : EffectAudit::Verdict::visible;
}

/// One that shows before one that does not, then the clearer at its bounds.
bool shows_less(const CaseView& one, const CaseView& other) {
  return shows(one) != shows(other) ? shows(other) : one.sigmas_at_bound < other.sigmas_at_bound;
}

EffectAudit effect_audit(const GramLayout::Effect& effect, const std::vector<CaseView>& cases) {
  EffectAudit result{.effect = effect.effect, .prose = effect.missing};
  if (cases.empty()) {
    // An effect of what this campaign has one of.
    result.verdict = effect.missing.empty() ? EffectAudit::Verdict::nothing_left
                                            : EffectAudit::Verdict::missing_channel;
    return result;
  }
  const CaseView& best = *std::ranges::max_element(cases, shows_less);
  result.share = best.share;
  result.sigmas = cases[effect.typical].sigmas;
  result.sigmas_at_bound = best.sigmas_at_bound;
  result.verdict = verdict_of(best);
  return result;
}

EffectView effect_view(const GramLayout::Effect& effect, std::vector<CaseView> cases) {
  EffectView view;
  double clearest = -1;
  bool typical_shows = false;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!shows(cases[i])) {
      continue;
    }
    typical_shows = typical_shows || i == effect.typical;
    if (i == effect.typical || (!typical_shows && cases[i].sigmas_at_bound > clearest)) {
      clearest = cases[i].sigmas_at_bound;
      view.typical = view.cases.size();
    }
    view.cases.push_back(std::move(cases[i]));
  }
  return view;
}

double worst_cosine(const EffectView& one, const EffectView& other, const Projection& projection) {
  double worst = 0;
  for (const CaseView& of_other : other.cases) {
    worst = std::max(worst, cosine_of(one.cases[one.typical], of_other, projection));
  }
  for (const CaseView& of_one : one.cases) {
    worst = std::max(worst, cosine_of(of_one, other.cases[other.typical], projection));
  }
  return worst;
}

std::vector<PairAudit> pairs_of(const std::vector<EffectAudit>& effects,
                                const std::vector<EffectView>& views,
                                const Projection& projection) {
  std::vector<PairAudit> pairs;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (std::size_t j = i + 1; j < effects.size(); ++j) {
      if (effects[i].visible() && effects[j].visible()) {
        pairs.push_back({.first = i,
                         .second = j,
                         .cosine = worst_cosine(views[i], views[j], projection),
                         .experiment = experiment_for(*effects[i].effect, *effects[j].effect)});
      }
    }
  }
  return pairs;
}

}  // namespace

std::string experiment_for(const effects::TensionEffect& one, const effects::TensionEffect& other) {
  std::string_view found = experiment_against(other.id, one.separations);
  if (found.empty()) {
    found = experiment_against(one.id, other.separations);
  }
  return std::string(!found.empty() ? found : "cross bend angle, speed, load and temperature");
}

std::vector<EquivalenceClass> classes_of(const std::vector<EffectAudit>& effects,
                                         const std::vector<PairAudit>& pairs) {
  const std::vector<std::size_t> least = least_members(effects.size(), pairs);
  std::vector<EquivalenceClass> classes;
  for (std::size_t first = 0; first < effects.size(); ++first) {
    if (!effects[first].visible() || least[first] != first) {
      continue;
    }
    EquivalenceClass found;
    for (std::size_t i = first; i < effects.size(); ++i) {
      if (effects[i].visible() && least[i] == first) {
        found.members.push_back(i);
      }
    }
    for (const PairAudit& pair : pairs) {
      if (pair.cosine > Audit::kSameCosine && least[pair.first] == first &&
          std::ranges::find(found.experiments, pair.experiment) == found.experiments.end()) {
        found.experiments.push_back(pair.experiment);
      }
    }
    classes.push_back(std::move(found));
  }
  return classes;
}

const EffectAudit& Audit::of(std::string_view id) const {
  for (const EffectAudit& effect : effects) {
    if (effect.effect->id == id) {
      return effect;
    }
  }
  throw std::out_of_range("no effect of this id");
}

const PairAudit* Audit::pair(std::string_view one, std::string_view other) const {
  for (const PairAudit& pair : pairs) {
    const std::string_view first = effects[pair.first].effect->id;
    const std::string_view second = effects[pair.second].effect->id;
    if ((first == one && second == other) || (first == other && second == one)) {
      return &pair;
    }
  }
  return nullptr;
}

Audit audit(std::span<const effects::ForceRecord> records, double friction_coefficient,
            const NoiseModel& noise, unsigned threads) {
  const Grams grams = gram_of(records, friction_coefficient, noise, threads);
  const Projection projection = project(grams, noise);
  Audit result;
  std::vector<EffectView> views;
  for (const GramLayout::Effect& effect : grams.layout.effects) {
    std::vector<CaseView> cases;
    cases.reserve(effect.cases.size());
    for (const GramLayout::Case& one : effect.cases) {
      cases.push_back(view_of(one, projection));
    }
    result.effects.push_back(effect_audit(effect, cases));
    result.effects.back().prose = prose_of(result.effects.back());
    views.push_back(effect_view(effect, std::move(cases)));
  }
  result.pairs = pairs_of(result.effects, views, projection);
  result.classes = classes_of(result.effects, result.pairs);
  result.prose = prose_of(result);
  return result;
}

}  // namespace host_sim::diagnose
