#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <span>
#include <utility>

#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/statistics/distribution.hpp"

/// How well records know the parameters of a fit.
namespace host_sim::diagnose {
namespace {

/// What cannot be zero says how an effect is, but for a law that has no other.
bool says_how(const effects::ForceParameter& parameter) {
  return !parameter.chosen && parameter.minimum > 0;
}

bool has_size(std::span<const effects::ForceParameter> parameters) {
  return std::ranges::any_of(parameters, [](const effects::ForceParameter& one) {
    return !one.chosen && one.minimum <= 0;
  });
}

/// Places of parameters that a fit has left at a bound.
std::vector<Eigen::Index> at_bounds(std::span<const effects::ForceParameter> parameters,
                                    std::span<const double> values) {
  std::vector<Eigen::Index> places;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    if (values[k] <= parameters[k].minimum || values[k] >= parameters[k].maximum) {
      places.push_back(static_cast<Eigen::Index>(k));
    }
  }
  return places;
}

}  // namespace

Eigen::VectorXd ForceData::step_from(const ForceFit& fit) const {
  const Normal normal = sum_of(normals_of(fit.terms, fit.parameters, -1), fit.parameters, -1);
  return normal.matrix.ldlt().solve(normal.gradient);
}

/// Noise of the output that smoothing has left moves the parameters by about as much as the same
/// once more (SIMEX; Cook and Stefanski, 1994): in pairs of opposite sign, of which what is in
/// proportion to it goes.
ForceFit ForceData::beside_output_noise(const ForceFit& fit) const {
  constexpr int kPairs = 2;
  constexpr double kMost = 0.1;  // of what the output does: more of it moves them otherwise
  double noise_N2 = 0;
  double moves_N2 = 0;
  for (std::size_t j = 0; j < records_.size(); ++j) {
    const Eigen::ArrayXd output_N = vector_of(records_[j].output_N).array();
    noise_N2 += noise_[j].force_N2;
    moves_N2 += (output_N - output_N.mean()).square().mean();
  }
  if (noise_N2 == 0 || noise_N2 > kMost * moves_N2) {
    return fit;
  }
  std::mt19937 engine(1);
  std::bernoulli_distribution up;
  Eigen::VectorXd off = -step_from(fit);
  for (int pair = 0; pair < kPairs; ++pair) {
    std::array<ForceData, 2> noisy{*this, *this};
    for (std::size_t j = 0; j < records_.size(); ++j) {
      const double force_N = std::sqrt(noise_[j].force_N2);
      const double rate_N_s = std::sqrt(noise_[j].rate_N2_s2);
      for (std::size_t i = 0; i < records_[j].samples(); ++i) {
        const double off_N = up(engine) ? force_N : -force_N;
        const double off_N_s = up(engine) ? rate_N_s : -rate_N_s;
        noisy[0].records_[j].output_N[i] += off_N;
        noisy[1].records_[j].output_N[i] -= off_N;
        noisy[0].records_[j].output_rate_N_s[i] += off_N_s;
        noisy[1].records_[j].output_rate_N_s[i] -= off_N_s;
      }
    }
    for (ForceData& data : noisy) {
      data.learn_covariance(fit, fit, true);
      off += data.step_from(fit) / (2 * kPairs);
    }
  }
  ForceFit beside = fit;
  const auto all = parameters_of(fit.terms, scales_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    double& value = beside.parameters[k];
    value = std::clamp(value - off(static_cast<Eigen::Index>(k)), all[k].minimum, all[k].maximum);
  }
  return beside;
}

double ForceData::freedom_of(const ForceFit& fit) const {
  const double records = static_cast<double>(records_.size());
  return std::max(records - static_cast<double>(fit.parameters.size()), 1.0);
}

/// What lies at a bound goes no further, and what it is held from moves no others.
ForceData::Covariance ForceData::covariance_of(const ForceFit& fit) const {
  const std::vector<Normal> normals = normals_of(fit.terms, fit.parameters, -1);
  Covariance covariance = covariance_of(fit, normals, {});
  const std::vector<Eigen::Index> bound =
      at_bounds(parameters_of(fit.terms, scales_), fit.parameters);
  if (!bound.empty()) {
    const Covariance free = std::exchange(covariance, covariance_of(fit, normals, bound));
    for (const Eigen::Index k : bound) {
      covariance.of_records(k, k) = free.of_records(k, k);
      covariance.of_noise(k, k) = free.of_noise(k, k);
      covariance.of_gain(k, k) = free.of_gain(k, k);
    }
  }
  return covariance;
}

