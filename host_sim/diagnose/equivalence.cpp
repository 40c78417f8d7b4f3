#include "host_sim/diagnose/equivalence.hpp"

#include <algorithm>
#include <numeric>

namespace host_sim::diagnose {
namespace {

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

}  // namespace host_sim::diagnose
