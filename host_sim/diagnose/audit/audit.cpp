#include "host_sim/diagnose/audit/audit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/diagnose/audit/projection.hpp"
#include "host_sim/statistics/eigen_system.hpp"

namespace host_sim::diagnose {
namespace {

/// One shape of an effect as the campaign shows it, its columns at their typical size.
struct BlockView {
  Eigen::Index first = 0, count = 0;
  Eigen::VectorXd typical;  ///< size of each column
  double share = 0;         ///< see EffectAudit
  double sigmas = 0;
  double sigmas_at_bound = 0;
  /// Takes the columns to an orthonormal base of what is left of them, count x rank.
  Eigen::MatrixXd base;
};

struct Likeness {
  double cosine = 0;
  double canonical = 0;
};

using effects::Parameter;
using Eigen::Index;

/// Of the energy before the projection: what is smaller is no direction of its own.
constexpr double kNoDirection = 1e-9;

/// The linear parameter that a column stands for.
const Parameter& parameter_of(const effects::TensionEffect& effect, Index column) {
  return effect.parameters()[effect.per_pose() ? 0 : static_cast<std::size_t>(column)];
}

double bound_of(const Parameter& parameter) {
  return std::max(std::abs(parameter.minimum), std::abs(parameter.maximum));
}

/// Energy of the columns at these sizes, each by itself.
double energy(const Eigen::MatrixXd& matrix, const BlockView& view, const Eigen::VectorXd& sizes) {
  const Eigen::VectorXd diagonal = matrix.diagonal().segment(view.first, view.count);
  return std::max(0.0, diagonal.dot(sizes.cwiseAbs2()));
}

Eigen::MatrixXd base_of(const Eigen::MatrixXd& left, double least) {
  const auto [values, vectors] = statistics::eigen_system(left);
  const Index size = left.rows();
  Index kept = 0;
  while (kept < size && values(size - 1 - kept) > least) {
    ++kept;
  }
  return vectors.rightCols(kept) * values.tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
}

/// The block of `left` between two views, at the typical sizes.
Eigen::MatrixXd between(const BlockView& one, const BlockView& other, const Eigen::MatrixXd& left) {
  return one.typical.asDiagonal() * left.block(one.first, other.first, one.count, other.count) *
         other.typical.asDiagonal();
}

/// Share of the energy of `one` that the columns of `other` explain.
double imitated(const BlockView& one, const BlockView& other, const Eigen::MatrixXd& cross,
                const Eigen::MatrixXd& left) {
  const double whole = energy(left, one, one.typical);
  return whole > 0 ? (cross * other.base).squaredNorm() / whole : 0;
}

double distance(const std::vector<double>& shape, std::span<const Parameter> parameters) {
  double sum = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Parameter& parameter = parameters[parameters.size() - shape.size() + i];
    const double apart = (shape[i] - parameter.typical) / (parameter.maximum - parameter.minimum);
    sum += apart * apart;
  }
  return sum;
}

BlockView view_of(const GramLayout::Effect& effect, const GramLayout::Block& block,
                  const Projection& projection) {
  BlockView view{.first = static_cast<Index>(block.first),
                 .count = static_cast<Index>(block.count),
                 .typical = {},
                 .base = {}};
  view.typical.resize(view.count);
  Eigen::VectorXd bounds(view.count);
  for (Index column = 0; column < view.count; ++column) {
    const Parameter& parameter = parameter_of(*effect.effect, column);
    view.typical(column) = std::abs(parameter.typical);
    bounds(column) = bound_of(parameter);
  }
  const double before = energy(projection.before, view, view.typical);
  const double left = energy(projection.left, view, view.typical);
  view.share = before > 0 ? std::min(1.0, std::sqrt(left / before)) : 0;
  view.sigmas = std::sqrt(left);
  view.sigmas_at_bound = std::sqrt(energy(projection.left, view, bounds));
  const double rounding =
      projection.rounding.segment(view.first, view.count).dot(view.typical.cwiseAbs2());
  view.base =
      base_of(between(view, view, projection.left), std::max(kNoDirection * before, rounding));
  return view;
}

/// The place of the block whose shape is nearest to the typical one, relative to the bounds.
std::size_t typical_block(const GramLayout::Effect& effect) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < effect.blocks.size(); ++i) {
    const double apart = distance(effect.blocks[i].shape, effect.effect->parameters());
    if (apart < least) {
      least = apart;
      nearest = i;
    }
  }
  return nearest;
}

/// See PairAudit.
Likeness likeness_of(const BlockView& one, const BlockView& other, const Projection& projection) {
  if (one.base.cols() == 0 || other.base.cols() == 0) {
    return {};
  }
  const Eigen::MatrixXd cross = between(one, other, projection.left);
  const double least = std::min(imitated(one, other, cross, projection.left),
                                imitated(other, one, cross.transpose(), projection.left));
  const Eigen::MatrixXd correlations = one.base.transpose() * cross * other.base;
  const double square =
      statistics::eigen_system(correlations.transpose() * correlations).values.maxCoeff();
  return {.cosine = std::sqrt(std::clamp(least, 0.0, 1.0)),
          .canonical = std::sqrt(std::clamp(square, 0.0, 1.0))};
}

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
          "{:.1f} % of its signature is left once gain and friction coefficient are refitted{}",
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
      text += fmt::format("{} is not detectable: {}.\n", effect.effect->id(), effect.prose);
    }
  }
  for (const EquivalenceClass& members : audit.classes) {
    if (members.members.size() > 1) {
      text += sentence_for(members, audit.effects);
    }
  }
  return text;
}

