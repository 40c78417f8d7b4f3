#include "host_sim/diagnose/audit.hpp"

#include <algorithm>
#include <stdexcept>

#include "host_sim/diagnose/audit_words.hpp"
#include "host_sim/diagnose/block_view.hpp"
#include "host_sim/diagnose/equivalence.hpp"

namespace host_sim::diagnose {
namespace {

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
  EffectAudit result{.effect = effect.effect, .words = effect.missing};
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
    result.effects.back().words = words_for(result.effects.back());
    views.push_back(effect_view(effect, std::move(blocks)));
  }
  result.pairs = pairs_of(result.effects, views, projection);
  result.classes = classes_of(result.effects, result.pairs);
  result.words = words_for(result);
  return result;
}

}  // namespace host_sim::diagnose
