#include "host_sim/statistics/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/statistics/distribution.hpp"

namespace host_sim::statistics {
namespace {

/// The limits are what "fails" here, and a failure only says that its limit is not below its life.
/// At one life failures come first, so that they do not dilute the limits that are there.
Sample limits_as_failures(std::span<const Observation> sample) {
  Sample result(sample.begin(), sample.end());
  std::sort(result.begin(), result.end(), rises_failures_first);
  for (Observation& seen : result) {
    seen.failed = !seen.failed && !seen.trimmed;
    seen.trimmed = false;
  }
  return result;
}

}  // namespace

CensoringPlan::CensoringPlan(std::span<const Observation> sample)
    : sample_(sample.begin(), sample.end()) {
  KaplanMeier estimate;
  estimate.assign_in_order(limits_as_failures(sample));
  for (const KaplanMeier::Step& step : estimate.steps()) {
    limits_.push_back(step.value);
    limit_survival_.push_back(1 - step.after);
  }
  for (const Observation& seen : sample) {
    trimmed_low_ += seen.trimmed && seen.failed ? 1 : 0;
    trimmed_high_ += seen.trimmed && !seen.failed ? 1 : 0;
  }
  plan_inspections();
}

namespace {

bool was_inspected(const Observation& seen) {
  return seen.failed && !seen.trimmed && seen.from.has_value();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The same points with more between them where they are further apart than a step and a half.
std::vector<double> filled(const std::vector<double>& rising, double step) {
  constexpr double kApart = 1.5;
  constexpr double kMost = 1000;
  std::vector<double> all;
  for (const double point : rising) {
    const double before = all.empty() ? point : all.back();
    const double parts = std::min(kMost, std::round((point - before) / step));
    if (point - before > kApart * step) {
      for (double i = 1; i < parts; ++i) {
        all.push_back(before + (point - before) * i / parts);
      }
    }
    all.push_back(point);
  }
  return all;
}

}  // namespace

void CensoringPlan::plan_inspections() {
  std::vector<double> widths;
  for (const Observation& seen : sample_) {
    if (!was_inspected(seen)) {
      continue;
    }
    inspections_.push_back(seen.value);
    if (*seen.from > 0) {
      inspections_.push_back(*seen.from);
    }
    widths.push_back(seen.value - *seen.from);
  }
  if (inspections_.empty()) {
    return;
  }
  std::sort(inspections_.begin(), inspections_.end());
  inspections_.erase(std::unique(inspections_.begin(), inspections_.end()), inspections_.end());
  first_is_known_ = std::any_of(sample_.begin(), sample_.end(), [&](const Observation& seen) {
    return was_inspected(seen) && *seen.from == 0 && seen.value == inspections_.front();
  });
  inspection_step_ = median(std::move(widths));
  inspections_ = filled(inspections_, inspection_step_);
}

double CensoringPlan::limit_of(const Observation& specimen, Random& random) const {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (!specimen.failed && !specimen.trimmed) {
    return specimen.value;
  }
  const auto first = std::lower_bound(limits_.begin(), limits_.end(), specimen.value);
  if (first == limits_.end()) {
    return kNone;
  }
  const auto skipped = first - limits_.begin();
  const double survival_before =
      skipped == 0 ? 1 : limit_survival_[static_cast<std::size_t>(skipped - 1)];
  const double drawn = random.uniform() * survival_before;
  for (auto i = static_cast<std::size_t>(skipped); i < limits_.size(); ++i) {
    if (limit_survival_[i] < drawn) {
      return limits_[i];
    }
  }
  return kNone;
}

Observation CensoringPlan::inspected(double life, double limit) const {
  const double first = inspections_.front();
  const double last = inspections_.back();
  double from = 0;
  double to = first;
  if (life > last) {
    from = last + std::floor((life - last) / inspection_step_) * inspection_step_;
    to = from + inspection_step_;
  } else if (life > first) {
    const auto after = std::lower_bound(inspections_.begin(), inspections_.end(), life);
    from = *(after - 1);
    to = *after;
  } else if (!first_is_known_) {
    to = first - std::floor((first - life) / inspection_step_) * inspection_step_;
    from = std::max(0.0, to - inspection_step_);
  }
  return {.value = std::min(to, limit), .failed = true, .from = from};
}

/// What is seen of a life where its specimen is looked at as `like` was.
Observation CensoringPlan::seen_of(const Observation& like, double life, double limit) const {
  if (life > limit) {
    return {.value = limit, .failed = false};
  }
  return inspections_.empty() || like.exact() ? Observation{.value = life, .failed = true}
                                              : inspected(life, limit);
}

/// Drops as many lives as the sample had dropped, if any is left then.
void CensoringPlan::trim(Sample& seen) const {
  std::vector<Observation*> failed;
  for (Observation& one : seen) {
    if (one.failed) {
      failed.push_back(&one);
    }
  }
  const std::size_t dropped = trimmed_low_ + trimmed_high_;
  if (dropped == 0 || failed.size() <= dropped) {
    return;
  }
  std::sort(failed.begin(), failed.end(),
            [](const Observation* a, const Observation* b) { return a->value < b->value; });
  const std::size_t end = failed.size() - trimmed_high_;
  const double lowest = failed[trimmed_low_]->value;
  const double highest = failed[end - 1]->value;
  for (std::size_t i = 0; i < trimmed_low_; ++i) {
    *failed[i] = {.value = lowest, .failed = true, .from = 0, .trimmed = true};
  }
  for (std::size_t i = end; i < failed.size(); ++i) {
    *failed[i] = {.value = highest, .failed = false, .trimmed = true};
  }
}

void CensoringPlan::draw(const Distribution& truth, Random& random, Sample& drawn) const {
  drawn.resize(sample_.size());
  for (std::size_t i = 0; i < sample_.size(); ++i) {
    const double life = truth.quantile(random.uniform());
    drawn[i] = seen_of(sample_[i], life, limit_of(sample_[i], random));
  }
  trim(drawn);
}

void CensoringPlan::observe(std::span<const double> lives, Random& random, Sample& seen) const {
  seen.resize(sample_.size());
  for (std::size_t i = 0; i < sample_.size(); ++i) {
    seen[i] = seen_of(sample_[i], lives[i], limit_of(sample_[i], random));
  }
  trim(seen);
}

double bootstrap_p(std::span<const double> replicates, double observed) {
  double computed = 0;
  double exceeding = 0;
  for (const double replicate : replicates) {
    computed += std::isnan(replicate) ? 0 : 1;
    exceeding += replicate >= observed ? 1 : 0;
  }
  if (computed == 0 || std::isnan(observed)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return (1 + exceeding) / (1 + computed);
}

}  // namespace host_sim::statistics
