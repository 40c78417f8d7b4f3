#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "host_sim/statistics/goodness_of_fit.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::statistics {

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
