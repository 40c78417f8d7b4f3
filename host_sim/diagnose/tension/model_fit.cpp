#include "host_sim/diagnose/tension/model_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "host_sim/recording/covariates.hpp"
#include "host_sim/statistics/distribution.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

/// Of gain and friction, far beyond what they ever are, so that one pose does not make them
/// indeterminate.
constexpr double kFlat_sd = 10;

Grams picked(const Grams& grams, std::span<const std::size_t> places) {
  Grams some{.baseline = grams.baseline, .layout = grams.layout, .sessions = {}};
  for (const std::size_t place : places) {
    some.sessions.push_back(grams.sessions[place]);
  }
  return some;
}

NoiseModel best_scatter(const Grams& grams, const Terms& terms, double sample_sd) {
  const std::vector<ScatterPoint> grid = scatter_grid(grams, sample_sd);
  const ScatterPoint* best = nullptr;
  double most = 0;
  for (const ScatterPoint& point : grid) {
    const double here = log_evidence({point}, terms, grams.response(), grams.samples());
    if (best == nullptr || here > most) {
      best = &point;
      most = here;
    }
  }
  return best->noise;
}

constexpr int kMostRounds = 25;
constexpr double kSettled = 1e-4;  ///< change of ln T in a round
constexpr double kMostOff = 4;     ///< of ln T, from what was measured

std::vector<double>& input_of(recording::Covariates& covariates) {
  return covariates.input_tension_N.empty() ? covariates.current_tension_N
                                            : covariates.input_tension_N;
}

std::vector<double>& output_of(recording::Covariates& covariates) {
  return covariates.output_tension_N;
}

/// One tension by the model from the other. Terms that hold the tension asked for see what they
/// give themselves, not what was measured: it is put in until it comes out again.
/// @param sign 1 for T_out, -1 for T_in
std::vector<double> settled(Session session, std::vector<double>& (*pick)(recording::Covariates&),
                            double sign, const GramLayout& layout,
                            const effects::Baseline& baseline, const ModelFit& fit) {
  std::vector<double>& tension_N = pick(session.covariates);
  const std::vector<double> measured_N = tension_N;
  double change = 2 * kSettled;
  for (int round = 0; round < kMostRounds && change > kSettled; ++round) {
    const Eigen::MatrixXd columns = columns_of(session, layout, baseline);
    // ln of T_out over T_in by the model over that of the tensions put in.
    const Eigen::VectorXd off =
        columns.leftCols(fit.coefficients.size()) * fit.coefficients - columns.rightCols<1>();
    change = 0;
    for (std::size_t i = 0; i < tension_N.size(); ++i) {
      const double next_N =
          std::clamp(tension_N[i] * std::exp(sign * off(static_cast<Eigen::Index>(i))),
                     measured_N[i] * std::exp(-kMostOff), measured_N[i] * std::exp(kMostOff));
      change = std::max(change, std::abs(std::log(next_N / tension_N[i])));
      tension_N[i] = next_N;
    }
  }
  return tension_N;
}

constexpr double kHardlyAny = 1e-6;

/// What a model leaves of the samples of a session, weighed, whose gain and friction are refitted.
Eigen::VectorXd left_of(const Evidence& evidence, const Fitted& by, std::size_t session) {
  constexpr double kRidge = 1e-9;
  Eigen::MatrixXd columns =
      columns_of(evidence.sessions[session], by.grams.layout, by.grams.baseline,
                 evidence.options.kept ? &evidence.options.kept->of(session) : nullptr);
  if (!evidence.options.weights.empty()) {
    weigh(columns, evidence.options.weights[session]);
  }
  const Eigen::VectorXd left =
      columns.rightCols<1>() - columns.leftCols(by.fit.coefficients.size()) * by.fit.coefficients;
  const Eigen::MatrixX2d own = columns.leftCols<2>();
  Eigen::Matrix2d square = own.transpose() * own;
  square.diagonal() *= 1 + kRidge;
  square.diagonal().array() += kRidge;
  return left - own * square.ldlt().solve(own.transpose() * left);
}

constexpr int kSelectionRounds = 3;
constexpr double kMostChange = 4;  ///< in one round

/// A size that is known to first order by its share alone, times that share.
void take_share(const Fitted& by, std::size_t place, Component& component) {
  if (component.shape.empty()) {
    return;
  }
  const auto parameters = component.effect->parameters();
  const GramLayout::Block& block = by.grams.layout.effects[place].blocks.front();
  const effects::Parameter& size = parameters[block.count];
  if (!size.scaled_by_share) {
    return;
  }
  const double share = by.fit.coefficients(static_cast<Eigen::Index>(block.first));
  const double factor = std::clamp(share, 1 / kMostChange, kMostChange);
  component.shape.front() =
      std::clamp(component.shape.front() * factor, size.minimum, size.maximum);
}

/// Friction and sizes, from one fit.
void take_fit(Evidence& evidence, std::vector<Component>& model) {
  const Fitted by = fitted(evidence, model);
  const double more = by.fit.coefficients(Eigen::Index{GramLayout::kFriction});
  double& friction = evidence.options.baseline.friction_coefficient;
  friction = std::max(friction + more, friction / kMostChange);
  for (std::size_t i = 0; i < model.size(); ++i) {
    take_share(by, i, model[i]);
  }
}

