#include "host_sim/diagnose/tension/predicted.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::diagnose {
namespace {

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

}  // namespace

Predicted predict(const Session& session, const GramLayout& layout,
                  const effects::Baseline& baseline, const ModelFit& fit) {
  return {.output_N = settled(session, output_of, 1, layout, baseline, fit),
          .input_N = settled(session, input_of, -1, layout, baseline, fit)};
}

}  // namespace host_sim::diagnose
