#pragma once

#include "host_sim/model/model.hpp"
#include "host_sim/report/replay/plot_builders.hpp"
#include "host_sim/report/replay/report_data.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/counting/turning_points.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/units.hpp"

namespace host_sim {

/// Gathers the plots of the report while the samples go by, in bounded memory.
class Plots {
 public:
  /// @param class_N the narrowest classes of cycles, above 0
  Plots(const Model& model, const lifemodel::Parameters& parameters, double class_N);

  void sample(double time_s, lifemodel::Tension tension);
  /// Samples are missing before the next one.
  void gap() { envelope_.gap(); }
  /// Of a profile with output tension; those of the first minutes are taken.
  void loop(double time_s, double input_N, double output_N);
  /// A counted cycle; `count` is 1 or 0.5.
  void cycle(lifemodel::Tension from, lifemodel::Tension to, double count,
             lifemodel::CycleDamage damage);
  void damage(double time_s, double total) { trajectory_.push(time_s, total); }

  /// Puts the plots into the report.
  void finish(ReplayReport& report);

 private:
  [[nodiscard]] double newtons(lifemodel::Tension tension) const;

  double ultimate_tension_N_;
  lifemodel::TensionRange hysteresis_;
  lifemodel::TurningPoints filter_;  ///< the estimator's filter once more, for the times
  lifemodel::Tension candidate_;
  double candidate_s_ = 0;
  bool first_ = true;
  EnvelopeBuilder envelope_;
  TurningPointBuilder turning_points_;
  RangeMeanBuilder range_mean_;
  TrajectoryBuilder trajectory_;
  Loop loop_;
};

/// Hands counted cycles to the plots, where there are any.
struct CyclesToPlots {
  Plots* plots;
  void full(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage damage) const {
    hand(from, to, 1, damage);
  }
  void half(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage damage) const {
    hand(from, to, 0.5, damage);
  }
  void hand(lifemodel::Tension from, lifemodel::Tension to, double count,
            lifemodel::CycleDamage damage) const {
    if (plots != nullptr) {
      plots->cycle(from, to, count, damage);
    }
  }
};

}  // namespace host_sim
