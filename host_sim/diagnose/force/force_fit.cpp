#include "host_sim/diagnose/force/force_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

constexpr int kFirstIterations = 2;  ///< of each start, and again of the best one of a term
/// Standard deviation of ln gain: more than that off is told as a doubt about units.
constexpr double kLogGain = 0.3;
constexpr int kFoldIterations = 2;  ///< from where all records have led

}  // namespace

/// Of least squares: J'J, J'r and the gradient of each record.
struct ForceData::Normal {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd gradient;
  std::vector<Eigen::VectorXd> of_records;
};

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

ForceData::Normal ForceData::normal_of(const effects::ForceTerms& terms,
                                       std::span<const double> parameters, int fold) const {
  const auto all = parameters_of(terms, scales_);
  const auto count = static_cast<Eigen::Index>(all.size());
  Normal normal{.matrix = Eigen::MatrixXd::Zero(count, count),
                .gradient = Eigen::VectorXd::Zero(count),
                .of_records = {}};
  for (std::size_t j = 0; j < records_.size(); ++j) {
    if (is_left_out(j, fold)) {
      continue;
    }
    const std::vector<double> at = residuals_N(j, terms, parameters);
    Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(at.size()), count);
    // All that a load cell reads is in proportion to the gain.
    const bool by_gain = records_[j].input_N_per_A == 0;
    for (std::size_t i = 0; by_gain && i < at.size(); ++i) {
      const effects::ForceRecord& of = records_[j];
      jacobian(static_cast<Eigen::Index>(i), 0) =
          of.used[i] ? (of.input_N[i] - at[i]) / parameters[0] : 0;
    }
    for (Eigen::Index k = by_gain ? 1 : 0; k < count; ++k) {
      const effects::ForceParameter& parameter = all[static_cast<std::size_t>(k)];
      if (parameter.chosen) {
        jacobian.col(k).setZero();
        continue;
      }
      std::vector<double> moved(parameters.begin(), parameters.end());
      double& value = moved[static_cast<std::size_t>(k)];
      const double step = step_of(parameter, value);
      value += step;
      jacobian.col(k) = (vector_of(at) - vector_of(residuals_N(j, terms, moved))) / step;
    }
    normal.matrix += covariance_.product(j, jacobian, jacobian);
    normal.of_records.emplace_back(covariance_.product(j, jacobian, vector_of(at)));
    normal.gradient += normal.of_records.back();
  }
  normal.matrix(0, 0) += gain_weight_N2_ / (parameters[0] * parameters[0]);
  normal.gradient(0) -= gain_weight_N2_ * std::log(parameters[0]) / parameters[0];
  return normal;
}

