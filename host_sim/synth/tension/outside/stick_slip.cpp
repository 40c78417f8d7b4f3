#include <cmath>
#include <optional>

#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/streams.hpp"
#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Bursts of stick-slip at random times: within one, friction climbs by a share and lets go, as a
/// saw tooth. Bursts begin at a constant rate and do not overlap.
class StickSlip final : public TensionPart {
 public:
  explicit StickSlip(const Values& values)
      : share_(values["share"]),
        mean_wait_s_(60 / values["bursts_per_min"]),
        burst_s_(values["burst_s"]),
        frequency_Hz_(values["frequency_Hz"]) {}

  void begin(const Setting& setting, std::uint64_t seed) override {
    random_.emplace(seed, kStickSlipStream, setting.number);
    next_s_ = mean_wait_s_ * exponential(*random_);
  }

  void advance(const Moment& moment) override {
    while (moment.time_s >= next_s_ + burst_s_) {
      next_s_ += burst_s_ + mean_wait_s_ * exponential(*random_);
    }
  }

  [[nodiscard]] double friction(double mu, const Moment& moment,
                                double /*tension_N*/) const override {
    if (moment.time_s < next_s_) {
      return mu;
    }
    const double teeth = (moment.time_s - next_s_) * frequency_Hz_;
    return mu * (1 + share_ * (teeth - std::floor(teeth)));
  }

 private:
  double share_, mean_wait_s_, burst_s_, frequency_Hz_;
  std::optional<statistics::Random> random_;
  double next_s_ = 0;
};

}  // namespace

TensionKind stick_slip() {
  return {"stick_slip",
          {{{"share", "", {0, 5}}},
           {{"bursts_per_min", "", {0.01, 600}}},
           {{"burst_s", "s", {0.001, 1000}}},
           {{"frequency_Hz", "Hz", {0.1, 1000}}}},
          {},
          make_part<StickSlip>};
}

}  // namespace host_sim::synth
