#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/extension.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/input/capstan.hpp"

namespace lifemodel::extension {

/// Samples of one tendon to input tension by the extended model. Each sample takes bounded time;
/// belongs into the interrupt that takes it. Parameters and extension outlive this object.
class Corrector {
 public:
  /// The tendon has turned once it moves faster than this the other way: 1 mm/s.
  static constexpr Velocity kTurned = Velocity::from_raw(16777);

  Corrector(const Parameters& parameters, const Extension& extension)
      : parameters_(parameters), extension_(extension) {
    start_at(0);
  }

  /// The number of cycles that the sheath has seen, for its wear.
  void start_at(std::uint32_t cycles) {
    half_cycles_ = cycles < kMostHalfCycles / 2 ? 2 * cycles : kMostHalfCycles;
    wear_ = wear();
  }
  [[nodiscard]] std::uint32_t cycles() const { return half_cycles_ / 2; }

  /// A sample is missing, so that the next has no rate.
  void gap() { has_before_ = false; }

  /// T_in = K_t (1 - alpha (T_winding - T_ref)) (I - I_0 - b + a sin(k theta) + c cos(k theta))
  ///        N eta_g (1 + e s) / r_spool, without the lag of the current. Raises Flag::saturated
  /// where a quantity meets its bounds.
  /// @pre the parameters have a drive
  [[nodiscard]] Tension input_tension(const DriveSample& sample, Flags& flags) {
    if (extension_.has(Effect::gear_asymmetry)) {
      move(sample.at.velocity);
    }
    std::int64_t current = sample.current.raw();
    if (extension_.has(Effect::current_offset)) {
      current -= extension_.current_offset.offset;
    }
    if (extension_.has(Effect::torque_ripple)) {
      current += extension_.torque_ripple.added(sample.at.rotor);
    }
    Tension tension = parameters_.drive.tension(MotorCurrent::saturated(current, flags), flags);
    if (extension_.has(Effect::torque_gain)) {
      tension = times(tension, extension_.torque_gain.factor(sample.at.winding), flags);
    }
    if (extension_.has(Effect::gear_asymmetry)) {
      tension = times(tension, extension_.gear_asymmetry.factor(direction_), flags);
    }
    return extension_.has(Effect::input_lag) ? without_lag(tension, extension_.input_lag, flags)
                                             : tension;
  }

  /// T_in = T_out exp(mu phi s) + (F (1 + g(x)) + c |v|) s with mu and phi extended, T_out without
  /// its zero and its lag, s the slip where friction turns over along the way. Of a force the other
  /// way round, that of the other tendon of a pair, friction is in proportion to |T_out| and works
  /// against the motion too: T_out exp(-mu phi s). The empirical correction comes last.
  [[nodiscard]] Tension input_tension(const SheathSample& sample, Flags& flags) {
    move(sample.at.velocity);
    const Tension output = output_of(sample.tension, flags);
    const std::int32_t position = extension_.has(Effect::friction_position)
                                      ? extension_.friction_position.factor(sample.at.rotor)
                                      : kOne;
    const std::int32_t slip = this->slip();
    const std::int32_t exponent = exponent_of(output, slip, position, sample, flags);
    const Tension tension = times_exp2(output, exponent, flags);
    std::int64_t added = rounded(load_independent(position, sample.at) * slip, kFactorBits);
    if (extension_.has(Effect::empirical)) {
      added += extension_.empirical.added(covariate(output, sample.at), direction_);
    }
    return Tension::saturated(tension.raw() + added, flags);
  }

 private:
  static constexpr std::uint32_t kMostHalfCycles = 0xffffffffu;
  /// mu log2(e) is held in 0 .. 2 log2(e), Q28.
  static constexpr std::int32_t kMostFriction = 774541002;

  static Tension times(Tension tension, std::int32_t factor, Flags& flags) {
    return Tension::saturated(rounded(std::int64_t{tension.raw()} * factor, kFactorBits), flags);
  }

  void move(Velocity velocity) {
    if (velocity.raw() != 0) {
      const Direction direction = velocity.raw() > 0 ? Direction::pulling : Direction::releasing;
      if (direction != direction_) {
        direction_ = direction;
        travel_ = 0;
        slip_at_turn_ = slip_;
      }
    }
    constexpr std::int64_t kMostTravel = std::int64_t{1} << 62;
    travel_ =
        std::min(travel_ + (velocity.raw() < 0 ? -velocity.raw() : velocity.raw()), kMostTravel);
    const bool turned = pulled_ ? velocity.raw() < -kTurned.raw() : velocity.raw() > kTurned.raw();
    if (turned) {
      pulled_ = !pulled_;
      half_cycles_ += half_cycles_ < kMostHalfCycles ? 1 : 0;
      wear_ = wear();
    }
  }

  /// The direction of friction or, where it turns over along the way, its slip; Q28, -1 .. 1.
  std::int32_t slip() {
    const std::int32_t side = direction_ == Direction::pulling ? kOne : -kOne;
    if (!extension_.has(Effect::presliding)) {
      return side;
    }
    const std::int64_t left = extension_.presliding.left(travel_);
    const std::int64_t short_of = rounded((slip_at_turn_ - side) * left, kFactorBits);
    slip_ = side + static_cast<std::int32_t>(short_of);
    return side +
           static_cast<std::int32_t>(rounded(short_of * extension_.presliding.share, kFactorBits));
  }