ForceFit ForceData::fit(const effects::ForceTerms& terms, std::vector<double> start, int iterations,
                        int fold) const {
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
    Normal normal = normal_of(terms, best.parameters, fold);
    // What would go beyond its bound stays there, and the others go without it.
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      const double value = best.parameters[k];
      double& pull = normal.gradient(at);
      if ((value <= all[k].minimum && pull < 0) || (value >= all[k].maximum && pull > 0)) {
        pull = 0;
        normal.matrix.row(at).setZero();
        normal.matrix.col(at).setZero();
        normal.matrix(at, at) = 1;
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

ForceFit ForceData::fold_fit(const ForceFit& whole, int fold) const {
  return fit(whole.terms, whole.parameters, kFoldIterations, fold);
}

std::vector<ForceFit> ForceData::fold_fits(const ForceFit& whole) const {
  std::vector<ForceFit> seen;
  seen.reserve(static_cast<std::size_t>(folds()));
  for (int fold = 0; fold < folds(); ++fold) {
    seen.push_back(fold_fit(whole, fold));
  }
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
    const double count = std::max(counts_[j], 1.0);
    held.residuals_N.push_back(left_N);
    held.weighted_N2.push_back(covariance_.weighted_square(j, vector_of(left_N)) / count);
    held.beside_scatter_N2.push_back(
        covariance_.product(j, vector_of(left_N), vector_of(left_N))(0, 0) / count);
    refits.push_back(
        covariance_.refit(j, vector_of(residuals_N(j, whole.terms, whole.parameters))));
  }
  held.log_likelihood = covariance_.log_likelihood_of(refits);
  held.plain_N2 = mean_squares_N2(held.residuals_N);
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
  const Eigen::Array2d variance =
      Eigen::Array2d(covariance_.log_gain_sd(), covariance_.friction_sd()).square();
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

double ForceData::freedom_of(const ForceFit& fit) const {
  const double records = static_cast<double>(records_.size());
  return std::max(records - static_cast<double>(fit.parameters.size()), 1.0);
}

ForceData::Covariance ForceData::covariance_of(const ForceFit& fit) const {
  const Normal normal = normal_of(fit.terms, fit.parameters, -1);
  const Eigen::Index count = normal.gradient.size();
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(count, count);
  for (const Eigen::VectorXd& gradient : normal.of_records) {
    scatter += gradient * gradient.transpose();
  }
  const Eigen::MatrixXd inverse =
      normal.matrix.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  const double records = static_cast<double>(records_.size());
  const Eigen::VectorXd by_gain = inverse.col(0) * (gain_weight_N2_ * kLogGain / fit.parameters[0]);
  return {.of_records = inverse * scatter * inverse * (records / freedom_of(fit)),
          .of_gain = by_gain * by_gain.transpose()};
}

std::vector<double> ForceData::half_widths(const ForceFit& fit, double times) const {
  const Covariance covariance = covariance_of(fit);
  const double wide = times * statistics::student95(freedom_of(fit));
  const auto all = parameters_of(fit.terms, scales_);
  std::vector<double> half;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    const double step_m = all[k].stepped ? resolution_m_ : 0;
    half.push_back(std::hypot(wide * std::sqrt(std::max(covariance.of_records(at, at), 0.0)),
                              times * statistics::kNormal95 * step_m,
                              statistics::kNormal95 * std::sqrt(covariance.of_gain(at, at))));
  }
  return half;
}

double ForceData::log_occam(const ForceFit& fit, std::size_t term) const {
  constexpr double kLeast = 1e-300;
  const auto values = parameters_at(term, fit.terms, fit.parameters, scales_);
  const auto first = static_cast<Eigen::Index>(values.data() - fit.parameters.data());
  double log_prior = 0;
  std::vector<Eigen::Index> places;
  std::vector<double> usual;
  const auto parameters = parameters_of(fit.terms[term], scales_);
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (parameters[k].chosen) {
      log_prior -= std::log(static_cast<double>(parameters[k].starts.size()));
      continue;
    }
    usual.push_back(parameters[k].usual == 0 ? parameters[k].starts.front() : parameters[k].usual);
    places.push_back(first + static_cast<Eigen::Index>(k));
    log_prior -= std::pow(values[k] / usual.back(), 2) / 2;
  }
  const Eigen::VectorXd scale = vector_of(usual).cwiseInverse();
  const Eigen::MatrixXd of_usual =
      scale.asDiagonal() * covariance_of(fit).all()(places, places) * scale.asDiagonal();
  return log_prior + std::log(std::max(of_usual.determinant(), kLeast)) / 2;
}

bool ForceData::is_physical(const ForceFit& fit, std::size_t term) const {
  const auto values = parameters_at(term, fit.terms, fit.parameters, scales_);
  const auto parameters = parameters_of(fit.terms[term], scales_);
  constexpr double kNear = 1e-3;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const effects::ForceParameter& parameter = parameters[k];
    const double range = parameter.maximum - parameter.minimum;
    // What lies within a range of many decades is near its lower bound by a share of that.
    const double lowest =
        parameter.minimum > 0 ? (1 + kNear) * parameter.minimum : parameter.minimum + kNear * range;
    const bool at_bound = values[k] > parameter.maximum - kNear * range ||
                          (parameter.minimum != 0 && values[k] < lowest);
    if ((at_bound && !parameter.chosen && !parameter.beside) ||
        std::abs(values[k]) < parameter.resolved) {
      return false;
    }
  }
  return true;
}

bool ForceData::may_be_none(const ForceFit& fit, std::size_t term,
                            std::span<const double> half) const {
  const auto values = parameters_at(term, fit.terms, fit.parameters, scales_);
  const auto half_of =
      half.subspan(static_cast<std::size_t>(values.data() - fit.parameters.data()));
  const auto parameters = parameters_of(fit.terms[term], scales_);
  // What cannot be zero says how, but for a law that has no other.
  const bool has_size = std::ranges::any_of(parameters, [](const effects::ForceParameter& one) {
    return !one.chosen && one.minimum <= 0;
  });
  bool any = false;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const effects::ForceParameter& parameter = parameters[k];
    const bool needed = parameter.stepped || parameter.resolved > 0;
    if (parameter.chosen || (has_size && parameter.minimum > 0) || (parameter.beside && !needed)) {
      continue;
    }
    const bool more = std::abs(values[k]) - half_of[k] > parameter.resolved;
    if (needed && !more) {
      return true;
    }
    any = any || more;
  }
  return !any;
}

}  // namespace host_sim::diagnose
