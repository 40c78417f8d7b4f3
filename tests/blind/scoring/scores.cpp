#include "tests/blind/scoring/scores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "tests/blind/generator/sized_effect.hpp"
#include "tests/blind/oracle/visibility.hpp"
#include "tests/blind/scoring/judgement.hpp"

namespace blind {
namespace {

using Binomial = boost::math::binomial_distribution<double>;

constexpr double kTail = 0.025;

constexpr double kBarely = 3;
constexpr double kPlainly = 5;

bool is_held_back(std::string_view id) {
  const auto holds = [&](std::span<const SizedEffect> effects) {
    return std::any_of(effects.begin(), effects.end(),
                       [&](const SizedEffect& effect) { return effect.id == id; });
  };
  return holds(held_back_effects()) || holds(held_back_two_sided_effects());
}

void add(const Judgement& judgement, Detection& detection) {
  detection.first.add(judgement.right_first());
  detection.of_class.add(judgement.right_class());
}

void add_one(const Record& record, const Judgement& judgement, Scores& scores) {
  add(judgement, scores.one);
  add(judgement, scores.effects[record.truth.hidden.front().id]);
  if (judgement.visible_at(kBarely)) {
    add(judgement, scores.one_at_3);
  }
  if (judgement.visible_at(kPlainly)) {
    add(judgement, scores.one_at_5);
    scores.one_named_at_5.add(judgement.named_all());
  }
}

void add_by_kind(const Record& record, const Judgement& judgement, Scores& scores) {
  switch (record.truth.kind) {
    case CampaignKind::none:
      scores.none_named.add(judgement.named());
      scores.none_alarmed.add(record.findings.verdict != host_sim::diagnose::Verdict::none);
      break;
    case CampaignKind::one:
      add_one(record, judgement, scores);
      break;
    case CampaignKind::two:
      scores.two_first.add(judgement.right_first());
      if (judgement.visible_at(kPlainly)) {
        scores.two_first_at_5.add(judgement.right_first());
      }
      scores.two_named.add(judgement.named_all());
      break;
    case CampaignKind::three:
      scores.three_first.add(judgement.right_first());
      scores.three_named.add(judgement.named_all());
      break;
    case CampaignKind::outside:
      scores.outside_unknown.add(judgement.unknown());
      scores.outside_named.add(judgement.named());
      scores.outside[record.truth.hidden.front().id].add(judgement.unknown());
      if (is_held_back(record.truth.hidden.front().id)) {
        scores.held_back_unknown.add(judgement.unknown());
        scores.held_back_named.add(judgement.named());
      }
      break;
  }
}

void add_parameters(const Record& record, Scores& scores) {
  for (const HiddenEffect& hidden : record.truth.hidden) {
    for (const auto& found : record.findings.effects) {
      if (hidden.outside || found.id != hidden.id || found.parameters.empty()) {
        continue;
      }
      for (const ParameterScore& score : score_parameters(true_parameters(hidden), found)) {
        scores.parameter_errors.push_back(score.relative_error);
        (record.truth.hidden.size() == 1 ? scores.parameters_covered
                                         : scores.parameters_covered_of_several)
            .add(score.covered);
      }
    }
  }
}

/// Only what the true model gains something by shows how good a gain is.
void add_gain(const Record& record, Scores& scores) {
  constexpr double kWorthwhile = 0.9;
  for (const auto& metric : record.findings.gain.metrics) {
    if (metric.name == "rmse_N" && record.rmse_floor_N > 0 &&
        record.rmse_floor_N < kWorthwhile * metric.before) {
      scores.relative_gains.push_back(
          relative_gain(metric.before, metric.after, record.rmse_floor_N));
    }
  }
}

std::string first_in_table(const Record& record, const Judgement& judgement) {
  const std::string first = judgement.first();
  if (record.truth.hidden.size() < 2 || first == "none" || first == "unknown") {
    return first;
  }
  return judgement.right_first()       ? "all of them"
         : judgement.first_is_hidden() ? "some of them"
                                       : "others";
}

std::string truth_in_table(const Record& record) {
  return record.truth.kind == CampaignKind::outside ? "outside: " + record.truth.hidden.front().id
         : record.truth.kind == CampaignKind::two   ? "two"
         : record.truth.kind == CampaignKind::three ? "three"
                                                    : answer_of(record.truth);
}

}  // namespace

double Proportion::value() const {
  return of == 0 ? std::numeric_limits<double>::quiet_NaN()
                 : static_cast<double>(holds) / static_cast<double>(of);
}

double Proportion::lower() const {
  return of == 0 ? 0
                 : Binomial::find_lower_bound_on_p(static_cast<double>(of),
                                                   static_cast<double>(holds), kTail);
}

double Proportion::upper() const {
  return of == 0 || holds == of ? 1
                                : Binomial::find_upper_bound_on_p(
                                      static_cast<double>(of), static_cast<double>(holds), kTail);
}

std::size_t Proportion::least_of(std::size_t some) const {
  constexpr double kFewer = 0.1;
  const Binomial draws(static_cast<double>(some), value());
  std::size_t least = 0;
  while (least < some && boost::math::cdf(draws, static_cast<double>(least)) <= kFewer) {
    ++least;
  }
  return least;
}

std::string text_of(const Proportion& proportion) {
  return proportion.of == 0
             ? "-"
             : fmt::format("{:.1f} % ({:.1f} .. {:.1f}, {} of {})", 100 * proportion.value(),
                           100 * proportion.lower(), 100 * proportion.upper(), proportion.holds,
                           proportion.of);
}

void Calibration::add(double probability, bool right) {
  const double last = static_cast<double>(bins_.size() - 1);
  const double place =
      std::clamp(std::floor(probability * static_cast<double>(bins_.size())), 0.0, last);
  Bin& bin = bins_[static_cast<std::size_t>(place)];
  ++bin.answers;
  bin.right += right ? 1 : 0;
  bin.sum_of_probabilities += probability;
}

double Calibration::error() const {
  double distance = 0;
  double answers = 0;
  for (const Bin& bin : bins_) {
    distance += std::abs(static_cast<double>(bin.right) - bin.sum_of_probabilities);
    answers += static_cast<double>(bin.answers);
  }
  return answers > 0 ? distance / answers : 0;
}

Scores scores_of(const std::vector<Record>& records) {
  Scores scores;
  double sizes = 0;
  for (const Record& record : records) {
    if (!record.error.empty()) {
      ++scores.refused;
      continue;
    }
    const Judgement judgement(record);
    add_by_kind(record, judgement, scores);
    if (judgement.named()) {
      scores.named_right.add(judgement.named_right());
      add_parameters(record, scores);
    }
    if (judgement.named_all()) {
      add_gain(record, scores);
    }
    scores.covered.add(judgement.covered());
    sizes += static_cast<double>(judgement.set_size());
    scores.calibration.add(judgement.first_probability(), judgement.right_first());
    ++scores.confusion[{truth_in_table(record), first_in_table(record, judgement)}];
  }
  scores.set_size = sizes / static_cast<double>(scores.covered.of);
  std::sort(scores.parameter_errors.begin(), scores.parameter_errors.end());
  std::sort(scores.relative_gains.begin(), scores.relative_gains.end());
  return scores;
}

double quantile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace blind