  /// Without its zero and its lag.
  [[nodiscard]] Tension output_of(Tension measured, Flags& flags) {
    const Tension output =
        extension_.has(Effect::load_cell_zero)
            ? Tension::saturated(std::int64_t{measured.raw()} - extension_.load_cell_zero.zero,
                                 flags)
            : measured;
    return extension_.has(Effect::output_lag) ? without_lag(output, extension_.output_lag, flags)
                                              : output;
  }

  /// F (1 + g(x)) + c |v|, Q29; at most 16 times the ultimate tension.
  [[nodiscard]] std::int64_t load_independent(std::int32_t position, const Covariates& at) const {
    constexpr std::int64_t kMost = std::int64_t{1} << 33;
    std::int64_t force = 0;
    if (extension_.has(Effect::friction_preload)) {
      force += rounded(std::int64_t{extension_.friction_preload.force} * position, kFactorBits);
    }
    if (extension_.has(Effect::viscous_force)) {
      force += std::min(extension_.viscous_force.size(at.velocity), kMost);
    }
    return std::min(force, kMost);
  }

  /// What the empirical correction is written over, with its fractional bits.
  [[nodiscard]] std::int32_t covariate(Tension output, const Covariates& at) const {
    constexpr int kTurns = RotorAngle::kFractionBits - Empirical::kPositionBits;
    switch (extension_.empirical.covariate) {
      case Empirical::position:
        return held(rounded(at.rotor.raw, kTurns), -kInt32Max, kInt32Max);
      case Empirical::speed:
        return at.velocity.raw() < 0 ? -at.velocity.raw() : at.velocity.raw();
      case Empirical::travel:
        return held(rounded(travel_, Empirical::kTravelDrop), 0, kInt32Max);
      default:
        return output.raw() < 0 ? -output.raw() : output.raw();
    }
  }

  [[nodiscard]] std::int32_t wear() const {
    return extension_.has(Effect::friction_wear) ? extension_.friction_wear.factor(half_cycles_)
                                                 : kOne;
  }

  Tension without_lag(Tension now, const FilterLag& lag, Flags& flags) {
    const Tension before = has_before_ ? before_ : now;
    before_ = now;
    has_before_ = true;
    return lag.undone(before, now, flags);
  }

  /// Held so that 63 bits hold the next product, Q28.
  static std::int64_t product(std::int64_t friction, std::int32_t factor) {
    constexpr std::int64_t kMost = std::int64_t{1} << 32;
    return std::min(rounded(friction * factor, kFactorBits), kMost);
  }

  /// mu log2(e), Q28.
  [[nodiscard]] std::int32_t friction(const Covariates& at, std::int32_t position,
                                      Flags& flags) const {
    constexpr int kDrop = FrictionExponent::kFractionBits - kFactorBits;
    std::int64_t friction =
        rounded(std::int64_t{parameters_.capstan.friction.raw()} * wear_, kFactorBits + kDrop);
    if (extension_.has(Effect::friction_temperature)) {
      friction = product(friction, extension_.friction_temperature.factor(at.sheath));
    }
    if (extension_.has(Effect::friction_position)) {
      friction = product(friction, position);
    }
    if (extension_.has(Effect::friction_velocity)) {
      friction += extension_.friction_velocity.added(at.velocity);
    }
    if (friction < 0 || friction > kMostFriction) {
      flags.raise(Flag::saturated);
    }
    return held(friction, 0, kMostFriction);
  }

  /// log2(T_in/T_out) of the sheath, Q21.
  [[nodiscard]] std::int32_t exponent_of(Tension output, std::int32_t slip, std::int32_t position,
                                         const SheathSample& sample, Flags& flags) const {
    const Angle bend = extension_.has(Effect::bend_angle)
                           ? extension_.bend_angle.corrected(sample.bend)
                           : sample.bend;
    const std::int64_t magnitude =
        rounded(std::int64_t{friction(sample.at, position, flags)} * bend.raw(),
                kFactorBits + Angle::kFractionBits - kExponentBits);
    const bool other_way = output.raw() < 0;
    const std::int64_t plain = rounded(magnitude * (other_way ? -slip : slip), kFactorBits);
    const Tension size = Tension::from_raw(other_way ? -output.raw() : output.raw());
    const std::int64_t loaded = extension_.has(Effect::friction_load)
                                    ? extension_.friction_load.log2_ratio(plain, size, flags)
                                    : plain;
    // Beyond 2^44 every tension has saturated.
    constexpr std::int32_t kMost = 44 << kExponentBits;
    return held(loaded, -kMost, kMost);
  }

  const Parameters& parameters_;
  const Extension& extension_;
  Direction direction_ = Direction::pulling;
  bool pulled_ = true;
  bool has_before_ = false;
  std::uint32_t half_cycles_ = 0;
  std::int32_t wear_ = kOne;
  Tension before_;
  std::int64_t travel_ = 0;  ///< since the motion turned: a sum of velocities Q24 over samples
  std::int32_t slip_ = 0;    ///< Q28, as if the share of presliding were 1
  std::int32_t slip_at_turn_ = 0;
};

}  // namespace lifemodel::extension