/// Of residuals that are enlarged by how far each record leads the fit (bias-reduced linearisation;
/// Bell and McCaffrey, 2002).
ForceData::Covariance ForceData::covariance_of(const ForceFit& fit, std::vector<Normal> normals,
                                               std::span<const Eigen::Index> bound) const {
  constexpr double kMostLeverage = 0.95;  // what one record alone shows has no residual
  Normal normal = sum_of(normals, fit.parameters, -1);
  for (const Eigen::Index k : bound) {
    normal.fix(k);
    for (Normal& of_record : normals) {
      of_record.fix(k);
    }
  }
  const Eigen::Index count = normal.gradient.size();
  const double records = static_cast<double>(records_.size());
  // In units in which the matrix of all records is one: a record has the share of it by which its
  // residuals are too small.
  Eigen::VectorXd scale = normal.matrix.diagonal().cwiseSqrt();
  scale = (scale.array() > 0).select(scale, 1);
  Eigen::MatrixXd scaled =
      scale.cwiseInverse().asDiagonal() * normal.matrix * scale.cwiseInverse().asDiagonal();
  scaled.diagonal().array() += 1e-12;
  const Eigen::LLT<Eigen::MatrixXd> root(scaled);
  const auto to_unit = [&](const Eigen::MatrixXd& columns) -> Eigen::MatrixXd {
    return root.matrixL().solve(scale.cwiseInverse().asDiagonal() * columns);
  };
  Eigen::MatrixXd moved(count, static_cast<Eigen::Index>(normals.size()));
  for (std::size_t j = 0; j < normals.size(); ++j) {
    const Eigen::MatrixXd share = to_unit(to_unit(normals[j].matrix).transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> shares(share);
    const Eigen::VectorXd larger =
        (1 - shares.eigenvalues().array().max(0).min(kMostLeverage)).rsqrt().matrix();
    moved.col(static_cast<Eigen::Index>(j)) =
        shares.eigenvectors() *
        (larger.asDiagonal() * (shares.eigenvectors().transpose() * to_unit(normals[j].gradient)));
  }
  moved.colwise() -= moved.rowwise().mean().eval();
  const Eigen::MatrixXd spread =
      scale.cwiseInverse().asDiagonal() * Eigen::MatrixXd(root.matrixU().solve(moved));
  const Eigen::MatrixXd scatter = spread * spread.transpose() * (records / (records - 1));
  const Eigen::MatrixXd inverse =
      normal.matrix.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  // As if all directions were as noisy as those are in the mean: chance makes the variance of one
  // smaller that few records show.
  const double of_noise = (normal.matrix * scatter).trace() /
                          static_cast<double>(count - static_cast<Eigen::Index>(bound.size()));
  const Eigen::ArrayXd variance = scatter.diagonal().array().max(1e-300);
  const Eigen::VectorXd wider =
      (of_noise * inverse.diagonal().array() / variance).max(1).sqrt().matrix();
  const Eigen::VectorXd by_gain = inverse.col(0) * (gain_weight_N2_ * kLogGain / fit.parameters[0]);
  return {.of_records = wider.asDiagonal() * scatter * wider.asDiagonal(),
          .of_noise = of_noise * inverse,
          .of_gain = by_gain * by_gain.transpose()};
}

std::vector<double> ForceData::half_widths(const ForceFit& fit, double times) const {
  return half_widths_by(covariance_of(fit), fit, times);
}

std::vector<double> ForceData::half_widths_by(const Covariance& covariance, const ForceFit& fit,
                                              double times) const {
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

std::vector<double> ForceData::half_widths_of_sizes(const ForceFit& fit, double times) const {
  Covariance covariance = covariance_of(fit);
  Eigen::MatrixXd& of_records = covariance.of_records;
  Eigen::Index first = 2;
  for (const effects::ForceTerm term : fit.terms) {
    const std::vector<effects::ForceParameter> own = parameters_of(term, scales_);
    for (std::size_t k = 0; has_size(own) && k < own.size(); ++k) {
      const Eigen::Index at = first + static_cast<Eigen::Index>(k);
      const double variance = of_records(at, at);
      if (says_how(own[k]) && variance > 0) {
        const Eigen::VectorXd with_others = of_records.col(at);
        of_records -= with_others * with_others.transpose() / variance;
      }
    }
    first += static_cast<Eigen::Index>(own.size());
  }
  return half_widths_by(covariance, fit, times);
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
  const Covariance covariance = covariance_of(fit);
  const Eigen::MatrixXd of_usual = scale.asDiagonal() *
                                   (covariance.of_noise + covariance.of_gain)(places, places) *
                                   scale.asDiagonal();
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
  bool any = false;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const effects::ForceParameter& parameter = parameters[k];
    const bool needed = parameter.stepped || parameter.resolved > 0;
    if (parameter.chosen || (has_size(parameters) && says_how(parameter)) ||
        (parameter.beside && !needed)) {
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
