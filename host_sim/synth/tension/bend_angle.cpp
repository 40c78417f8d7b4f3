#include <numbers>

#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/streams.hpp"
#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Each pose of the plan bends the sheath by more or less than it is taken for: by the numbers
/// given, in turn, and by one that is drawn.
class BendAngle final : public TensionPart {
 public:
  explicit BendAngle(const Values& values)
      : errors_deg_(values.list("error_deg")), sd_deg_(values["sd_deg"]) {}

  void begin(const Setting& setting, std::uint64_t seed) override {
    statistics::Random random(seed, kPoseStream, setting.pose);
    const double error_deg =
        errors_deg_[setting.pose % errors_deg_.size()] + sd_deg_ * normal(random);
    error_rad_ = error_deg * std::numbers::pi / 180;
  }

  [[nodiscard]] double bend_angle_rad(double angle_rad, const Moment& /*moment*/) const override {
    return angle_rad + error_rad_;
  }

 private:
  std::vector<double> errors_deg_;
  double sd_deg_;
  double error_rad_ = 0;
};

}  // namespace

TensionKind bend_angle() {
  return {"bend_angle",
          {{{"error_deg", "deg", {-90, 90}}, 0, true}, {{"sd_deg", "deg", {0, 60}}, 0}},
          {},
          make_part<BendAngle>};
}

}  // namespace host_sim::synth
