#include "host_sim/statistics/same_shape_samples.hpp"

namespace host_sim::statistics {

SameShapeSamples::SameShapeSamples(std::span<const Sample> samples, const CommonShapeFit& common) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const CentredSample logs(Family::weibull, samples[i]);
    if (logs.failures() > 0) {
      measured_.push_back(logs);
      plans_.emplace_back(samples[i]);
      truths_.push_back(
          {.family = Family::weibull, .first = common.scales[i], .second = common.shape});
    }
  }
}

std::span<const CentredSample> SameShapeSamples::draw(Random& random, Memory& memory) const {
  memory.logs.resize(plans_.size());
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    plans_[i].draw(truths_[i], random, memory.lives);
    memory.logs[i].assign(Family::weibull, memory.lives);
  }
  return memory.logs;
}

}  // namespace host_sim::statistics