const effects::Separation* separation_of(const effects::TensionEffect& one,
                                         const effects::TensionEffect& other) {
  for (const effects::Separation& separation : one.separations()) {
    if (separation.other == other.id()) {
      return &separation;
    }
  }
  return nullptr;
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

/// The shapes of one effect that physics makes visible, and which of them stands for it.
struct EffectView {
  std::vector<BlockView> blocks;
  std::size_t typical = 0;
};

bool shows(const BlockView& block) {
  return block.share >= Audit::kLeastShare && block.sigmas_at_bound >= Audit::kLeastSigmas;
}

EffectAudit::Verdict verdict_of(const BlockView& best) {
  if (best.share < Audit::kLeastShare) {
    return EffectAudit::Verdict::nothing_left;
  }
  return best.sigmas_at_bound < Audit::kLeastSigmas ? EffectAudit::Verdict::too_weak
                                                    : EffectAudit::Verdict::visible;
}

/// One that shows before one that does not, then the clearer at its bounds.
bool shows_less(const BlockView& one, const BlockView& other) {
  return shows(one) != shows(other) ? shows(other) : one.sigmas_at_bound < other.sigmas_at_bound;
}

EffectAudit effect_audit(const GramLayout::Effect& effect, const std::vector<BlockView>& blocks) {
  EffectAudit result{.effect = effect.effect, .prose = effect.missing};
  if (blocks.empty()) {
    result.verdict = EffectAudit::Verdict::missing_channel;
    return result;
  }
  const BlockView& best = *std::ranges::max_element(blocks, shows_less);
  result.share = best.share;
  result.sigmas = blocks[typical_block(effect)].sigmas;
  result.sigmas_at_bound = best.sigmas_at_bound;
  result.verdict = verdict_of(best);
  return result;
}

EffectView effect_view(const GramLayout::Effect& effect, std::vector<BlockView> blocks) {
  EffectView view;
  const std::size_t typical = typical_block(effect);
  double clearest = -1;
  bool typical_shows = false;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (!shows(blocks[i])) {
      continue;
    }
    typical_shows = typical_shows || i == typical;
    if (i == typical || (!typical_shows && blocks[i].sigmas_at_bound > clearest)) {
      clearest = blocks[i].sigmas_at_bound;
      view.typical = view.blocks.size();
    }
    view.blocks.push_back(std::move(blocks[i]));
  }
  return view;
}

void keep_larger(Likeness& kept, const Likeness& other) {
  kept.cosine = std::max(kept.cosine, other.cosine);
  kept.canonical = std::max(kept.canonical, other.canonical);
}

Likeness worst_case(const EffectView& one, const EffectView& other, const Projection& projection) {
  Likeness worst;
  for (const BlockView& block : other.blocks) {
    keep_larger(worst, likeness_of(one.blocks[one.typical], block, projection));
  }
  for (const BlockView& block : one.blocks) {
    keep_larger(worst, likeness_of(block, other.blocks[other.typical], projection));
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
        const Likeness likeness = worst_case(views[i], views[j], projection);
        pairs.push_back({.first = i,
                         .second = j,
                         .cosine = likeness.cosine,
                         .canonical = likeness.canonical,
                         .experiment = experiment_for(*effects[i].effect, *effects[j].effect)});
      }
    }
  }
  return pairs;
}

}  // namespace

std::string experiment_for(const effects::TensionEffect& one, const effects::TensionEffect& other) {
  const effects::Separation* found = separation_of(one, other);
  if (found == nullptr) {
    found = separation_of(other, one);
  }
  return std::string(found != nullptr ? found->experiment
                                      : "cross bend angle, speed, load and temperature");
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
    if (effect.effect->id() == id) {
      return effect;
    }
  }
  throw std::out_of_range("no effect of this id");
}

const PairAudit* Audit::pair(std::string_view one, std::string_view other) const {
  for (const PairAudit& pair : pairs) {
    const std::string_view first = effects[pair.first].effect->id();
    const std::string_view second = effects[pair.second].effect->id();
    if ((first == one && second == other) || (first == other && second == one)) {
      return &pair;
    }
  }
  return nullptr;
}

Audit audit(const Grams& grams, const NoiseModel& noise) {
  const Projection projection = project(grams, noise);
  Audit result;
  std::vector<EffectView> views;
  for (const GramLayout::Effect& effect : grams.layout.effects) {
    std::vector<BlockView> blocks;
    for (const GramLayout::Block& block : effect.blocks) {
      blocks.push_back(view_of(effect, block, projection));
    }
    result.effects.push_back(effect_audit(effect, blocks));
    result.effects.back().prose = prose_of(result.effects.back());
    views.push_back(effect_view(effect, std::move(blocks)));
  }
  result.pairs = pairs_of(result.effects, views, projection);
  result.classes = classes_of(result.effects, result.pairs);
  result.prose = prose_of(result);
  return result;
}

}  // namespace host_sim::diagnose
