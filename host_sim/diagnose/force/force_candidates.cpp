#include "host_sim/diagnose/force/force_candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace host_sim::diagnose {
namespace {

/// The probability that what is named is all that is wrong, where what is left is no chance: laws
/// are approximations, too. In simulated campaigns that were not scored it was all in 21 of 29.
constexpr double kOnlyCauses = 0.7;

/// Of effects that are seen beside a model and take off too little to be in it: so many are there.
/// The others are how laws that are not quite right look. In simulated campaigns that were not
/// scored, 8 of 24 models that such an effect was left out of had missed one.
constexpr double kOfLeftOut = 0.35;

/// Nothing of that is as likely as the model itself.
constexpr double kLeastAsItIs = 0.5;

/// Effects that may be all that is wrong.
struct Set {
  std::vector<std::string> ids;
  double probability = 1;

  [[nodiscard]] Set with(effects::ForceTerm term, double times) const {
    Set more{ids, times * probability};
    more.ids.emplace_back(law_of(term).id());
    return more;
  }
};

/// Each set with an effect or what could be in its place, the one that the model has first, and
/// where it may not be named without.
std::vector<Set> with_each_of(const ForceData& data, const Judged& one,
                              const std::vector<Set>& sets) {
  std::vector<std::pair<effects::ForceTerm, double>> odds{{one.term, 1}};
  double all_odds = 1;
  for (const Judged::Other& other : one.others) {
    odds.emplace_back(other.term, std::exp(-other.log_odds));
    all_odds += odds.back().second;
  }
  const double probability = probability_of(one.term, one.gain, data) * one.share;
  std::vector<Set> all;
  for (const Set& set : sets) {
    for (const auto& [term, of_term] : odds) {
      all.push_back(set.with(term, probability * of_term / all_odds));
    }
    if (probability < kNamed) {
      all.push_back({set.ids, set.probability * (1 - probability)});
    }
  }
  return all;
}

void add(std::vector<std::string> ids, double probability, std::vector<Candidate>& candidates) {
  std::ranges::sort(ids);
  // What could be in the place of two is one, and so is what was left out by another law.
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  const std::string id = fmt::format("{}", fmt::join(ids, "+"));
  const auto same = std::ranges::find(candidates, id, &Candidate::id);
  if (same == candidates.end()) {
    candidates.push_back({id, probability});
  } else {
    same->probability += probability;  // by another law
  }
}

/// That an effect is there, though a model does without.
double probability_of(const LeftOut& one) {
  return std::max(kOfLeftOut * one.probability, one.unseen);
}

/// Of each candidate what is it and one effect more that was left out.
void share_with(std::span<const LeftOut> left_out, std::vector<Candidate>& candidates) {
  double as_it_is = 1;
  double sum = 0;
  for (const LeftOut& one : left_out) {
    as_it_is *= 1 - probability_of(one);
    sum += probability_of(one);
  }
  as_it_is = std::max(as_it_is, kLeastAsItIs);
  if (sum <= 0) {
    return;
  }
  for (const Candidate& candidate : std::vector(candidates)) {
    std::vector<std::string> ids;
    if (candidate.id != "none") {
      for (const std::string_view id : effects_in(candidate.id)) {
        ids.emplace_back(id);
      }
    }
    for (const LeftOut& one : left_out) {
      std::vector<std::string> more = ids;
      more.emplace_back(law_of(one.term).id());
      add(std::move(more), candidate.probability * (1 - as_it_is) * probability_of(one) / sum,
          candidates);
    }
    std::ranges::find(candidates, candidate.id, &Candidate::id)->probability -=
        candidate.probability * (1 - as_it_is);
  }
}

}  // namespace

std::vector<Candidate> candidates_of(const ForceData& data, std::span<const Judged> judged,
                                     std::span<const LeftOut> left_out, const std::string& rest,
                                     bool remainder_stands) {
  std::vector<Set> sets(1);
  for (const Judged& one : judged) {
    sets = with_each_of(data, one, sets);
  }
  const double alone = remainder_stands ? kOnlyCauses : 1;
  std::vector<Candidate> candidates;
  double all = 0;
  for (Set& set : sets) {
    if (set.ids.empty()) {
      continue;
    }
    add(set.ids, alone * set.probability, candidates);
    all += set.probability;
    if (remainder_stands) {
      set.ids.push_back(rest);
      add(std::move(set.ids), (1 - alone) * set.probability, candidates);
    }
  }
  candidates.push_back({rest, std::max(0.0, 1 - all)});
  if (!remainder_stands) {
    // What could be in the place of a cause was weighed there.
    std::vector<LeftOut> beside(left_out.begin(), left_out.end());
    std::erase_if(beside, [&](const LeftOut& out) {
      return std::ranges::any_of(judged, [&](const Judged& one) {
        return std::ranges::any_of(one.others, [&](const Judged::Other& other) {
          return same_effect(other.term, out.term);
        });
      });
    });
    share_with(beside, candidates);
  }
  std::ranges::stable_sort(candidates, std::greater<>(), &Candidate::probability);
  return candidates;
}

}  // namespace host_sim::diagnose
