#include "host_sim/diagnose/force/late_output.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kReach = 6;  ///< samples to each side, of which a half takes every second one

/// Value, slope and second derivative of the output force at a sample, by a cubic through those of
/// a half around it; none near a reversal, the ends, or samples that do not count.
std::optional<Eigen::Vector3d> cubic_at(const effects::ForceRecord& record, std::size_t i,
                                        std::size_t half) {
  if (i < kReach || i + kReach >= record.samples()) {
    return std::nullopt;
  }
  const double scale_s = record.step_s() * kReach;
  Eigen::Matrix4d square = Eigen::Matrix4d::Zero();
  Eigen::Vector4d product = Eigen::Vector4d::Zero();
  for (std::size_t k = i - kReach; k <= i + kReach; ++k) {
    if (!record.used[k] || record.velocity_m_s[k] * record.velocity_m_s[i] <= 0) {
      return std::nullopt;
    }
    if (k % 2 == half) {
      const double x = (record.time_s[k] - record.time_s[i]) / scale_s;
      const Eigen::Vector4d row(1, x, x * x, x * x * x);
      square += row * row.transpose();
      product += row * record.output_N[k];
    }
  }
  const Eigen::Vector4d fit = square.ldlt().solve(product);
  return Eigen::Vector3d(fit(0), fit(1) / scale_s, 2 * fit(2) / (scale_s * scale_s));
}

/// A record as one half of its samples shows it. Their own values stay: smoothing would bend them.
struct Half {
  effects::ForceRecord record;
  std::vector<double> bend_N_s2;  ///< second derivative of the output force
  std::vector<bool> known;

  Half(const effects::ForceRecord& all, std::size_t half)
      : record(all), bend_N_s2(all.samples()), known(all.samples()) {
    for (std::size_t i = 0; i < all.samples(); ++i) {
      if (const auto cubic = cubic_at(all, i, half)) {
        record.output_N[i] = i % 2 == half ? all.output_N[i] : (*cubic)(0);
        record.output_rate_N_s[i] = (*cubic)(1);
        bend_N_s2[i] = (*cubic)(2);
        known[i] = true;
      }
    }
  }
};

/// What a model leaves of a half, and what changes it.
struct Columns {
  Eigen::VectorXd left_N;
  Eigen::MatrixXd by_N;          ///< of a delay, then of each parameter but gain and friction
  Eigen::MatrixXd by_session_N;  ///< of gain and friction
};

Columns columns_of(const Half& half, const effects::Kinematics& kinematics,
                   const effects::ForceScales& scales, const ForceFit& model, double late_s) {
  constexpr double kStep = 1e-4;
  const auto predicted_N = [&](const effects::ForceRecord& record,
                               const std::vector<double>& parameters) {
    std::vector<double> input_N;
    predict_input(record, kinematics, model.terms, scales, parameters, input_N);
    return Eigen::VectorXd(vector_of(input_N));
  };
  const Eigen::VectorXd at_N = predicted_N(half.record, model.parameters);
  effects::ForceRecord delayed = half.record;
  for (std::size_t i = 0; i < delayed.samples(); ++i) {
    delayed.output_N[i] += late_s * late_s / 2 * half.bend_N_s2[i];
  }
  const auto count = static_cast<Eigen::Index>(model.parameters.size());
  Eigen::MatrixXd by_N(at_N.size(), count);
  const std::vector<effects::ForceParameter> all = parameters_of(model.terms, scales);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    std::vector<double> parameters = model.parameters;
    const double step =
        kStep * std::max(std::abs(parameters[at]), std::abs(all[at].starts.front()));
    parameters[at] += step;
    by_N.col(k) = (predicted_N(half.record, parameters) - at_N) / step;
  }
  Columns columns{vector_of(half.record.input_N) - at_N, by_N.rightCols(count - 1),
                  by_N.leftCols(2)};
  columns.by_N.col(0) = predicted_N(delayed, model.parameters) - at_N;
  return columns;
}

/// What a session adds to the equations of what is sought.
struct Equations {
  Eigen::MatrixXd square;
  Eigen::VectorXd product;
};

Equations equations_of(const ForceData& all, std::size_t session,
                       const effects::ForceRecord& record, const ForceFit& model, double late_s) {
  const std::array<Half, 2> halves{Half(record, 0), Half(record, 1)};
  std::array<Columns, 2> columns;
  for (std::size_t half = 0; half < halves.size(); ++half) {
    columns[half] =
        columns_of(halves[half], all.kinematics()[session], all.scales(), model, late_s);
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(columns[0].left_N.size());
  for (std::size_t i = 0; i < record.samples(); ++i) {
    if (halves[0].known[i] && halves[1].known[i]) {
      weights(static_cast<Eigen::Index>(i)) = all.covariance().weight(session, i);
    }
  }
  constexpr double kRidge = 1e-9;
  const Eigen::MatrixXd along = (columns[0].by_session_N + columns[1].by_session_N) / 2;
  const Eigen::MatrixXd weighted = weights.asDiagonal() * along;
  Eigen::Matrix2d square = weighted.transpose() * along;
  square.diagonal() = square.diagonal().array() * (1 + kRidge) + 1e-30;
  const Eigen::Matrix2d inverse = square.inverse();
  const auto beside_session = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
    return values - along * (inverse * (weighted.transpose() * values));
  };
  const Eigen::Index count = columns[0].by_N.cols();
  Equations equations{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  for (std::size_t half = 0; half < halves.size(); ++half) {
    Eigen::VectorXd own = weights;
    for (auto i = static_cast<Eigen::Index>(1 - half); i < own.size(); i += 2) {
      own(i) = 0;
    }
    const Eigen::MatrixXd shown = own.asDiagonal() * columns[1 - half].by_N;
    equations.square += shown.transpose() * beside_session(columns[half].by_N);
    equations.product += shown.transpose() * beside_session(columns[half].left_N);
  }
  return equations;
}

}  // namespace

LateOutput late_output(const ForceData& all, std::span<const effects::ForceRecord> records,
                       const ForceFit& lagging) {
  const auto place =
      std::ranges::find(lagging.terms, effects::ForceTerm::lag) - lagging.terms.begin();
  const double late_s = parameters_at(static_cast<std::size_t>(place), lagging.terms,
                                      lagging.parameters, all.scales())
                            .front();
  const auto count = static_cast<Eigen::Index>(lagging.parameters.size()) - 1;
  Equations sum{Eigen::MatrixXd::Zero(count, count), Eigen::VectorXd::Zero(count)};
  std::vector<Equations> of_sessions;
  for (std::size_t j = 0; j < records.size(); ++j) {
    effects::ForceRecord record = all.records()[j];
    record.output_N = records[j].output_N;
    of_sessions.push_back(equations_of(all, j, record, lagging, late_s));
    sum.square += of_sessions.back().square;
    sum.product += of_sessions.back().product;
  }
  const Eigen::MatrixXd inverse = sum.square.fullPivLu().inverse();
  const Eigen::VectorXd best = inverse * sum.product;
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(count, count);
  for (const Equations& session : of_sessions) {
    const Eigen::VectorXd off = session.product - session.square * best;
    scatter += off * off.transpose();
  }
  return {best(0), std::sqrt((inverse * scatter * inverse.transpose())(0, 0))};
}

}  // namespace host_sim::diagnose