Component searched(const Evidence& evidence, const std::vector<Component>& model,
                   std::size_t place) {
  std::vector<Component> others = model;
  const effects::TensionEffect& effect = *others[place].effect;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(place));
  const std::vector<double> at_shapes =
      evidences_at(evidence, others, {.effect = &effect, .shapes = effect.shapes()});
  return search_shape(evidence, effect, at_shapes, others).best;
}

}  // namespace

ModelFit fit_model(const Grams& grams, const Terms& terms, std::span<const std::size_t> sessions,
                   double sample_sd) {
  const Grams some = picked(grams, sessions);
  ModelFit fit;
  fit.noise = best_scatter(some, terms, sample_sd);
  std::vector<Index> columns{Index{GramLayout::kIntercept}, Index{GramLayout::kFriction}};
  columns.insert(columns.end(), terms.columns.begin(), terms.columns.end());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(grams.response() + 1, grams.response() + 1);
  std::vector<Eigen::MatrixXd> of_sessions;
  for (const SessionGram& session : some.sessions) {
    of_sessions.push_back(session_information(session, fit.noise));
    information += of_sessions.back();
  }
  Eigen::MatrixXd inner = information(columns, columns);
  Eigen::VectorXd products = information(columns, grams.response());
  for (Index i = 0; i < inner.rows(); ++i) {
    const auto term = static_cast<std::size_t>(i) - 2;
    const double sd = i < 2 ? kFlat_sd : terms.prior_sd[term];
    inner(i, i) += 1 / (sd * sd);
    products(i) += i < 2 ? 0 : terms.prior_mean[term] / (sd * sd);
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(inner);
  fit.coefficients = solver.solve(products);
  fit.covariance = solver.solve(Eigen::MatrixXd::Identity(inner.rows(), inner.cols()));
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(inner.rows(), inner.cols());
  for (const Eigen::MatrixXd& of_session : of_sessions) {
    const Eigen::VectorXd gradient =
        of_session(columns, grams.response()) - of_session(columns, columns) * fit.coefficients;
    scatter += gradient * gradient.transpose();
  }
  const auto count = static_cast<double>(of_sessions.size());
  fit.degrees_of_freedom = std::max(count - static_cast<double>(inner.rows()), 1.0);
  fit.covariance_by_sessions =
      fit.covariance * scatter * fit.covariance * (count / fit.degrees_of_freedom);
  return fit;
}

ModelFit fit_model(const Grams& grams, const Terms& terms, double sample_sd) {
  std::vector<std::size_t> all(grams.sessions.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return fit_model(grams, terms, all, sample_sd);
}

Predicted predict(const Session& session, const GramLayout& layout,
                  const effects::Baseline& baseline, const ModelFit& fit) {
  return {.output_N = settled(session, output_of, 1, layout, baseline, fit),
          .input_N = settled(session, input_of, -1, layout, baseline, fit)};
}

Fitted fitted(const Evidence& evidence, std::span<const Component> model) {
  GramOptions options = evidence.options;
  options.wanted = wanted_of(model);
  Grams grams = gram_of(evidence.sessions, options);
  ModelFit fit = fit_model(grams, terms_of(grams.layout), evidence.sample_sd);
  return {std::move(grams), std::move(fit)};
}

Predicted predict(const Session& session, const Fitted& by) {
  return predict(session, by.grams.layout, by.grams.baseline, by.fit);
}

SampleWeights weights_without_outliers(const Evidence& evidence, std::span<const Component> model) {
  const Fitted by = fitted(evidence, model);
  std::vector<Eigen::VectorXd> left;
  std::vector<double> sizes;
  for (std::size_t j = 0; j < evidence.sessions.size(); ++j) {
    left.push_back(left_of(evidence, by, j));
    for (const double value : left.back()) {
      sizes.push_back(std::abs(value));
    }
  }
  const double most = statistics::outlier_limit(std::move(sizes));
  SampleWeights weights;
  for (std::size_t j = 0; j < left.size(); ++j) {
    weights.push_back(evidence.options.weights.empty()
                          ? std::vector<double>(static_cast<std::size_t>(left[j].size()), 1)
                          : evidence.options.weights[j]);
    for (std::size_t i = 0; i < weights.back().size(); ++i) {
      weights.back()[i] *= std::abs(left[j](static_cast<Index>(i))) > most ? kHardlyAny : 1;
    }
  }
  return weights;
}

double settled_friction(std::span<const Session> sessions, double nominal) {
  double square = 0;
  double product = 0;
  for (const Session& session : sessions) {
    const recording::SettledSums sums(session.covariates);
    square += sums.square;
    product += sums.product;
  }
  return recording::plausible_friction(square > 0 ? product / square : nominal, nominal);
}

void take_friction_of(Evidence& evidence, std::vector<Component> model) {
  for (int round = 0; round < kSelectionRounds && !model.empty(); ++round) {
    take_fit(evidence, model);
  }
}

std::vector<Component> refined(Evidence& evidence, std::vector<Component> model) {
  for (int round = 0; round < kSelectionRounds && !model.empty(); ++round) {
    take_fit(evidence, model);
    for (std::size_t i = 0; i < model.size(); ++i) {
      if (model[i].effect->at_reversals()) {
        model[i] = searched(evidence, model, i);
      }
    }
  }
  return model;
}

}  // namespace host_sim::diagnose
