#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// A drive that reads input tension and current more seldom than the recorder writes; between
/// its readings the recorder draws a line, or repeats the last one.
class Undersampling final : public TensionPart {
 public:
  explicit Undersampling(const Values& values)
      : rate_Hz_(values["rate_Hz"]), hold_(values.word("between") == "hold") {}

  void record(Sensor sensor, std::vector<double>& readings, double sample_rate_Hz) const override {
    if (sensor == Sensor::output_tension || rate_Hz_ >= sample_rate_Hz) {
      return;
    }
    const std::vector<double> all = readings;
    const double step = sample_rate_Hz / rate_Hz_;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      const double device = std::floor(static_cast<double>(i) / step + 1e-9);
      const double from = at(all, device * step);
      const double next = (device + 1) * step;
      const double to = next < static_cast<double>(all.size()) ? at(all, next) : from;
      const double share = static_cast<double>(i) / step - device;
      readings[i] = hold_ ? from : from + (to - from) * share;
    }
  }

 private:
  static double at(const std::vector<double>& values, double place) {
    const double last = static_cast<double>(values.size() - 1);
    const double inside = place < last ? place : last;
    const auto before = static_cast<std::size_t>(inside);
    const double share = inside - static_cast<double>(before);
    return share > 0 ? values[before] + (values[before + 1] - values[before]) * share
                     : values[before];
  }

  double rate_Hz_;
  bool hold_;
};

}  // namespace

TensionKind undersampling() {
  return {"undersampling",
          {{{"rate_Hz", "Hz", {0.1, 1e5}}}},
          {{"between", {"line", "hold"}}},
          make_part<Undersampling>};
}

}  // namespace host_sim::synth
