#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::diagnose {

/// Which column of the regression of ln T_out - ln T_in stands where: 1, the gain of a session;
/// -phi s, its friction coefficient; then the signatures by effect, shape and column. The same for
/// all sessions of a campaign.
struct GramLayout {
  /// The columns of one shape of an effect: `count` of them from `first` on.
  struct Block {
    std::vector<double> shape;  ///< of TensionEffect::shapes()
    std::size_t first = 0;
    std::size_t count = 0;
  };
  struct Effect {
    const effects::TensionEffect* effect = nullptr;
    /// Empty where each session holds what it needs, else what is missing; then without blocks.
    std::string missing;
    std::vector<Block> blocks;  ///< one for each shape
  };

  static constexpr std::size_t kIntercept = 0;
  static constexpr std::size_t kFriction = 1;
  static constexpr std::size_t kFirstSignature = 2;

  std::vector<Effect> effects;  ///< of the whole catalogue, in its order
  std::size_t size = kFirstSignature;

  /// @throws std::out_of_range where there is no such effect
  [[nodiscard]] const Effect& of(std::string_view id) const;
};

struct GramOptions {
  effects::Baseline baseline;  ///< poses_of() the sessions where it has none
  /// First-order autocorrelation of the noise, below 1 in magnitude: each column c becomes
  /// c(t) - rho c(t-1), the first sample sqrt(1 - rho^2) c, which whitens AR(1) noise.
  double autocorrelation = 0;
  unsigned threads = 0;  ///< 0: all cores
};

struct Grams {
  effects::Baseline baseline;  ///< with the poses that the columns are for
  GramLayout layout;
  /// All inner products of the columns of each session, size x size of the layout, symmetric.
  std::vector<Eigen::MatrixXd> sessions;
};

/// The layout for these sessions: an effect that one of them cannot give has no columns.
GramLayout layout_of(std::span<const Session> sessions, const effects::Baseline& baseline);

/// The columns of one session, samples() x size of the layout, in order of the layout.
/// @throws std::logic_error where an effect gives other columns than its layout says
Eigen::MatrixXd columns_of(const Session& session, const GramLayout& layout,
                           const effects::Baseline& baseline);

/// Layout and Gram matrices of all sessions, in one pass over the samples of each: never a matrix
/// of all sessions. The same for any number of threads.
Grams gram_of(std::span<const Session> sessions, const GramOptions& options);

}  // namespace host_sim::diagnose
