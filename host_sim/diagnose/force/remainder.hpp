#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// What residuals may depend on, by direction.
struct ForceCovariate {
  std::string_view name;
  std::string_view unit;
  std::vector<std::vector<double>> values;  ///< by record and sample
};

/// Size of the output force, position, speed and travel since the motion turned, in the order of
/// kEmpiricalCovariates; after these rate of the output force, acceleration and time, which no
/// correction is made of.
std::vector<ForceCovariate> force_covariates(const std::vector<ForceRecord>& records);

/// Bins of a covariate that hold as many samples each, and which one each sample lies in: an even
/// number where the motion goes one way, the next one where it goes back.
struct RemainderBins {
  static constexpr std::size_t kCount = 8;

  RemainderBins(const std::vector<ForceRecord>& records, const ForceCovariate& covariate);

  std::vector<double> centres;
  std::vector<std::vector<std::size_t>> places;  ///< by record and sample
};

/// Mean squares of what a model leaves and is no noise, by the weight of samples.
struct Structure {
  double repeats_N2 = 0;  ///< the same in all sessions, over the covariate that shows most of it
  /// Of what gain and friction of sessions leave, that or what goes on for an eighth of the time
  /// between reversals, whatever it depends on.
  double beside_scatter_N2 = 0;
};
Structure structure_of(const ForceData& data, const std::vector<RemainderBins>& bins,
                       const ForceFit& model);

/// What a model leaves that is the same in all sessions.
struct ForceRemainder {
  std::string_view covariate;  ///< that it depends on most
  double p = 1;                ///< that chance alone shows as much
  double share = 0;            ///< of the squared residuals beside the scatter of gain and friction
  std::vector<RemainderPicture> pictures;  ///< against that covariate, before and after
};

/// Of what is left, from where on it shows as structure: noise of the output force and of the
/// velocity alone leave up to 0.4 % that is the same in all sessions.
inline constexpr double kLeastRemainder = 0.005;

/// By signs of sessions that are turned over at random, and the largest statistic of all
/// covariates.
ForceRemainder remainder_of(const ForceData& data, const ForceFit& nominal, const ForceFit& model,
                            const std::vector<ForceCovariate>& covariates,
                            const std::vector<RemainderBins>& bins, std::uint64_t seed);

}  // namespace host_sim::diagnose
