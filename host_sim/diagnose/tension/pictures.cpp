#include "host_sim/diagnose/tension/pictures.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/diagnose/tension/model_fit.hpp"
#include "host_sim/statistics/distribution.hpp"

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

constexpr std::size_t kTraces = 3;
constexpr std::size_t kMostPoints = 1200;

double mean_square_off(const std::vector<double>& one, const std::vector<double>& other) {
  double sum = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    sum += (one[i] - other[i]) * (one[i] - other[i]);
  }
  return one.empty() ? 0 : sum / static_cast<double>(one.size());
}

TracePicture trace_of(const Session& session, const Predicted& before, const Predicted& after) {
  const recording::Covariates& c = session.covariates;
  TracePicture trace{.session = session.name,
                     .time_s = {},
                     .input_N = {},
                     .measured_N = {},
                     .before_N = {},
                     .after_N = {}};
  // A stretch of the session at its full rate shows loops; thinning would cut their corners.
  const std::size_t points = std::min(kMostPoints, c.samples());
  for (std::size_t i = 0; i < points; ++i) {
    trace.time_s.push_back(c.time_s[i]);
    trace.input_N.push_back(c.tension_in_N()[i]);
    trace.measured_N.push_back(c.output_tension_N[i]);
    trace.before_N.push_back(before.output_N[i]);
    trace.after_N.push_back(after.output_N[i]);
  }
  return trace;
}

/// Residual ln T_out measured over predicted, by session.
std::vector<std::vector<double>> residuals_of(const Evidence& evidence, const Fitted& by) {
  std::vector<std::vector<double>> all;
  for (const Session& session : evidence.sessions) {
    const std::vector<double> output_N = predict(session, by).output_N;
    std::vector<double> residual;
    for (std::size_t i = 0; i < output_N.size(); ++i) {
      residual.push_back(std::log(session.covariates.output_tension_N[i] / output_N[i]));
    }
    all.push_back(std::move(residual));
  }
  return all;
}

struct Bins {
  std::vector<double> count, covariate, before, after;
  std::vector<double> shares;  ///< by column: sum over sessions of samples squared
};

Bins bins_of(const Evidence& evidence, const Probe& probe,
             const std::vector<std::vector<double>>& before,
             const std::vector<std::vector<double>>& after) {
  const std::vector<double> zeros(probe.columns());
  Bins bins{zeros, zeros, zeros, zeros, zeros};
  for (std::size_t s = 0; s < evidence.sessions.size(); ++s) {
    const recording::Covariates& covariates = evidence.sessions[s].covariates;
    const std::vector<std::size_t> columns = probe.column_of(covariates);
    const std::vector<double> values = values_of(probe.of, covariates);
    std::vector<double> here = zeros;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::size_t column = columns[i];
      here[column] += 1;
      bins.covariate[column] += values[i];
      bins.before[column] += before[s][i];
      bins.after[column] += after[s][i];
    }
    for (std::size_t column = 0; column < here.size(); ++column) {
      bins.count[column] += here[column];
      bins.shares[column] += here[column] * here[column];
    }
  }
  return bins;
}

/// Of the mean of a bin.
double deviation(const Bins& bins, std::size_t column, const NoiseModel& noise,
                 double autocorrelation, double angle_rad) {
  const double count = bins.count[column];
  const double sample_sd = noise.sample_sd / (1 - autocorrelation);
  const double friction_sd = noise.session_friction_sd * angle_rad;
  const double session_variance =
      noise.session_gain_sd * noise.session_gain_sd + friction_sd * friction_sd;
  return std::sqrt(sample_sd * sample_sd / count +
                   session_variance * bins.shares[column] / (count * count));
}

double mean_angle_rad(const Grams& grams) {
  double sum_rad = 0;
  for (const SessionGram& session : grams.sessions) {
    sum_rad += session.bend_angle_rad;
  }
  return sum_rad / static_cast<double>(grams.sessions.size());
}

}  // namespace

std::vector<TracePicture> trace_pictures(const Evidence& evidence,
                                         std::span<const Component> model) {
  const Fitted nominal = fitted(evidence, {});
  const Fitted extended = fitted(evidence, model);
  struct Missed {
    std::size_t place = 0;
    double square_N2 = 0;
  };
  std::vector<Missed> missed;
  for (std::size_t i = 0; i < evidence.sessions.size(); ++i) {
    const Session& session = evidence.sessions[i];
    missed.push_back({i, mean_square_off(predict(session, nominal).output_N,
                                         session.covariates.output_tension_N)});
  }
  std::ranges::stable_sort(missed, std::greater{}, &Missed::square_N2);
  std::vector<TracePicture> traces;
  for (std::size_t i = 0; i < std::min(kTraces, missed.size()); ++i) {
    const Session& session = evidence.sessions[missed[i].place];
    traces.push_back(trace_of(session, predict(session, nominal), predict(session, extended)));
  }
  return traces;
}

std::vector<SessionRefit> session_refits(const Evidence& evidence) {
  const Fitted nominal = fitted(evidence, {});
  std::vector<SessionRefit> refits;
  for (std::size_t i = 0; i < evidence.sessions.size(); ++i) {
    const ModelFit alone = fit_model(nominal.grams, terms_of(nominal.grams.layout),
                                     std::span(&i, 1), evidence.sample_sd);
    refits.push_back({evidence.sessions[i].name,
                      evidence.options.baseline.friction_coefficient +
                          alone.coefficients(Index{GramLayout::kFriction}),
                      alone.coefficients(Index{GramLayout::kIntercept})});
  }
  return refits;
}

std::vector<ResidualPicture> residual_pictures(const Evidence& evidence,
                                               const std::vector<Probe>& probes,
                                               std::span<const Component> model) {
  const Fitted nominal = fitted(evidence, {});
  const Fitted extended = fitted(evidence, model);
  const auto before = residuals_of(evidence, nominal);
  const auto after = residuals_of(evidence, extended);
  const double angle_rad = mean_angle_rad(nominal.grams);
  std::vector<ResidualPicture> pictures;
  for (const Probe& probe : probes) {
    const Bins bins = bins_of(evidence, probe, before, after);
    for (const int direction : {1, -1}) {
      ResidualPicture picture;
      picture.covariate = name_of(probe.of);
      picture.unit = unit_of(probe.of);
      picture.direction = direction;
      for (std::size_t bin = 0; bin < probe.bins(); ++bin) {
        const std::size_t column = direction > 0 ? probe.bins() + bin : bin;
        if (bins.count[column] == 0) {
          continue;
        }
        const double half =
            statistics::kNormal95 * deviation(bins, column, extended.fit.noise,
                                              evidence.options.autocorrelation, angle_rad);
        picture.centre.push_back(bins.covariate[column] / bins.count[column]);
        picture.before.push_back(bins.before[column] / bins.count[column]);
        picture.after.push_back(bins.after[column] / bins.count[column]);
        picture.envelope_low.push_back(-half);
        picture.envelope_high.push_back(half);
      }
      pictures.push_back(std::move(picture));
    }
  }
  return pictures;
}

}  // namespace host_sim::diagnose
