#include "host_sim/diagnose/tension/hypothesis.hpp"

#include <algorithm>

namespace host_sim::diagnose {

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

}  // namespace host_sim::diagnose
