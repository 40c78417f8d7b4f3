#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/diagnose/force/smoothing.hpp"
#include "host_sim/statistics/distribution.hpp"

/// What a fit takes from the records before it begins, and what they leave of a model.
namespace host_sim::diagnose {
namespace {

/// Speeds below which friction turns over, of the usual one.
constexpr double kShares[] = {0.002, 0.01, 0.05, 0.15};

/// With what changes in a session as it is in its mean.
effects::ForceRecord at_session_means(effects::ForceRecord record) {
  for (auto* const channel :
       {&record.sheath_temperature_C, &record.winding_temperature_C, &record.cycle}) {
    if (!channel->empty()) {
      std::ranges::fill(*channel, effects::mean_of(*channel));
    }
  }
  return record;
}

}  // namespace

ForceData::ForceData(std::vector<effects::ForceRecord> records) {
  take_records(std::move(records), kMostSamples);
  take_scales(scales_of(records_));
  settle_turn_over();
  settle_resolution();
}

ForceData ForceData::as_sampled(std::vector<effects::ForceRecord> records, const ForceFit& nominal,
                                const ForceFit& model) const {
  ForceData all = *this;
  all.take_records(std::move(records), std::numeric_limits<std::size_t>::max());
  all.take_scales(scales_);
  all.learn_covariance(nominal, model, true);
  return all;
}

void ForceData::take_records(std::vector<effects::ForceRecord> records, std::size_t most) {
  records_ = std::move(records);
  noise_.clear();
  counts_.clear();
  samples_ = 0;
  for (effects::ForceRecord& record : records_) {
    noise_.push_back(smooth_output(record));
    record.reversal_m = reversals_m(record);
    thin(record, most);
    smooth_temperatures(record);
    counts_.push_back(static_cast<double>(std::ranges::count(record.used, true)));
    samples_ += counts_.back();
  }
}

void ForceData::take_scales(const effects::ForceScales& scales) {
  scales_ = scales;
  kinematics_.clear();
  for (const effects::ForceRecord& record : records_) {
    kinematics_.push_back(kinematics_of(record, scales_));
  }
}

/// As sharp as the friction that any drive has shows it, at a gain that is held by what such
/// friction leaves.
void ForceData::settle_turn_over() {
  const effects::ForceTerms plain{effects::ForceTerm::preload, effects::ForceTerm::velocity};
  std::vector<double> start;
  for (const effects::ForceParameter& parameter : parameters_of(plain, scales_)) {
    start.push_back(parameter.starts.front());
  }
  gain_weight_N2_ = gain_weight_N2(scales_.input_N * scales_.input_N * samples_);
  gain_weight_N2_ = gain_weight_N2(fit(plain, start, kIterations).square_N2);
  turn_over_by({plain, start, 0}, std::numeric_limits<double>::infinity());
  turn_over_late_by({plain, start, 0});
}

bool ForceData::settle_turn_over(const ForceFit& model) {
  constexpr double kLess = 0.001;  // of the squares
  const ForceFit settled = fit(model.terms, model.parameters, kIterations);
  const effects::ForceScales before = scales_;
  turn_over_by(settled, (1 - kLess) * settled.square_N2);
  turn_over_late_by(settled);
  return scales_.turn_over_m_s != before.turn_over_m_s ||
         scales_.forces_late_s != before.forces_late_s;
}

/// How sharp, of the model from its parameters on, where that leaves less than some squares.
void ForceData::turn_over_by(const ForceFit& model, double least_N2) {
  std::vector<effects::ForceScales> all(std::size(kShares), scales_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].turn_over_m_s = kShares[i] * scales_.speed_m_s;
  }
  take_best_of(all, model, least_N2);
}

