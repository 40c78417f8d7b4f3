#include "host_sim/diagnose/force/force_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

constexpr int kFirstIterations = 2;  ///< of each start, and again of the best one of a term
constexpr int kFoldIterations = 2;   ///< from where all records have led

}  // namespace

/// The gain is near 1, as the nominal model has it, by as much as one session says of it: where the
/// output is hardly loaded, or all motion goes one way, nothing else tells it from friction.
double ForceData::gain_weight_N2(double square_N2) const {
  return square_N2 / static_cast<double>(std::max<std::size_t>(records_.size(), 1)) /
         (kLogGain * kLogGain);
}

double ForceData::square_of(const effects::ForceTerms& terms, std::span<const double> parameters,
                            int fold) const {
  const double log_gain = std::log(parameters[0]);
  double square_N2 = gain_weight_N2_ * log_gain * log_gain;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    if (!is_left_out(j, fold)) {
      const std::vector<double> left_N = residuals_N(j, terms, parameters);
      square_N2 += covariance_.product(j, vector_of(left_N), vector_of(left_N))(0, 0);
    }
  }
  return square_N2;
}

double ForceData::distance_N2(const ForceFit& one, const ForceFit& other) const {
  double square_N2 = 0;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    const std::vector<double> of_one_N = residuals_N(j, one.terms, one.parameters);
    const std::vector<double> of_other_N = residuals_N(j, other.terms, other.parameters);
    const Eigen::VectorXd apart_N = vector_of(of_one_N) - vector_of(of_other_N);
    square_N2 += covariance_.product(j, apart_N, apart_N)(0, 0);
  }
  return square_N2;
}

ForceData::Normal ForceData::normal_of(std::size_t record, const effects::ForceTerms& terms,
                                       std::span<const double> parameters) const {
  const auto all = parameters_of(terms, scales_);
  const auto count = static_cast<Eigen::Index>(all.size());
  const effects::ForceRecord& of = records_[record];
  std::vector<double> input_N;
  predict_input(of, kinematics_[record], terms, scales_, parameters, input_N);
  const std::vector<double> at = left_N(record, input_N);
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(at.size()), count);
  // All that a load cell reads is in proportion to the gain.
  const bool by_gain = of.input_N_per_A == 0;
  for (std::size_t i = 0; by_gain && i < at.size(); ++i) {
    jacobian(static_cast<Eigen::Index>(i), 0) =
        of.used[i] ? (of.input_N[i] - at[i]) / parameters[0] : 0;
  }
  std::vector<bool> known(all.size());
  known[0] = by_gain;
  for (std::size_t place = 0; place < terms.size(); ++place) {
    const auto own = parameters_at(place, terms, parameters, scales_);
    const auto first = static_cast<std::size_t>(own.data() - parameters.data());
    std::vector<double> slopes;
    if (!effects::position_slopes(of, kinematics_[record], terms, scales_, parameters, input_N,
                                  place, slopes)) {
      continue;
    }
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const std::size_t sample = i / own.size();
      jacobian(static_cast<Eigen::Index>(sample),
               static_cast<Eigen::Index>(first + i % own.size())) = of.used[sample] ? slopes[i] : 0;
    }
    std::fill_n(known.begin() + static_cast<std::ptrdiff_t>(first), own.size(), true);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const effects::ForceParameter& parameter = all[static_cast<std::size_t>(k)];
    if (known[static_cast<std::size_t>(k)]) {
      continue;
    }
    if (parameter.chosen) {
      jacobian.col(k).setZero();
      continue;
    }
    std::vector<double> moved(parameters.begin(), parameters.end());
    double& value = moved[static_cast<std::size_t>(k)];
    const double step = step_of(parameter, value);
    value += step;
    jacobian.col(k) = (vector_of(at) - vector_of(residuals_N(record, terms, moved))) / step;
  }
  return {covariance_.product(record, jacobian, jacobian),
          covariance_.product(record, jacobian, vector_of(at))};
}

std::vector<ForceData::Normal> ForceData::normals_of(const effects::ForceTerms& terms,
                                                     std::span<const double> parameters,
                                                     int fold) const {
  std::vector<Normal> normals(records_.size());
  for (std::size_t j = 0; j < records_.size(); ++j) {
    if (!is_left_out(j, fold)) {
      normals[j] = normal_of(j, terms, parameters);
    }
  }
  return normals;
}

void ForceData::Normal::fix(Eigen::Index place) {
  gradient(place) = 0;
  matrix.row(place).setZero();
  matrix.col(place).setZero();
  matrix(place, place) = 1;
}

ForceData::Normal ForceData::sum_of(const std::vector<Normal>& normals,
                                    std::span<const double> parameters, int fold) const {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  Normal sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  for (std::size_t j = 0; j < records_.size(); ++j) {
    if (!is_left_out(j, fold)) {
      sum.matrix += normals[j].matrix;
      sum.gradient += normals[j].gradient;
    }
  }
  sum.matrix(0, 0) += gain_weight_N2_ / (parameters[0] * parameters[0]);
  sum.gradient(0) -= gain_weight_N2_ * std::log(parameters[0]) / parameters[0];
  return sum;
}

