#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension_effect.hpp"
#include "host_sim/recording/covariates.hpp"

namespace host_sim::diagnose {

/// One session: the unit of every fit.
struct Session {
  std::string name;
  recording::Covariates covariates;
};

/// What a column of the regression is.
struct GramColumn {
  enum class Kind {
    intercept,  ///< 1: the gain of a session
    friction,   ///< -phi s: the friction coefficient of a session
    signature,
    residual,  ///< r = ln T_out - ln T_in + mu phi s, always last
  };
  Kind kind = Kind::signature;
  std::size_t effect = 0;  ///< index in GramLayout::effects; of a signature alone
  std::size_t shape = 0;   ///< index in TensionEffect::shapes()
  std::size_t column = 0;  ///< index in Signature::columns
};

/// Which column stands where: 1, -phi s, the signatures by effect, shape and column, r. The same
/// for all sessions of a campaign.
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

  std::vector<GramColumn> columns;
  std::vector<Effect> effects;  ///< in order of tension_effects()

  [[nodiscard]] std::size_t residual() const { return columns.size() - 1; }
  [[nodiscard]] std::size_t size() const { return columns.size(); }
  /// @throws std::out_of_range where there is no such effect
  [[nodiscard]] const Effect& of(std::string_view id) const;
  /// "friction_wear[3].0", "intercept", "friction" or "residual".
  [[nodiscard]] std::string label(std::size_t column) const;
};

/// All inner products of the columns of one session.
struct SessionGram {
  std::string session;
  Eigen::MatrixXd gram;       ///< size() x size(), symmetric, both halves filled
  std::size_t samples = 0;    ///< that were summed
  double bend_angle_rad = 0;  ///< mean over the samples: the pose
};

struct GramOptions {
  effects::Baseline baseline;  ///< poses_of() the sessions where it has none
  /// First-order autocorrelation of the noise, below 1 in magnitude: each column c becomes
  /// c(t) - rho c(t-1), the first sample sqrt(1 - rho^2) c, which whitens AR(1) noise.
  double autocorrelation = 0;
  /// Weights of the samples, one vector a session, each as long as its samples; none means 1.
  std::span<const std::vector<double>> weights = {};
  unsigned threads = 0;  ///< 0: all cores
};

struct Grams {
  effects::Baseline baseline;  ///< with the poses that the columns are for
  GramLayout layout;
  std::vector<SessionGram> sessions;  ///< in the order given
};

/// The poses of a campaign: the mean bend angles of its sessions, rising, those within a degree of
/// the one before counted as one.
std::vector<double> poses_of(std::span<const Session> sessions);

/// The layout for these sessions: an effect that one of them cannot give has no columns.
GramLayout layout_of(std::span<const Session> sessions, const effects::Baseline& baseline);

/// The columns of one session, samples() x layout.size(), in order of the layout.
/// @throws std::logic_error where an effect gives other columns than its layout says
Eigen::MatrixXd columns_of(const Session& session, const GramLayout& layout,
                           const effects::Baseline& baseline);

/// Layout and Gram matrices of all sessions, in one pass over the samples of each: never a matrix
/// of all sessions. The same for any number of threads.
Grams gram_of(std::span<const Session> sessions, const GramOptions& options);

}  // namespace host_sim::diagnose