/// How late, where that is clear: later or sooner than it is. A channel may be late by itself
/// beside it.
void ForceData::turn_over_late_by(const ForceFit& model) {
  constexpr double kLate_s[] = {0, 0.0007, 0.0014, 0.0025, 0.004, 0.007, 0.011, 0.016, 0.02};
  constexpr double kFiner[] = {0.8, 1.25, 0.9, 1.1};
  constexpr double kClear = 0.99;  // of the squares
  if (std::ranges::any_of(model.terms, effects::remembers_motion)) {
    return;
  }
  ForceFit beside = model;
  if (std::ranges::none_of(model.terms, [](effects::ForceTerm term) {
        return law_of(term).of == effects::ForceLaw::Of::time;
      })) {
    beside.terms.push_back(effects::ForceTerm::delay);
    beside.parameters.push_back(0);
  }
  beside = fit(beside.terms, beside.parameters, kIterations);
  const auto late_by = [&](std::span<const double> late_s, double times) {
    std::vector<effects::ForceScales> all(late_s.size(), scales_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].forces_late_s = times * late_s[i];
      if (all[i].forces_late_s > 0) {
        all[i].turn_over_m_s = kShares[0] * scales_.speed_m_s;  // what is late is dull by that
      }
    }
    return all;
  };
  const double before_s = scales_.forces_late_s;
  double least_N2 = take_best_of(late_by(kLate_s, 1), beside, kClear * beside.square_N2);
  if (scales_.forces_late_s != before_s) {
    least_N2 = take_best_of(late_by(kFiner, scales_.forces_late_s), beside, least_N2);
    turn_over_by(beside, least_N2);
  }
}

/// Those by which the model leaves less than some squares, and least.
/// @returns what is left, or those squares
double ForceData::take_best_of(std::span<const effects::ForceScales> all, const ForceFit& model,
                               double least_N2) {
  effects::ForceScales best = scales_;
  const std::size_t count = parameters_of(model.terms, scales_).size();
  for (const effects::ForceScales& scales : all) {
    if (parameters_of(model.terms, scales).size() != count) {
      continue;  // a law of the speed would be taken for it
    }
    take_scales(scales);
    const double square_N2 = fit(model.terms, model.parameters, kIterations).square_N2;
    if (square_N2 < least_N2) {
      least_N2 = square_N2;
      best = scales;
    }
  }
  take_scales(best);
  return least_N2;
}

/// A place between two samples is anywhere between them.
void ForceData::settle_resolution() {
  double square_m2 = 0;
  double reversals = 0;
  for (const effects::ForceRecord& record : records_) {
    double before_m = 0;
    for (std::size_t i = 1; i < record.samples(); ++i) {
      const double moved_m = record.position_m[i] - record.position_m[i - 1];
      square_m2 += moved_m * moved_m;
      reversals += moved_m * before_m < 0 ? 1 : 0;
      before_m = moved_m != 0 ? moved_m : before_m;
    }
  }
  resolution_m_ = std::sqrt(square_m2 / std::max(samples_, 1.0) / 12 / std::max(reversals, 1.0));
}

ForceData ForceData::without_outliers(const ForceFit& fit) const {
  std::vector<Eigen::VectorXd> left;  // over the noise of the sample
  std::vector<double> sizes;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    const std::vector<double> left_N = residuals_N(j, fit.terms, fit.parameters);
    left.push_back(covariance_.beside_scatter(j, vector_of(left_N)));
    for (std::size_t i = 0; i < left_N.size(); ++i) {
      double& size = left.back()(static_cast<Eigen::Index>(i));
      size = std::abs(size) * std::sqrt(covariance_.weight(j, i));
      if (records_[j].used[i]) {
        sizes.push_back(size);
      }
    }
  }
  ForceData inliers = *this;
  if (sizes.empty()) {
    return inliers;
  }
  const double most = statistics::outlier_limit(std::move(sizes));
  for (std::size_t j = 0; j < records_.size(); ++j) {
    std::vector<bool>& used = inliers.records_[j].used;
    for (std::size_t i = 0; i < used.size(); ++i) {
      used[i] = used[i] && left[j](static_cast<Eigen::Index>(i)) <= most;
    }
  }
  inliers.learn_covariance(fit, fit, true);
  return inliers;
}

