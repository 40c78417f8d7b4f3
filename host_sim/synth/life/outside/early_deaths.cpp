#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/life/kinds.hpp"
#include "host_sim/synth/streams.hpp"

namespace host_sim::synth {
namespace {

/// A share of the specimens was nicked when it was put in and lives only a part of its life.
class EarlyDeaths final : public LifePart {
 public:
  explicit EarlyDeaths(const Values& values)
      : share_(values["share"]), life_left_(values["life_left"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    factor_ = statistics::Random(seed, kEarlyDeathStream, place.number).uniform() < share_
                  ? life_left_
                  : 1;
  }

  [[nodiscard]] double life_factor() const override { return factor_; }

 private:
  double share_, life_left_;
  double factor_ = 1;
};

}  // namespace

LifeKind early_deaths() {
  return {"early_deaths",
          {{{"share", "", {0, 1}}}, {{"life_left", "", {0.001, 1}}}},
          {},
          make_life_part<EarlyDeaths>};
}

}  // namespace host_sim::synth
