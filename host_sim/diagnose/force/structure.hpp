#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "host_sim/diagnose/force/force_covariates.hpp"
#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// Mean residual of each session in each bin, by weight; absent where a session has few samples
/// there. Samples count where the direction of friction is settled: as the motion turns over, noise
/// of the velocity leaves what is the same in all sessions too.
class BinMeans {
 public:
  /// @param noise whose weights samples have
  BinMeans(const ForceData& data, const CovariateBins& bins,
           const std::vector<std::vector<double>>& residuals_N, const ForceCovariance& noise);

  /// How far the means are from zero against their scatter between sessions, mean of all bins: as
  /// many sessions as go the same way.
  /// @param signs by which sessions are turned over
  [[nodiscard]] double statistic(const std::vector<double>& signs) const;

  /// Square of the means over sessions, less what chance puts there and twice its standard error,
  /// in the mean over all samples by weight.
  [[nodiscard]] double square_N2() const;

  /// Of one bin, those that there are.
  [[nodiscard]] std::vector<double> of_sessions(std::size_t bin) const;

 private:
  static constexpr std::size_t kBins = 2 * CovariateBins::kCount;

  std::vector<std::array<std::optional<double>, kBins>> means_N_;
  std::array<double, kBins> weights_{};  ///< of samples that count, of all sessions
};

struct Spread {
  double mean_N = 0;
  double sd_N = 0;
};

/// @pre two values or more
Spread spread_of(const std::vector<double>& values_N);

/// What gain and friction that suit each session leave of the residuals of a model, by record and
/// sample.
std::vector<std::vector<double>> beside_scatter_N(const ForceData& data,
                                                  std::vector<std::vector<double>> residuals_N);

/// Gain and friction that suit each session beside a model that leaves these residuals.
std::vector<ForceCovariance::Refit> refits_of(const ForceData& data,
                                              const std::vector<std::vector<double>>& residuals_N);

/// Whether gain or friction of sessions scatters by more than it may without a cause.
struct SessionScatter {
  static constexpr double kRare = 0.01 / 3;

  double statistic = 0;  ///< the larger sum of squares, in terms of what it may be
  double p = 1;          ///< the chance of that
  double beyond_N2 = 0;  ///< mean square of what is more than it may be, where that is rare
};
SessionScatter session_scatter_of(const ForceData& data,
                                  const std::vector<std::vector<double>>& residuals_N);

/// How alike residuals are that lie some time apart, between reversals: at those noise of the
/// velocity is large, and comes as often as the motion turns.
struct Memory {
  double correlation = 0;  ///< mean over sessions
  double p = 1;            ///< that chance alone leaves as much
};
enum class MemoryOf {
  force,     ///< after 1 s, which noise of sensors does not remember
  friction,  ///< within 1 s, of opposite ways: noise and forces that stay are alike there, not
             ///< unlike
  size,      ///< after 0.25 s, in size alone, as what comes in bursts is
};
/// @param residuals_N beside the scatter of gain and friction
Memory memory_of(const ForceData& data, const std::vector<std::vector<double>>& residuals_N,
                 MemoryOf what);

/// Mean squares of what a model leaves and is no noise, by the weight of samples. What sessions
/// scatter by more than they may is a part of both.
struct Structure {
  double of_sessions_N2 = 0;  ///< what those do alone
  double repeats_N2 = 0;  ///< the same in all sessions, over the covariate that shows most of it
  /// Of what gain and friction of sessions leave, that or what goes on for an eighth of the time
  /// between reversals, whatever it depends on.
  double beside_scatter_N2 = 0;
};
Structure structure_of(const ForceData& data, const std::vector<CovariateBins>& bins,
                       const ForceFit& model);

}  // namespace host_sim::diagnose
