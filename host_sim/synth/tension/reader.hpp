#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace host_sim::synth {

/// One end of the sheath, read at instants of its own; between those of the simulation it lies on a
/// line.
class Reader {
 public:
  Reader(const std::vector<double>& offsets_s, double rate_Hz, std::vector<double>& readings)
      : offsets_s_(offsets_s), rate_Hz_(rate_Hz), readings_(readings) {}

  /// The simulation has got to a time.
  void pass(double time_s, double value) {
    for (double at_s = next_s(); at_s <= time_s; at_s = next_s()) {
      const double back = time_s > last_s_ ? (time_s - at_s) / (time_s - last_s_) : 0;
      readings_.push_back(value - (value - last_) * back);
    }
    last_s_ = time_s;
    last_ = value;
  }

 private:
  [[nodiscard]] double next_s() const {
    const std::size_t i = readings_.size();
    const double offset_s = offsets_s_.empty()      ? 0
                            : i < offsets_s_.size() ? offsets_s_[i]
                                                    : std::numeric_limits<double>::infinity();
    return std::max(0.0, static_cast<double>(i) / rate_Hz_ + offset_s);
  }

  const std::vector<double>& offsets_s_;
  double rate_Hz_;
  std::vector<double>& readings_;
  double last_s_ = 0;
  double last_ = 0;
};

}  // namespace host_sim::synth
