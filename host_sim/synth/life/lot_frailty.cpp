#include <cmath>

#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/life/kinds.hpp"
#include "host_sim/synth/streams.hpp"

namespace host_sim::synth {
namespace {

/// Each lot lives longer or shorter by a lognormal factor.
class LotFrailty final : public LifePart {
 public:
  explicit LotFrailty(const Values& values) : log_sd_(values["log_sd"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    statistics::Random random(seed, kLotStream, place.lot);
    factor_ = std::exp(log_sd_ * normal(random));
  }

  [[nodiscard]] double life_factor() const override { return factor_; }

 private:
  double log_sd_;
  double factor_ = 1;
};

}  // namespace

LifeKind lot_frailty() {
  return {"lot_frailty", {{{"log_sd", "", {0, 1}}}}, {}, make_life_part<LotFrailty>};
}

}  // namespace host_sim::synth
