#include "host_sim/synth/life/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Corrosion: a cycle at a later day does more damage, by exp(lambda t), in store and under test.
class Ageing final : public LifePart {
 public:
  explicit Ageing(const Values& values) : rate_1_day_(values["rate_1_day"]) {}

  [[nodiscard]] double ageing_1_day() const override { return rate_1_day_; }

 private:
  double rate_1_day_;
};

}  // namespace

LifeKind ageing() {
  return {"ageing", {{{"rate_1_day", "1_day", {0, 10}}}}, {}, make_life_part<Ageing>};
}

}  // namespace host_sim::synth
