#include "host_sim/diagnose/tension/ranking.hpp"

#include <algorithm>
#include <array>

namespace host_sim::diagnose {
namespace {

/// Effects that are refined and paired with all others.
constexpr std::size_t kLeaders = 4;
/// Pairs that are refined.
constexpr std::size_t kRefinedPairs = 3;

struct Single {
  Hypothesis hypothesis;
  double best_log_evidence = 0;  ///< at the shape that the hypothesis holds
  std::vector<double> at_shapes;
};

struct Pair {
  Hypothesis hypothesis;
  const effects::TensionEffect* second = nullptr;
  Component first;
  double first_occam = 0;         ///< what averaging over the shapes of the first costs
  std::vector<double> at_shapes;  ///< of the second
};

struct Compared {
  const Grams& grams;
  std::vector<ScatterPoint> grid;

  [[nodiscard]] double of(const Terms& terms) const {
    return log_evidence(grid, terms, grams.response(), grams.samples());
  }
};

bool better(const Hypothesis& one, const Hypothesis& other) {
  return one.log_evidence > other.log_evidence;
}

std::vector<Single> singles_of(const Compared& compared) {
  std::vector<Single> singles;
  for (const GramLayout::Effect& effect : compared.grams.layout.effects) {
    if (effect.blocks.empty()) {
      continue;
    }
    Single single;
    for (const GramLayout::Block& block : effect.blocks) {
      single.at_shapes.push_back(compared.of(terms_of(effect, block)));
    }
    const auto best = std::ranges::max_element(single.at_shapes);
    single.best_log_evidence = *best;
    const auto& block = effect.blocks[static_cast<std::size_t>(best - single.at_shapes.begin())];
    single.hypothesis = {{{effect.effect, block.shape}}, mean_over_shapes(single.at_shapes)};
    singles.push_back(std::move(single));
  }
  std::ranges::sort(singles, better, &Single::hypothesis);
  return singles;
}

void refine(const Evidence& evidence, Single& single) {
  const Component& part = single.hypothesis.parts.front();
  const ShapeSearch found = search_shape(evidence, *part.effect, single.at_shapes, {});
  single.best_log_evidence = found.best_log_evidence;
  single.hypothesis = {{found.best}, found.log_evidence};
}

Hypothesis two(Component one, Component other, double log_evidence) {
  if (other.effect->id() < one.effect->id()) {
    std::swap(one, other);
  }
  return {{std::move(one), std::move(other)}, log_evidence};
}

/// The whole catalogue again, with the leaders in their best shapes in front.
Grams with_leaders(const Evidence& evidence, const Grams& all, std::span<const Single> leaders) {
  GramOptions options = evidence.options;
  options.wanted.clear();
  for (const Single& leader : leaders) {
    options.wanted.push_back(wanted_of(leader.hypothesis.parts).front());
  }
  for (const GramLayout::Effect& effect : all.layout.effects) {
    if (effect.blocks.empty()) {
      continue;
    }
    Wanted wanted{.effect = effect.effect, .shapes = {}};
    for (const GramLayout::Block& block : effect.blocks) {
      wanted.shapes.push_back(block.shape);
    }
    options.wanted.push_back(std::move(wanted));
  }
  return gram_of(evidence.sessions, options, &all);
}

bool among(std::span<const Single> leaders, std::string_view id) {
  return std::ranges::any_of(leaders,
                             [&](const Single& leader) { return leader.hypothesis.holds(id); });
}

std::vector<Pair> pairs_of(const Compared& compared, std::span<const Single> leaders) {
  std::vector<Pair> pairs;
  const auto& effects = compared.grams.layout.effects;
  for (std::size_t first = 0; first < leaders.size(); ++first) {
    const Terms beside = terms_of(effects[first], effects[first].blocks.front());
    for (std::size_t second = leaders.size(); second < effects.size(); ++second) {
      const GramLayout::Effect& other = effects[second];
      // Two leaders meet once, the better of them in its best shape.
      if (among(leaders.first(first + 1), other.effect->id())) {
        continue;
      }
      Pair pair;
      pair.second = other.effect;
      pair.first = leaders[first].hypothesis.parts.front();
      for (const GramLayout::Block& block : other.blocks) {
        Terms terms = beside;
        terms.append(terms_of(other, block));
        pair.at_shapes.push_back(compared.of(terms));
      }
      pair.first_occam = leaders[first].hypothesis.log_evidence - leaders[first].best_log_evidence;
      const auto best = std::ranges::max_element(pair.at_shapes);
      const auto& block = other.blocks[static_cast<std::size_t>(best - pair.at_shapes.begin())];
      pair.hypothesis = two(pair.first, {pair.second, block.shape},
                            mean_over_shapes(pair.at_shapes) + pair.first_occam);
      pairs.push_back(std::move(pair));
    }
  }
  std::ranges::sort(pairs, better, &Pair::hypothesis);
  return pairs;
}

/// The second in its best shape, then the first beside that.
void refine(const Evidence& evidence, Pair& pair) {
  const std::array first{pair.first};
  const ShapeSearch found = search_shape(evidence, *pair.second, pair.at_shapes, first);
  const std::array second{found.best};
  const std::vector<double> at_shapes = evidences_at(
      evidence, second, {.effect = pair.first.effect, .shapes = pair.first.effect->shapes()});
  const ShapeSearch again = search_shape(evidence, *pair.first.effect, at_shapes, second);
  const double second_occam = found.log_evidence - found.best_log_evidence;
  if (again.best_log_evidence > found.best_log_evidence) {
    pair.hypothesis = two(again.best, found.best, again.log_evidence + second_occam);
  } else {
    pair.hypothesis = two(pair.first, found.best, found.log_evidence + pair.first_occam);
  }
}

}  // namespace

const Hypothesis& Ranking::best() const {
  const Hypothesis* best = &none;
  for (const auto* list : {&singles, &pairs}) {
    if (!list->empty() && list->front().log_evidence > best->log_evidence) {
      best = &list->front();
    }
  }
  return *best;
}

Hypothesis best_at_first(const Evidence& evidence, const Grams& grams) {
  const Compared compared{grams, scatter_grid(grams, evidence.sample_sd)};
  const Hypothesis none{.parts = {}, .log_evidence = compared.of({})};
  const std::vector<Single> singles = singles_of(compared);
  const bool any = !singles.empty() && better(singles.front().hypothesis, none);
  return any ? singles.front().hypothesis : none;
}

Ranking rank(const Evidence& evidence, const Grams& grams) {
  const Compared compared{grams, scatter_grid(grams, evidence.sample_sd)};
  Ranking ranking;
  ranking.none.log_evidence = compared.of({});
  std::vector<Single> singles = singles_of(compared);
  const std::span leaders(singles.begin(), std::min(kLeaders, singles.size()));
  for (Single& leader : leaders) {
    refine(evidence, leader);
  }
  std::ranges::sort(singles, better, &Single::hypothesis);
  if (leaders.size() > 1) {
    const Grams paired = with_leaders(evidence, grams, leaders);
    const Compared pairs_compared{paired, scatter_grid(paired, evidence.sample_sd)};
    std::vector<Pair> pairs = pairs_of(pairs_compared, leaders);
    for (std::size_t i = 0; i < std::min(kRefinedPairs, pairs.size()); ++i) {
      refine(evidence, pairs[i]);
    }
    std::ranges::sort(pairs, better, &Pair::hypothesis);
    for (Pair& pair : pairs) {
      ranking.pairs.push_back(std::move(pair.hypothesis));
    }
  }
  for (Single& single : singles) {
    ranking.singles.push_back(std::move(single.hypothesis));
  }
  return ranking;
}

}  // namespace host_sim::diagnose
