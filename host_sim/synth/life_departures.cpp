#include "host_sim/synth/life_departures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include "host_sim/synth/draws.hpp"

namespace host_sim::synth {
namespace {

enum class MeanStressLaw { walker, goodman, smith_watson_topper };
constexpr std::array<std::string_view, 3> kMeanStressLaws{"walker", "goodman", "swt"};

/// The law of this name. @pre there is one
MeanStressLaw mean_stress_law(std::string_view name) {
  return static_cast<MeanStressLaw>(std::ranges::find(kMeanStressLaws, name) -
                                    kMeanStressLaws.begin());
}

/// The true law of mean stress in place of Gerber's.
class MeanStress final : public LifePart {
 public:
  explicit MeanStress(const Values& values)
      : law_(mean_stress_law(values.choice("law"))), walker_exponent_(values["walker_exponent"]) {}

  /// Goodman: T_a / (1 - T_m / T_u). Smith, Watson and Topper: sqrt(T_max T_a). Walker:
  /// T_max^(1 - w) T_a^w. Reference: Dowling, Mean stress effects in stress-life and strain-life
  /// fatigue, SAE 2004-01-2227.
  [[nodiscard]] double effective_tension_N(double /*effective_N*/, reference::MeanAmplitude input,
                                           double ultimate_tension_N) const override {
    if (law_ == MeanStressLaw::goodman) {
      const double left = 1 - input.mean_N / ultimate_tension_N;
      return left > 0 ? input.amplitude_N / left : std::numeric_limits<double>::infinity();
    }
    const double exponent = law_ == MeanStressLaw::walker ? walker_exponent_ : 0.5;
    const double maximum_N = input.mean_N + input.amplitude_N;
    return std::pow(maximum_N, 1 - exponent) * std::pow(input.amplitude_N, exponent);
  }

 private:
  MeanStressLaw law_;
  double walker_exponent_;
};

LifeKind mean_stress() {
  return {"mean_stress",
          {{{"walker_exponent", "", {0, 1}}, 0.65}},
          {{"law", {kMeanStressLaws.begin(), kMeanStressLaws.end()}}},
          make_life_part<MeanStress>};
}

/// The wire also bends round the sheath: its bending stress c E d / D, from 0 and back once a
/// cycle, acts on the metal of the cable as a tension.
class BendingFatigue final : public LifePart {
 public:
  explicit BendingFatigue(const Values& values)
      : modulus_N_mm2_(values["modulus_GPa"] * 1e3),
        area_mm2_(values["metal_area_mm2"]),
        share_(values["share"]) {}

  [[nodiscard]] reference::MeanAmplitude input_N(reference::MeanAmplitude input,
                                                 const LifeLoad& load) const override {
    const double bending_N = share_ * modulus_N_mm2_ * area_mm2_ * load.wire_to_bend_ratio;
    return {input.mean_N + bending_N / 2, input.amplitude_N + bending_N / 2};
  }

 private:
  double modulus_N_mm2_, area_mm2_, share_;
};

LifeKind bending_fatigue() {
  return {"bending_fatigue",
          {{{"modulus_GPa", "GPa", {1, 1000}}, 190},
           {{"metal_area_mm2", "mm2", {1e-4, 100}}},
           {{"share", "", {0, 1}}}},
          {},
          make_life_part<BendingFatigue>};
}

/// Life A / (T - S_e)^gamma, without end at S_e and below. Each specimen has its own limit,
/// lognormal about the median, or all have the same. Reference for the random limit: Pascual and
/// Meeker, Estimating fatigue curves with the random fatigue-limit model, Technometrics 41, 1999.
class EnduranceLimit final : public LifePart {
 public:
  explicit EnduranceLimit(const Values& values)
      : median_N_(values["limit_N"]), log_sd_(values["log_sd"]), limit_N_(median_N_) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    Random random(seed, kEnduranceStream, place.number);
    limit_N_ = median_N_ * std::exp(log_sd_ * normal(random));
  }

  [[nodiscard]] double damaging_tension_N(double effective_N) const override {
    return effective_N - limit_N_;
  }

 private:
  double median_N_, log_sd_, limit_N_;
};

LifeKind endurance_limit() {
  return {"endurance_limit",
          {{{"limit_N", "N", {0, 1e6}}}, {{"log_sd", "", {0, 1}}, 0}},
          {},
          make_life_part<EnduranceLimit>};
}

/// Damage curve of Manson and Halford: a share f of the life N_1 counts as the share
/// f^((N_1 / N_2)^q) of the life N_2. Reference: Manson and Halford, Practical implementation of
/// the double linear damage rule and damage curve approach, Int. J. Fracture 17, 1981.
class LoadSequence final : public LifePart {
 public:
  explicit LoadSequence(const Values& values) : exponent_(values["exponent"]) {}

