#include "host_sim/diagnose/force/correction.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "host_sim/diagnose/force/force_search.hpp"
#include "host_sim/extension/model_file.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kWorthWriting = 0.02;  ///< of ln rmse

/// Between which knots a value lies, and how far from the first of them; beyond all the end counts.
struct Between {
  std::size_t knot = 0;
  double share = 0;  ///< of the next one
};

Between between(const std::vector<double>& knots, double value) {
  const auto above =
      static_cast<std::size_t>(std::ranges::upper_bound(knots, value) - knots.begin());
  if (above == 0 || above == knots.size()) {
    return {above == 0 ? 0 : above - 1, 0};
  }
  return {above - 1, (value - knots[above - 1]) / (knots[above] - knots[above - 1])};
}

/// As many samples lie between each two, as far as knots are apart by a thirtieth of the range:
/// what changes faster is no table for the resolution of a target.
std::vector<double> knots_of(const ForceCovariate& covariate, std::size_t count) {
  constexpr double kLeastApart = 1.0 / 30;
  std::vector<double> sorted;
  for (const auto& values : covariate.values) {
    sorted.insert(sorted.end(), values.begin(), values.end());
  }
  std::ranges::sort(sorted);
  const double apart = kLeastApart * (sorted.back() - sorted.front());
  std::vector<double> knots;
  for (std::size_t i = 0; i < count; ++i) {
    const double knot = sorted[(2 * i + 1) * sorted.size() / (2 * count)];
    if (knots.empty() || knot > knots.back() + apart) {
      knots.push_back(knot);
    }
  }
  return knots;
}

/// Least squares of a table, of each record apart so that any of them can be left out.
class TableFit {
 public:
  TableFit(const ForceData& data, const ForceCovariate& covariate, std::vector<double> knots)
      : data_(data), covariate_(covariate), knots_(std::move(knots)) {}

  /// @param fold records of this number modulo kFolds stay out; none: all take part
  [[nodiscard]] ForceTable table(const std::vector<std::vector<double>>& residuals_N,
                                 int fold) const {
    ForceTable table{knots_, {}, {}};
    for (const bool letting_go : {false, true}) {
      const auto count = static_cast<Eigen::Index>(knots_.size());
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
      Eigen::VectorXd vector = Eigen::VectorXd::Zero(count);
      for (std::size_t j = 0; j < residuals_N.size(); ++j) {
        if (!ForceData::is_held_out(j, fold)) {
          add(j, residuals_N[j], letting_go, matrix, vector);
        }
      }
      constexpr double kStiff = 1e-6;  // a knot that no sample is near stays at zero
      matrix.diagonal().array() += kStiff * (matrix.trace() / static_cast<double>(count) + 1);
      const Eigen::VectorXd forces_N = matrix.ldlt().solve(vector);
      (letting_go ? table.letting_go_N : table.pulling_N).assign(forces_N.begin(), forces_N.end());
    }
    return table;
  }

  /// What the table leaves of a record.
  [[nodiscard]] std::vector<double> left_N(std::size_t record, std::vector<double> residuals_N,
                                           const ForceTable& table) const {
    const effects::ForceRecord& of = data_.records()[record];
    for (std::size_t i = 0; i < of.samples(); ++i) {
      if (of.used[i]) {
        residuals_N[i] -= table.at_N(covariate_.values[record][i], of.velocity_m_s[i] < 0);
      }
    }
    return residuals_N;
  }

 private:
  void add(std::size_t record, const std::vector<double>& residuals_N, bool letting_go,
           Eigen::MatrixXd& matrix, Eigen::VectorXd& vector) const {
    const effects::ForceRecord& of = data_.records()[record];
    for (std::size_t i = 0; i < of.samples(); ++i) {
      if (!of.used[i] || (of.velocity_m_s[i] < 0) != letting_go) {
        continue;
      }
      const Between at = between(knots_, covariate_.values[record][i]);
      const std::array<double, 2> weights{1 - at.share, at.share};
      const auto knot = static_cast<Eigen::Index>(at.knot);
      for (Eigen::Index a = 0; a < (at.share > 0 ? 2 : 1); ++a) {
        const double weight = weights[static_cast<std::size_t>(a)];
        vector(knot + a) += weight * residuals_N[i];
        for (Eigen::Index b = 0; b < (at.share > 0 ? 2 : 1); ++b) {
          matrix(knot + a, knot + b) += weight * weights[static_cast<std::size_t>(b)];
        }
      }
    }
  }

  const ForceData& data_;
  const ForceCovariate& covariate_;
  std::vector<double> knots_;
};

}  // namespace

double ForceTable::at_N(double value, bool letting_go) const {
  const std::vector<double>& forces_N = letting_go ? letting_go_N : pulling_N;
  const Between at = between(knots, value);
  return at.share > 0 ? std::lerp(forces_N[at.knot], forces_N[at.knot + 1], at.share)
                      : forces_N[at.knot];
}

std::optional<ForceCorrection> correction_of(const ForceData& data, const ForceFit& fit,
                                             const std::vector<std::vector<double>>& held_N,
                                             std::span<const ForceCovariate> covariates,
                                             bool position_known) {
  std::vector<std::vector<std::vector<double>>> of_folds;
  for (const ForceFit& seen : data.fold_fits(fit)) {
    of_folds.push_back(data.residuals_N(seen));
  }
  std::optional<ForceCorrection> best;
  std::vector<double> best_N2;
  for (std::size_t i = 0; i < kEmpiricalCovariates.size(); ++i) {
    if (covariates[i].name == "position" && !position_known) {
      continue;
    }
    for (const std::size_t count : {std::size_t{4}, std::size_t{8}, kMostKnots}) {
      const TableFit table_fit(data, covariates[i], knots_of(covariates[i], count));
      std::vector<std::vector<double>> left_N(data.records().size());
      for (std::size_t fold = 0; fold < of_folds.size(); ++fold) {
        const ForceTable table = table_fit.table(of_folds[fold], static_cast<int>(fold));
        for (std::size_t j = 0; j < left_N.size(); ++j) {
          if (ForceData::is_held_out(j, static_cast<int>(fold))) {
            left_N[j] = table_fit.left_N(j, of_folds[fold][j], table);
          }
        }
      }
      const std::vector<double> left_N2 = data.mean_squares_N2(left_N);
      if (!best || data.rmse_N(left_N2) < data.rmse_N(best_N2)) {
        best = {i, table_fit.table(data.residuals_N(fit), -1), std::move(left_N)};
        best_N2 = left_N2;
      }
    }
  }
  const std::vector<double> held_N2 = data.mean_squares_N2(held_N);
  const bool gains = best && paired_gain(held_N2, best_N2).z >= kSeen &&
                     std::log(data.rmse_N(held_N2) / data.rmse_N(best_N2)) >= kWorthWriting;
  return gains ? best : std::nullopt;
}

Extension written_correction(const ForceCorrection& correction, double gain) {
  const auto before_gain = [gain](std::vector<double> forces_N) {
    for (double& force_N : forces_N) {
      force_N /= gain;
    }
    return forces_N;
  };
  const ForceTable& table = correction.table;
  return {std::string(kEmpirical),
          {{std::string(kEmpiricalCovariates[correction.covariate].name), table.knots},
           {std::string(kEmpiricalForces[0].name), before_gain(table.pulling_N)},
           {std::string(kEmpiricalForces[1].name), before_gain(table.letting_go_N)}}};
}

}  // namespace host_sim::diagnose
