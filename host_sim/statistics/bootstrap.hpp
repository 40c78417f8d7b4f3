#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::statistics {

/// How the specimens of one sample would have been seen, for simulating samples like it.
///
/// A suspended specimen keeps its limit; one that failed gets a limit not below its life from the
/// Kaplan-Meier estimate of the limits, or none beyond the last (the conditional bootstrap; Davison
/// and Hinkley 1997, section 3.5). So all specimens of a test that ended at one life have that
/// limit.
///
/// Where some were found broken, specimens are inspected, but for those whose life is known: at the
/// ends that the sample has, and before, between and after them in steps of the median distance
/// between the two ends of a life; not before the first inspection where one was found broken
/// there.
///
/// Where lives were dropped as the lowest or highest, as many are dropped again.
class CensoringPlan {
 public:
  explicit CensoringPlan(std::span<const Observation> sample);

  /// A sample of the same size with lives out of `truth`, into `drawn`.
  void draw(const Distribution& truth, Random& random, Sample& drawn) const;

  /// The same with lives given by the caller: what is seen of `lives`, one for each specimen in the
  /// order of the sample that made the plan.
  void observe(std::span<const double> lives, Random& random, Sample& seen) const;

 private:
  [[nodiscard]] double limit_of(const Observation& specimen, Random& random) const;
  void plan_inspections();
  [[nodiscard]] Observation seen_of(const Observation& like, double life, double limit) const;
  [[nodiscard]] Observation inspected(double life, double limit) const;
  void trim(Sample& seen) const;

  Sample sample_;
  std::vector<double> inspections_;  ///< rising; none where lives are known
  double inspection_step_ = 0;
  bool first_is_known_ = false;  ///< nothing was looked at before the first of `inspections_`
  std::size_t trimmed_low_ = 0, trimmed_high_ = 0;
  std::vector<double> limits_;  ///< distinct, rising
  std::vector<double> limit_survival_;
};

/// Calls worker(random, i) for each replicate i. Replicates go in chunks of fixed size, each with
/// random numbers of its own and a worker of its own from make_worker(), which holds the memory
/// that its replicates share.
template <typename MakeWorker>
void for_each_replicate(const BootstrapOptions& options, const MakeWorker& make_worker) {
  constexpr std::size_t kChunk = 50;
  const std::size_t chunks = (options.replicates + kChunk - 1) / kChunk;
  const auto run_chunk = [&](std::size_t chunk) {
    auto worker = make_worker();
    Random random(options.seed, options.stream, chunk);
    const std::size_t end = std::min(options.replicates, (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      worker(random, i);
    }
  };
  parallel_for(chunks, run_chunk, options.threads);
}

/// (1 + replicates not below the observed statistic) / (1 + replicates). NaN stands for a replicate
/// that could not be computed, and is not counted; NaN where none could be.
double bootstrap_p(std::span<const double> replicates, double observed);

}  // namespace host_sim::statistics
