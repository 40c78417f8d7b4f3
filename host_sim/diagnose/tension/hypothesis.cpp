#include "host_sim/diagnose/tension/hypothesis.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kSearchRounds = 5;
constexpr double kClearlyBetter = 2;  ///< of ln evidence

constexpr std::size_t kBetween = 3;  ///< shapes tried between each two neighbours

/// A shape, its place on the effect's own grid and its evidence.
struct Tried {
  double place = 0;
  std::vector<double> shape;
  double log_evidence = 0;
};

/// Shapes that differ from their neighbour in one coordinate that grows by factors.
bool between(const std::vector<double>& one, const std::vector<double>& other) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if ((one[i] > 0) != (other[i] > 0) || (one[i] < 0) != (other[i] < 0)) {
      return false;
    }
    if (one[i] != other[i]) {
      ++differing;
    }
  }
  return differing == 1;
}

std::vector<double> mixed(const std::vector<double>& one, const std::vector<double>& other,
                          double share) {
  std::vector<double> shape;
  for (std::size_t i = 0; i < one.size(); ++i) {
    shape.push_back(one[i] != 0 ? one[i] * std::pow(other[i] / one[i], share) : one[i]);
  }
  return shape;
}

std::vector<Tried> to_try(const std::vector<Tried>& tried, std::size_t best) {
  std::vector<Tried> wanted;
  for (const std::size_t left : {best - 1, best}) {
    if (left >= tried.size() || left + 1 >= tried.size() ||
        !between(tried[left].shape, tried[left + 1].shape)) {
      continue;
    }
    for (std::size_t i = 1; i <= kBetween; ++i) {
      const double share = static_cast<double>(i) / (kBetween + 1.0);
      wanted.push_back({.place = std::lerp(tried[left].place, tried[left + 1].place, share),
                        .shape = mixed(tried[left].shape, tried[left + 1].shape, share)});
    }
  }
  return wanted;
}

void evaluate(const Evidence& evidence, const effects::TensionEffect& effect,
              std::span<const Component> companions, std::vector<Tried>& wanted) {
  Wanted moved{.effect = &effect, .shapes = {}};
  for (const Tried& tried : wanted) {
    moved.shapes.push_back(tried.shape);
  }
  const std::vector<double> evidences = evidences_at(evidence, companions, moved);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i].log_evidence = evidences[i];
  }
}

/// Trapezoids over the grid's places, each end reaching half a step beyond.
double mean_over(const std::vector<Tried>& tried, double places) {
  const double most = std::ranges::max(tried, {}, &Tried::log_evidence).log_evidence;
  double sum = 0;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const double left = i == 0 ? tried[i].place - 0.5 : (tried[i - 1].place + tried[i].place) / 2;
    const double right =
        i + 1 == tried.size() ? tried[i].place + 0.5 : (tried[i].place + tried[i + 1].place) / 2;
    sum += (right - left) * std::exp(tried[i].log_evidence - most);
  }
  return most + std::log(sum / places);
}

/// Where an effect has several laws one after the other, a later one has to be clearly better: over
/// a part of their range many laws are alike.
std::size_t preferred_of(const std::vector<Tried>& tried) {
  std::vector<std::size_t> best_of_laws;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (i == 0 || !between(tried[i - 1].shape, tried[i].shape)) {
      best_of_laws.push_back(i);
    } else if (tried[i].log_evidence > tried[best_of_laws.back()].log_evidence) {
      best_of_laws.back() = i;
    }
  }
  const double most = std::ranges::max(tried, {}, &Tried::log_evidence).log_evidence;
  return *std::ranges::find_if(
      best_of_laws, [&](std::size_t i) { return tried[i].log_evidence >= most - kClearlyBetter; });
}

std::size_t best_of(const std::vector<Tried>& tried) {
  return static_cast<std::size_t>(std::ranges::max_element(tried, {}, &Tried::log_evidence) -
                                  tried.begin());
}

}  // namespace