  [[nodiscard]] double sequence_exponent() const override { return exponent_; }

 private:
  double exponent_;
};

LifeKind load_sequence() {
  return {"load_sequence", {{{"exponent", "", {-1, 1}}, 0.4}}, {}, make_life_part<LoadSequence>};
}

/// A second mode of failure with a law of its own; a specimen fails by the one that comes first.
class SecondMode final : public LifePart {
 public:
  explicit SecondMode(const Values& values)
      : scale_cycles_(values["life_cycles"]),
        reference_N_(values["reference_N"]),
        exponent_(values["exponent"]),
        shape_(values["shape"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    Random random(seed, kSecondModeStream, place.number);
    strength_ = std::pow(exponential(random), 1 / shape_);
  }

  [[nodiscard]] double other_life_cycles(double effective_N) const override {
    return scale_cycles_ * std::pow(effective_N / reference_N_, -exponent_) * strength_;
  }

 private:
  double scale_cycles_, reference_N_, exponent_, shape_;
  double strength_ = 1;
};

LifeKind second_mode() {
  return {"second_mode",
          {{{"life_cycles", "cycles", {1, 1e12}}},
           {{"reference_N", "N", {0.001, 1e6}}},
           {{"exponent", "", {0, 30}}},
           {{"shape", "", {0.3, 50}}}},
          {},
          make_life_part<SecondMode>};
}

/// Each lot lives longer or shorter by a lognormal factor.
class LotFrailty final : public LifePart {
 public:
  explicit LotFrailty(const Values& values) : log_sd_(values["log_sd"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    Random random(seed, kLotStream, place.lot);
    factor_ = std::exp(log_sd_ * normal(random));
  }

  [[nodiscard]] double life_factor() const override { return factor_; }

 private:
  double log_sd_;
  double factor_ = 1;
};

LifeKind lot_frailty() {
  return {"lot_frailty", {{{"log_sd", "", {0, 3}}}}, {}, make_life_part<LotFrailty>};
}

/// Corrosion: a cycle at a later day does more damage, by exp(lambda t), in store and under test.
class Ageing final : public LifePart {
 public:
  explicit Ageing(const Values& values) : rate_1_day_(values["rate_1_day"]) {}

  [[nodiscard]] double ageing_1_day() const override { return rate_1_day_; }

 private:
  double rate_1_day_;
};

LifeKind ageing() {
  return {"ageing", {{{"rate_1_day", "1_day", {0, 10}}}}, {}, make_life_part<Ageing>};
}

/// Every second rig loads its specimens by more than it says.
class RigBias final : public LifePart {
 public:
  explicit RigBias(const Values& values) : share_(values["share"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t /*seed*/) override {
    factor_ = place.rig % 2 == 1 ? 1 + share_ : 1;
  }

  [[nodiscard]] reference::MeanAmplitude output_N(reference::MeanAmplitude output) const override {
    return {output.mean_N * factor_, output.amplitude_N * factor_};
  }

 private:
  double share_;
  double factor_ = 1;
};

LifeKind rig_bias() {
  return {"rig_bias", {{{"share", "", {-0.5, 0.5}}}}, {}, make_life_part<RigBias>};
}

/// A share of the specimens was nicked when it was put in and lives only a part of its life.
class EarlyDeaths final : public LifePart {
 public:
  explicit EarlyDeaths(const Values& values)
      : share_(values["share"]), life_left_(values["life_left"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    factor_ = Random(seed, kEarlyDeathStream, place.number).uniform() < share_ ? life_left_ : 1;
  }

  [[nodiscard]] double life_factor() const override { return factor_; }

 private:
  double share_, life_left_;
  double factor_ = 1;
};

LifeKind early_deaths() {
  return {"early_deaths",
          {{{"share", "", {0, 1}}}, {{"life_left", "", {0.001, 1}}}},
          {},
          make_life_part<EarlyDeaths>};
}

}  // namespace

std::span<const LifeKind> life_kinds() {
  static const std::vector<LifeKind> kinds{mean_stress(),   bending_fatigue(), endurance_limit(),
                                           load_sequence(), second_mode(),     lot_frailty(),
                                           ageing()};
  return kinds;
}

std::span<const LifeKind> outside_life_kinds() {
  static const std::vector<LifeKind> kinds{rig_bias(), early_deaths()};
  return kinds;
}

}  // namespace host_sim::synth
