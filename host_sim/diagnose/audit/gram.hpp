#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

/// What varies beside the effects.
struct NoiseModel {
  /// Standard deviation of the input force, by record and sample, beside what the output force says
  /// of it.
  std::vector<std::vector<double>> sample_sd_N;
  /// First-order autocorrelation of that noise, below 1 in magnitude: each column c becomes
  /// c(t) - rho c(t-1), the first sample sqrt(1 - rho^2) c, which whitens AR(1) noise.
  double autocorrelation = 0;
  double session_gain_sd = 0.01;       ///< of the gain of a session, in ln
  double session_friction_sd = 0.006;  ///< of the friction coefficient of a session
};

/// Which column of the input force stands where: what a unit of ln gain does to it, then a unit of
/// friction; then of each effect's usual cases what the case does, and what a unit of each of its
/// parameters does there. The same for all sessions of a campaign.
struct GramLayout {
  /// An effect of usual size by one of its laws.
  struct Case {
    effects::ForceTerm term{};
    std::vector<double> parameters;
    double most = 1;        ///< how many times as large physics allows it to be
    std::size_t first = 0;  ///< the column of the case
    std::size_t count = 0;  ///< of its columns, 1 and one for each parameter
  };
  struct Effect {
    const effects::TensionEffect* effect = nullptr;
    std::string missing;      ///< words; empty where each record holds what one of its laws needs
    std::vector<Case> cases;  ///< law by law
    std::size_t typical = 0;  ///< of cases: the one in the middle of the first law
  };

  static constexpr std::size_t kGain = 0;
  static constexpr std::size_t kFriction = 1;
  static constexpr std::size_t kFirstCase = 2;

  std::vector<Effect> effects;  ///< of the whole catalogue, in its order
  std::size_t size = kFirstCase;

  /// @throws std::out_of_range where there is no such effect
  [[nodiscard]] const Effect& of(std::string_view id) const;
};

/// Scales by which friction turns over at once: what it does meanwhile is no sign of an effect.
effects::ForceScales sharp_scales_of(std::span<const effects::ForceRecord> records);

/// The layout for these records: an effect that one of them cannot show has no cases.
GramLayout layout_of(std::span<const effects::ForceRecord> records,
                     const effects::ForceScales& scales);

/// The columns of one record in N, samples() x size of the layout, in order of the layout; 0 where
/// a sample does not count.
Eigen::MatrixXd columns_of(const effects::ForceRecord& record, const GramLayout& layout,
                           const effects::ForceScales& scales, double friction_coefficient);

struct Grams {
  GramLayout layout;
  /// All inner products of the columns of each session over the noise of its samples, size x size
  /// of the layout, symmetric.
  std::vector<Eigen::MatrixXd> sessions;
};

/// Layout and Gram matrices of all sessions, in one pass over the samples of each: never a matrix
/// of all sessions. The same for any number of threads.
/// @param threads 0: all cores
Grams gram_of(std::span<const effects::ForceRecord> records, double friction_coefficient,
              const NoiseModel& noise, unsigned threads);

}  // namespace host_sim::diagnose
