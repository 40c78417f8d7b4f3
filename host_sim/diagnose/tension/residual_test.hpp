#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// What one probe sees in the residual of a model.
struct ProbeResult {
  Probe::Of of = Probe::Of::cycle;
  double statistic = 0;  ///< score statistic, chi-square of `freedom` but for the scatter
  double freedom = 0;
  double p = 1;  ///< of a statistic as rare as this in any of the probes
};

struct ResidualTest {
  std::vector<ProbeResult> probes;
  double p = 1;          ///< of the most significant probe
  double excess = 0;     ///< its statistic less its freedom: variances of a sample that it explains
  double explained = 0;  ///< the same of the model's effects against none
  /// The sessions scatter as much as scatter_values() allows, or more: they differ by what no rig
  /// does by itself.
  bool scatter_beyond = false;
};

/// Is there anything left? The maximum over the probes of their score statistics,
/// with p from campaigns of the same design that are simulated under the model: their scatter of
/// sessions drawn from its posterior and estimated anew in each. The statistics of covariates that
/// differ by session alone have no other null distribution than this.
/// @param grams of the model and the probes, in this order
/// @param threads 0: all cores; the answer does not depend on it
ResidualTest test_residual(const Grams& grams, double sample_sd, std::uint64_t seed,
                           unsigned threads);

/// The same of one model after another, against probes whose products are summed once.
class ResidualTests {
 public:
  ResidualTests(std::vector<Probe> probes, std::uint64_t seed)
      : probes_(std::move(probes)), seed_(seed) {}

  /// @param evidence always of the same sessions, weights and autocorrelation
  ResidualTest of(const Evidence& evidence, std::span<const Component> model);

  [[nodiscard]] const std::vector<Probe>& probes() const { return probes_; }

 private:
  std::vector<Probe> probes_;
  std::uint64_t seed_;
  std::optional<Grams> before_;  ///< of the first model
};

}  // namespace host_sim::diagnose