std::vector<double> ForceData::residuals_N(std::size_t record, const effects::ForceTerms& terms,
                                           std::span<const double> parameters) const {
  std::vector<double> input_N;
  predict_input(records_[record], kinematics_[record], terms, scales_, parameters, input_N);
  return left_N(record, std::move(input_N));
}

std::vector<double> ForceData::left_N(std::size_t record, std::vector<double> input_N) const {
  const effects::ForceRecord& of = records_[record];
  for (std::size_t i = 0; i < input_N.size(); ++i) {
    input_N[i] = of.used[i] ? of.input_N[i] - input_N[i] : 0;
  }
  return input_N;
}

std::vector<std::vector<double>> ForceData::residuals_N(const ForceFit& fit) const {
  std::vector<std::vector<double>> all;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    all.push_back(residuals_N(j, fit.terms, fit.parameters));
  }
  return all;
}

Eigen::MatrixX2d ForceData::directions_N(std::size_t record, const ForceFit& model,
                                         double friction_coefficient) const {
  constexpr double kStep = 1e-4;
  constexpr double kNone = 1e-3;  // below it nothing rubs that friction could be a share of
  const bool rubs = friction_coefficient > kNone;
  const double unit = std::max(friction_coefficient, kNone);
  const effects::ForceRecord of = at_session_means(records_[record]);
  std::vector<double> even = model.parameters;
  std::vector<double> moved = model.parameters;
  moved[1] += kStep * (rubs ? moved[1] : unit);
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    const auto at = static_cast<std::size_t>(
        parameters_at(i, model.terms, model.parameters, scales_).data() - model.parameters.data());
    if (model.terms[i] == effects::ForceTerm::preload) {
      moved[at] *= 1 + kStep;
    } else if (model.terms[i] == effects::ForceTerm::load) {
      even[at] = 0;
      moved[at] = 0;
    }
  }
  const auto predicted_N = [&](const std::vector<double>& parameters) {
    std::vector<double> input_N;
    predict_input(of, kinematics_[record], model.terms, scales_, parameters, input_N);
    return input_N;
  };
  const std::vector<double> at_N = predicted_N(model.parameters);
  const std::vector<double> even_N = even == model.parameters ? at_N : predicted_N(even);
  const std::vector<double> moved_N = predicted_N(moved);
  Eigen::MatrixX2d directions(static_cast<Eigen::Index>(at_N.size()), 2);
  for (std::size_t i = 0; i < at_N.size(); ++i) {
    const double used = of.used[i] ? 1 : 0;
    directions.row(static_cast<Eigen::Index>(i)) << used * at_N[i],
        used * (moved_N[i] - even_N[i]) / (kStep * unit);
  }
  return directions;
}

double ForceData::noise_taken_N2(const ForceFit& before, const ForceFit& after) const {
  std::mt19937 engine(1);
  double square_N2 = 0;
  std::vector<double> once;
  std::vector<double> again;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    if (noise_[j].force_N2 <= 0) {
      continue;
    }
    std::normal_distribution<double> noise_N(0, std::sqrt(noise_[j].force_N2));
    effects::ForceRecord noisy = records_[j];
    for (double& output_N : noisy.output_N) {
      output_N += noise_N(engine);
    }
    const auto passed_on_N2 = [&](const ForceFit& by) {
      predict_input(records_[j], kinematics_[j], by.terms, scales_, by.parameters, once);
      predict_input(noisy, kinematics_[j], by.terms, scales_, by.parameters, again);
      double of_record_N2 = 0;
      for (std::size_t i = 0; i < once.size(); ++i) {
        of_record_N2 += records_[j].used[i] ? std::pow(again[i] - once[i], 2) : 0;
      }
      return of_record_N2;
    };
    square_N2 += passed_on_N2(before) - passed_on_N2(after);
  }
  return square_N2 / std::max(samples_, 1.0);
}

}  // namespace host_sim::diagnose
