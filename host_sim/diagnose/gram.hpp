#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/probe.hpp"
#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/effects/tension_effect.hpp"
#include "host_sim/recording/covariates.hpp"

namespace host_sim::diagnose {

/// What a column of the regression is.
enum class ColumnKind {
  intercept,  ///< 1: the gain of a session
  friction,   ///< -phi s: the friction coefficient of a session
  signature,
  probe,     ///< a bin of a Probe
  residual,  ///< r = ln T_out - ln T_in + mu phi s, always last
};

struct GramColumn {
  ColumnKind kind = ColumnKind::signature;
  std::size_t effect = 0;  ///< index in GramLayout::effects, or of a probe in GramLayout::probes
  std::size_t shape = 0;   ///< index in GramLayout::Effect::blocks
  std::size_t column = 0;  ///< index in Signature::columns, or the bin of a probe
};

/// An effect with the shapes that it is tried in.
struct Wanted {
  const effects::TensionEffect* effect = nullptr;
  std::vector<std::vector<double>> shapes;  ///< as TensionEffect::shapes()
};

/// All effects of the catalogue with all their shapes, but those whose ids are `without`.
std::vector<Wanted> whole_catalogue(std::span<const std::string> without = {});

/// Which column stands where: 1, -phi s, the signatures by effect, shape and column, the probes, r.
/// The same for all sessions of a campaign.
struct GramLayout {
  /// The columns of one shape of an effect: `count` of them from `first` on.
  struct Block {
    std::vector<double> shape;  ///< of Wanted::shapes
    std::size_t first = 0;
    std::size_t count = 0;
  };
  struct Effect {
    const effects::TensionEffect* effect = nullptr;
    /// Empty where each session holds what it needs, else what is missing; then without blocks.
    std::string missing;
    std::vector<Block> blocks;  ///< one for each shape
  };

  struct ProbeBlock {
    Probe probe;
    std::size_t first = 0;
  };

  static constexpr std::size_t kIntercept = 0;
  static constexpr std::size_t kFriction = 1;
  static constexpr std::size_t kFirstSignature = 2;

  std::vector<GramColumn> columns;
  std::vector<Effect> effects;  ///< in the order wanted
  std::vector<ProbeBlock> probes;

  [[nodiscard]] std::size_t residual() const { return columns.size() - 1; }
  [[nodiscard]] std::size_t size() const { return columns.size(); }
  /// @throws std::out_of_range where there is no such effect
  [[nodiscard]] const Effect& of(std::string_view id) const;
  /// "friction_wear[3].0", "speed[2]", "intercept", "friction" or "residual".
  [[nodiscard]] std::string label(std::size_t column) const;
};

/// All inner products of the columns of one session.
struct SessionGram {
  std::string session;
  Eigen::MatrixXd gram;       ///< size() x size(), symmetric, both halves filled
  std::size_t samples = 0;    ///< that were summed
  double bend_angle_rad = 0;  ///< mean over the samples: the pose
  double log_weights = 0;     ///< sum of ln of the weights
};

/// Signatures of sessions under one baseline, so that each is computed once and not for every Gram.
/// What there is no room for is computed again.
class KeptSignatures {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  /// Those of one session. By one thread at a time.
  class OfSession {
   public:
    explicit OfSession(std::atomic<std::size_t>& bytes_left) : bytes_left_(&bytes_left) {}

    /// The signature, kept or new; in `room` where it is not kept. Valid until the next call.
    /// @pre always the same session
    const effects::Signature& signature(const Session& session,
                                        const effects::TensionEffect& effect,
                                        const effects::Baseline& baseline,
                                        const std::vector<double>& shape, effects::Signature& room);

   private:
    struct Kept {
      const effects::TensionEffect* effect;
      std::unique_ptr<const effects::Signature> signature;
    };

    void forget();

    std::atomic<std::size_t>* bytes_left_;
    effects::Baseline baseline_;
    std::vector<Kept> kept_;
  };

  explicit KeptSignatures(std::size_t sessions) {
    for (std::size_t i = 0; i < sessions; ++i) {
      sessions_.emplace_back(bytes_left_);
    }
  }
  KeptSignatures(const KeptSignatures&) = delete;
  KeptSignatures& operator=(const KeptSignatures&) = delete;

  OfSession& of(std::size_t session) { return sessions_[session]; }

 private:
  std::atomic<std::size_t> bytes_left_ = kMostBytes;
  std::vector<OfSession> sessions_;
};

struct GramOptions {
  std::vector<Wanted> wanted = whole_catalogue();
  std::vector<Probe> probes;
  effects::Baseline baseline;  ///< poses_of() the sessions where it has none
  /// First-order autocorrelation of the noise, below 1 in magnitude: each column c, once weighed,
  /// becomes c(t) - rho c(t-1), the first sample sqrt(1 - rho^2) c, which whitens AR(1) noise.
  double autocorrelation = 0;
  /// Weights of the samples, one over their variance, one vector a session, each as long as its
  /// samples; none means 1.
  std::span<const std::vector<double>> weights = {};
  unsigned threads = 0;  ///< 0: all cores
  /// Of these sessions; none: nothing is kept.
  std::shared_ptr<KeptSignatures> kept = nullptr;
};

struct Grams {
  effects::Baseline baseline;  ///< with the poses that the columns are for
  GramLayout layout;
  std::vector<SessionGram> sessions;  ///< in the order given

  [[nodiscard]] Eigen::Index response() const {
    return static_cast<Eigen::Index>(layout.residual());
  }
  [[nodiscard]] double samples() const;  ///< of all sessions
};

/// The layout for these sessions: an effect that one of them cannot give has no columns.
GramLayout layout_of(std::span<const Session> sessions, const effects::Baseline& baseline,
                     const std::vector<Wanted>& wanted = whole_catalogue(),
                     const std::vector<Probe>& probes = {});

/// The columns of one session, samples() x layout.size(), in order of the layout.
/// @param kept where signatures are taken from and left, of this session
/// @throws std::logic_error where an effect gives other columns than its layout says
Eigen::MatrixXd columns_of(const Session& session, const GramLayout& layout,
                           const effects::Baseline& baseline,
                           KeptSignatures::OfSession* kept = nullptr);

/// Weighs the rows of columns_of(): each times the root of its weight.
/// @throws std::logic_error where there is not one weight for each row
void weigh(Eigen::MatrixXd& columns, const std::vector<double>& weights);

/// Layout and Gram matrices of all sessions, in one pass over the samples of each: never a matrix
/// of all sessions. The same for any number of threads.
/// @param known of the same sessions, weights and autocorrelation: products of columns that it has
/// are taken from it, signatures and residuals only where it is for the same baseline
Grams gram_of(std::span<const Session> sessions, const GramOptions& options,
              const Grams* known = nullptr);

}  // namespace host_sim::diagnose
