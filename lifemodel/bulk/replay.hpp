#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "lifemodel/bulk/instructions.hpp"
#include "lifemodel/bulk/reducer.hpp"
#include "lifemodel/counting/stretch.hpp"
#include "lifemodel/estimator.hpp"

namespace lifemodel::bulk {

/// For hosts: takes many samples at once, with the same bits as push() and settle() of each, many
/// times as fast. Nobody hears of the cycles.
class Replay {
 public:
  explicit Replay(const Instructions& by = *instructions().front()) : reducer_(by) {}

  template <std::size_t kTendons, class Layout>
  void take(Estimator<kTendons, Layout>& estimator, std::size_t tendon,
            std::span<const Tension> samples) {
    const auto& parameters = estimator.parameters(tendon);
    while (!samples.empty()) {
      const auto here = samples.first(std::min(samples.size(), Reducer::kMostSamples));
      samples = samples.subspan(here.size());
      std::optional<Stretch> stretch;
      if (here.size() >= kWorthReducing) {
        stretch = reducer_.reduce(here, parameters.hysteresis, parameters.law);
      }
      if (!stretch || !estimator.replay(tendon, *stretch)) {
        estimator.replay(tendon, here);
      }
    }
  }

 private:
  static constexpr std::size_t kWorthReducing = 64;

  Reducer reducer_;
};

}  // namespace lifemodel::bulk