ForceFit ForceData::fit(const effects::ForceTerms& terms, std::vector<double> start, int iterations,
                        int fold, const std::vector<Normal>* normals) const {
  constexpr double kEnough = 1e-7;
  constexpr int kTries = 8;
  const auto all = parameters_of(terms, scales_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    start[k] = std::clamp(start[k], all[k].minimum, all[k].maximum);
  }
  ForceFit best{terms, std::move(start), 0};
  best.square_N2 = square_of(terms, best.parameters, fold);
  double damping = 1e-3;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const bool known = iteration == 0 && normals != nullptr;
    Normal normal =
        sum_of(known ? *normals : normals_of(terms, best.parameters, fold), best.parameters, fold);
    // What would go beyond its bound stays there, and the others go without it.
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      const double value = best.parameters[k];
      const double pull = normal.gradient(at);
      if ((value <= all[k].minimum && pull < 0) || (value >= all[k].maximum && pull > 0)) {
        normal.fix(at);
      }
    }
    double gained = 0;
    for (int attempt = 0; attempt < kTries && gained == 0; ++attempt) {
      Eigen::MatrixXd damped = normal.matrix;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12;
      const Eigen::VectorXd step = damped.ldlt().solve(normal.gradient);
      std::vector<double> moved = best.parameters;
      for (std::size_t k = 0; k < moved.size(); ++k) {
        moved[k] = std::clamp(moved[k] + step(static_cast<Eigen::Index>(k)), all[k].minimum,
                              all[k].maximum);
      }
      const double square_N2 = square_of(terms, moved, fold);
      if (square_N2 < best.square_N2) {
        gained = 1 - square_N2 / best.square_N2;
        best.parameters = std::move(moved);
        best.square_N2 = square_N2;
        damping = std::max(damping / 5, 1e-9);
      } else {
        damping *= 4;
      }
    }
    if (gained < kEnough) {
      break;
    }
  }
  return best;
}

std::vector<ForceFit> ForceData::started(const ForceFit& from,
                                         std::span<const effects::ForceTerm> more,
                                         unsigned threads) const {
  struct Start {
    std::size_t term;
    std::vector<double> parameters;
  };
  std::vector<Start> starts;
  for (std::size_t term = 0; term < more.size(); ++term) {
    const auto added = parameters_of(more[term], scales_);
    std::size_t count = 0;
    for (const effects::ForceParameter& parameter : added) {
      count = std::max(count, parameter.starts.size());
    }
    for (std::size_t start = 0; start < count; ++start) {
      std::vector<double> parameters = from.parameters;
      for (const effects::ForceParameter& parameter : added) {
        parameters.push_back(parameter.starts[std::min(start, parameter.starts.size() - 1)]);
      }
      starts.push_back({term, std::move(parameters)});
    }
  }
  const auto fit_one = [&](std::size_t term, const std::vector<double>& parameters, int fold) {
    effects::ForceTerms terms = from.terms;
    terms.push_back(more[term]);
    return fit(terms, parameters, kFirstIterations, fold);
  };
  std::vector<ForceFit> tried(starts.size());
  statistics::parallel_for(
      starts.size(),
      [&](std::size_t i) { tried[i] = fit_one(starts[i].term, starts[i].parameters, kSome); },
      threads);
  std::vector<const ForceFit*> best(more.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const ForceFit*& of_term = best[starts[i].term];
    if (of_term == nullptr || tried[i].square_N2 < of_term->square_N2) {
      of_term = &tried[i];
    }
  }
  std::vector<ForceFit> all(more.size());
  statistics::parallel_for(
      all.size(), [&](std::size_t term) { all[term] = fit_one(term, best[term]->parameters, -1); },
      threads);
  return all;
}

ForceFit ForceData::finished(const ForceFit& from) const {
  return beyond_steps(fit(from.terms, from.parameters, kIterations));
}

ForceFit ForceData::fitted_anew(const ForceFit& from) const {
  constexpr int kAnew = 4;
  return fit(from.terms, from.parameters, kAnew);
}

/// A slope over steps leads into the next valley: the best of those around is taken.
ForceFit ForceData::beyond_steps(ForceFit best) const {
  constexpr double kFactors[] = {0.5, 0.65, 0.8, 0.9, 0.96, 1.04, 1.1, 1.25, 1.5, 2};
  const auto all = parameters_of(best.terms, scales_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].stepped) {
      continue;
    }
    ForceFit other = best;
    for (const double factor : kFactors) {
      std::vector<double> moved = best.parameters;
      moved[k] = std::clamp(factor * moved[k], all[k].minimum, all[k].maximum);
      const double square_N2 = square_of(best.terms, moved, -1);
      if (square_N2 < other.square_N2) {
        other.parameters = std::move(moved);
        other.square_N2 = square_N2;
      }
    }
    if (other.square_N2 < best.square_N2) {
      best = fit(other.terms, std::move(other.parameters), 2 * kFirstIterations);
    }
  }
  return best;
}