std::string Hypothesis::id() const {
  std::string id;
  for (const Component& part : parts) {
    id += id.empty() ? "" : "+";
    id += part.effect->id();
  }
  return id.empty() ? "none" : id;
}

bool Hypothesis::holds(std::string_view id) const {
  return std::ranges::any_of(parts, [&](const Component& part) { return part.effect->id() == id; });
}

bool entangled(std::span<const Component> parts) {
  return std::ranges::count_if(
             parts, [](const Component& part) { return part.effect->at_reversals(); }) > 1;
}

bool confounded(std::span<const Component> parts) {
  const auto told_from = [](const Component& one, const Component& other) {
    return std::ranges::any_of(one.effect->separations(), [&](const effects::Separation& from) {
      return from.other == other.effect->id();
    });
  };
  return std::ranges::any_of(parts, [&](const Component& one) {
    return std::ranges::any_of(parts,
                               [&](const Component& other) { return told_from(one, other); });
  });
}

std::vector<Wanted> wanted_of(std::span<const Component> parts) {
  std::vector<Wanted> wanted;
  for (const Component& part : parts) {
    wanted.push_back({.effect = part.effect, .shapes = {part.shape}});
  }
  return wanted;
}

Terms terms_of(const GramLayout& layout) {
  Terms all;
  for (const GramLayout::Effect& effect : layout.effects) {
    for (const GramLayout::Block& block : effect.blocks) {
      all.append(terms_of(effect, block));
    }
  }
  return all;
}

std::vector<double> evidences_at(const Evidence& evidence, std::span<const Component> companions,
                                 const Wanted& moved) {
  GramOptions options = evidence.options;
  options.wanted = wanted_of(companions);
  options.wanted.push_back(moved);
  const Grams grams = gram_of(evidence.sessions, options);
  const auto grid = scatter_grid(grams, evidence.sample_sd);
  Terms beside;
  for (std::size_t i = 0; i < companions.size(); ++i) {
    beside.append(terms_of(grams.layout.effects[i], grams.layout.effects[i].blocks.front()));
  }
  const GramLayout::Effect& entry = grams.layout.effects.back();
  std::vector<double> evidences;
  evidences.reserve(entry.blocks.size());
  for (const GramLayout::Block& block : entry.blocks) {
    Terms terms = beside;
    terms.append(terms_of(entry, block));
    evidences.push_back(log_evidence(grid, terms, grams.response(), grams.samples()));
  }
  return evidences;
}

double mean_over_shapes(std::span<const double> log_evidences) {
  const double most = std::ranges::max(log_evidences);
  double sum = 0;
  for (const double value : log_evidences) {
    sum += std::exp(value - most);
  }
  return most + std::log(sum / static_cast<double>(log_evidences.size()));
}

ShapeSearch search_shape(const Evidence& evidence, const effects::TensionEffect& effect,
                         std::span<const double> at_shapes, std::span<const Component> companions) {
  const std::vector<std::vector<double>> shapes = effect.shapes();
  std::vector<Tried> tried;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    tried.push_back({static_cast<double>(i), shapes[i], at_shapes[i]});
  }
  for (std::size_t round = 0; round < kSearchRounds && effect.shapes_between(); ++round) {
    std::vector<Tried> wanted = to_try(tried, best_of(tried));
    if (wanted.empty()) {
      break;
    }
    evaluate(evidence, effect, companions, wanted);
    tried.insert(tried.end(), wanted.begin(), wanted.end());
    std::ranges::sort(tried, {}, &Tried::place);
  }
  const Tried& best = tried[effect.shapes_between() ? preferred_of(tried) : best_of(tried)];
  return {.best = {&effect, best.shape},
          .log_evidence = mean_over(tried, static_cast<double>(shapes.size())),
          .best_log_evidence = best.log_evidence};
}

}  // namespace host_sim::diagnose