ForceFit ForceData::without(const ForceFit& from, std::size_t place) const {
  effects::ForceTerms terms;
  std::vector<double> parameters(from.parameters.begin(), from.parameters.begin() + 2);
  std::size_t next = 2;
  for (std::size_t i = 0; i < from.terms.size(); ++i) {
    const std::size_t count = parameters_of(from.terms[i], scales_).size();
    if (i != place) {
      terms.push_back(from.terms[i]);
      parameters.insert(parameters.end(),
                        from.parameters.begin() + static_cast<std::ptrdiff_t>(next),
                        from.parameters.begin() + static_cast<std::ptrdiff_t>(next + count));
    }
    next += count;
  }
  return fit(terms, std::move(parameters), kIterations);
}

std::vector<std::vector<ForceFit>> ForceData::fold_fits(std::span<const ForceFit> whole,
                                                        unsigned threads) const {
  // All folds of a model begin where it is.
  std::vector<std::vector<Normal>> normals(whole.size());
  statistics::parallel_for(
      whole.size(),
      [&](std::size_t i) { normals[i] = normals_of(whole[i].terms, whole[i].parameters, -1); },
      threads);
  const auto count = static_cast<std::size_t>(folds());
  std::vector<std::vector<ForceFit>> seen(whole.size(), std::vector<ForceFit>(count));
  statistics::parallel_for(
      whole.size() * count,
      [&](std::size_t i) {
        const ForceFit& of = whole[i / count];
        seen[i / count][i % count] = fit(of.terms, of.parameters, kFoldIterations,
                                         static_cast<int>(i % count), &normals[i / count]);
      },
      threads);
  return seen;
}

HeldOut ForceData::held_out(const ForceFit& whole) const {
  return held_out(whole, fold_fits(whole));
}

HeldOut ForceData::held_out(const ForceFit& whole, std::span<const ForceFit> seen) const {
  HeldOut held;
  std::vector<ForceCovariance::Refit> refits;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    const ForceFit& by = seen[j % kFolds];
    const std::vector<double> left_N = residuals_N(j, by.terms, by.parameters);
    held.residuals_N.push_back(left_N);
    refits.push_back(
        covariance_.refit(j, vector_of(residuals_N(j, whole.terms, whole.parameters))));
  }
  held.log_likelihood = covariance_.log_likelihood_of(refits);
  take_means(held);
  return held;
}

void ForceData::take_means(HeldOut& held) const {
  held.weighted_N2.clear();
  held.beside_scatter_N2.clear();
  for (std::size_t j = 0; j < records_.size(); ++j) {
    const auto left_N = vector_of(held.residuals_N[j]);
    const double count = std::max(counts_[j], 1.0);
    held.weighted_N2.push_back(covariance_.weighted_square(j, left_N) / count);
    held.beside_scatter_N2.push_back(covariance_.product(j, left_N, left_N)(0, 0) / count);
  }
  held.plain_N2 = mean_squares_N2(held.residuals_N);
}

HeldOut ForceData::away_from_turns(HeldOut held) const {
  for (std::size_t j = 0; j < records_.size(); ++j) {
    const std::vector<bool> next = effects::next_to_turns(records_[j]);
    for (std::size_t i = 0; i < next.size(); ++i) {
      held.residuals_N[j][i] = next[i] ? 0 : held.residuals_N[j][i];
    }
  }
  take_means(held);
  return held;
}

std::vector<double> ForceData::mean_squares_N2(
    const std::vector<std::vector<double>>& residuals_N) const {
  std::vector<double> means_N2;
  means_N2.reserve(residuals_N.size());
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    means_N2.push_back(vector_of(residuals_N[j]).squaredNorm() / std::max(counts_[j], 1.0));
  }
  return means_N2;
}

void ForceData::learn_covariance(const ForceFit& nominal, const ForceFit& model, bool with_timing) {
  const double friction_coefficient = nominal.parameters[1];
  std::vector<Eigen::MatrixX2d> directions;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    directions.push_back(directions_N(j, model, friction_coefficient));
  }
  covariance_ =
      ForceCovariance(records_, directions, residuals_N(model), friction_coefficient, with_timing);
  gain_weight_N2_ = 0;
  gain_weight_N2_ = gain_weight_N2(square_of(model.terms, model.parameters, -1));
}

double ForceData::scatter_of_mean_N2() const {
  const Eigen::Array2d variance = covariance_.scatter().square();
  double square_N2 = 0;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    square_N2 += (variance * covariance_.squares(j)).sum();
  }
  return square_N2 / samples_ / static_cast<double>(records_.size());
}

double ForceData::rmse_N(std::span<const double> means_N2) const {
  double square_N2 = 0;
  for (std::size_t j = 0; j < means_N2.size(); ++j) {
    square_N2 += means_N2[j] * counts_[j];
  }
  return std::sqrt(square_N2 / std::max(samples_, 1.0));
}

}  // namespace host_sim::diagnose
