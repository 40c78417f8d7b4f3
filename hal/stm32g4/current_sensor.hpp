#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/error.hpp"
#include "hal/stm32g4/register.hpp"
#include "hal/stm32g4/timers.hpp"
#include "lifemodel/quantity/units.hpp"

namespace hal::stm32g4 {

/// Operational amplifiers of category 2 devices, RM0440 25.5. The file has places for six.
template <Word W>
struct OpampRegisters {
  W csr[6];
  W tcmr[6];
};
static_assert(offsetof(OpampRegisters<Register>, tcmr) == 0x18);

namespace opamp {
// CSR, 25.5.1
inline constexpr std::uint32_t kEnable = bit(0), kInput0 = 0u << 2;
inline constexpr std::uint32_t kProgrammableGain = 2u << 5, kHighSpeed = bit(7);
inline constexpr std::uint32_t kInternalOutput = bit(8);
/// Gain 16, with the low side of the shunt's divider on VINM0.
inline constexpr std::uint32_t kGain16BiasOnInput0 = 0x0Bu << 14;
}  // namespace opamp

/// One analog-to-digital converter, RM0440 21.6.
template <Word W>
struct AdcRegisters {
  W isr, ier, cr, cfgr, cfgr2;
  W smpr[2];
  W reserved_1c;
  W tr[3];
  W reserved_2c;
  W sqr[4];
  W dr;
  W reserved_44[2];
  W jsqr;
  W reserved_50[4];
  W ofr[4];
  W reserved_70[4];
  W jdr[4];
  W reserved_90[4];
  W awd2cr, awd3cr;
  W reserved_a8[2];
  W difsel, calfact;
};
static_assert(offsetof(AdcRegisters<Register>, cr) == 0x08);
static_assert(offsetof(AdcRegisters<Register>, smpr) == 0x14);
static_assert(offsetof(AdcRegisters<Register>, sqr) == 0x30);
static_assert(offsetof(AdcRegisters<Register>, jsqr) == 0x4C);
static_assert(offsetof(AdcRegisters<Register>, ofr) == 0x60);
static_assert(offsetof(AdcRegisters<Register>, jdr) == 0x80);
static_assert(offsetof(AdcRegisters<Register>, difsel) == 0xB0);

/// What ADC1 and ADC2 share, RM0440 21.7.
template <Word W>
struct AdcCommonRegisters {
  W csr;
  W reserved_04;
  W ccr, cdr;
};
static_assert(offsetof(AdcCommonRegisters<Register>, ccr) == 0x08);

namespace adc {
// ISR, 21.6.1
inline constexpr std::uint32_t kReady = bit(0), kInjectedEnd = bit(5), kInjectedSequence = bit(6);
// IER, 21.6.2
inline constexpr std::uint32_t kInjectedSequenceInterrupt = bit(6);
// CR, 21.6.3
inline constexpr std::uint32_t kEnable = bit(0), kInjectedStart = bit(3);
inline constexpr std::uint32_t kRegulator = bit(28), kDeepPowerDown = bit(29);
inline constexpr std::uint32_t kCalibrateDifferential = bit(30), kCalibrate = bit(31);
/// Bits that software can only set; writing them as read would start what is not meant.
inline constexpr std::uint32_t kSetOnly =
    bit(0) | bit(1) | bit(2) | bit(3) | bit(4) | bit(5) | bit(31);
// CFGR, 21.6.4
inline constexpr std::uint32_t kNoInjectedQueue = bit(31);
// SMPR2, 21.6.7: channels 10 .. 18; 24.5 cycles
constexpr std::uint32_t sample_24_5_cycles(unsigned channel) {
  return 3u << (3 * (channel - 10));
}
// JSQR, 21.6.16
constexpr std::uint32_t injected_length(std::uint32_t conversions) {
  return conversions - 1;
}
constexpr std::uint32_t injected_channel(unsigned rank, std::uint32_t channel) {
  return channel << (9 + 6 * (rank - 1));
}
inline constexpr std::uint32_t kTriggerTim1Trgo2 = 8u << 2, kRisingEdge = 1u << 7;
// CCR, 21.7.2
inline constexpr std::uint32_t kClockModeMask = 3u << 16, kHclkBy4 = 3u << 16;
}  // namespace adc

inline constexpr std::size_t kPhases = 3;

/// Counts of the three phases, 0 .. 4095 each.
using PhaseCounts = std::array<std::uint32_t, kPhases>;

/// The three shunt amplifiers, and ADC1 and ADC2 which convert their internal outputs at each
/// trigger of TIM1: OPAMP1 on ADC1 channel 13, OPAMP2 and OPAMP3 on ADC2 channels 16 and 18
/// (RM0440 21.4.11). ADC2 is the last to be ready.
template <Word W>
class ShuntConverters {
 public:
  ShuntConverters(OpampRegisters<W>& amplifiers, AdcRegisters<W>& adc1, AdcRegisters<W>& adc2,
                  AdcCommonRegisters<W>& common)
      : amplifiers_(amplifiers), adc1_(adc1), adc2_(adc2), common_(common) {}

  /// Brings all up, arms the trigger, which runs, and takes the first conversions away: they may be
  /// wrong, or of channel 0 (ES0431 2.5.7, 2.5.8). From then on ADC2 asks for its interrupt once
  /// all three are converted.
  Error start(const MicrosecondClock<W>& clock) {
    start_amplifiers();
    // While both converters are off (RM0440 21.7.2).
    replace_bits(common_.ccr, adc::kClockModeMask, adc::kHclkBy4);
    for (AdcRegisters<W>* converter : {&adc1_, &adc2_}) {
      if (power_up(*converter, clock) != Error::none) {
        return Error::failed;
      }
    }
    configure();
    // While no injected conversion may start (RM0440 21.6.2).
    adc2_.ier.write(adc::kInjectedSequenceInterrupt);
    command(adc1_, adc::kInjectedStart);
    command(adc2_, adc::kInjectedStart);
    if (wait_until(adc2_.isr, adc::kInjectedSequence, adc::kInjectedSequence, kTriggerPolls) !=
        Error::none) {
      return Error::failed;
    }
    (void)isr_take();
    return Error::none;
  }

  /// True once all three are converted, since the last isr_take().
  [[nodiscard]] bool isr_ready() const { return (adc2_.isr.read() & adc::kInjectedSequence) != 0; }
  PhaseCounts isr_take() {
    constexpr std::uint32_t kDone = adc::kInjectedEnd | adc::kInjectedSequence;
    const PhaseCounts counts{adc1_.jdr[0].read(), adc2_.jdr[0].read(), adc2_.jdr[1].read()};
    adc1_.isr.write(kDone);
    adc2_.isr.write(kDone);
    return counts;
  }

 private:
  static constexpr std::uint32_t kRegulatorStart_us = 20;  ///< DS12589, t_ADCVREG_SETUP
  static constexpr std::uint32_t kPolls = 100'000;
  /// Reads that take more than many periods of the trigger, and less than the watchdog allows.
  static constexpr std::uint32_t kTriggerPolls = 1'000'000;

  void start_amplifiers() {
    constexpr std::uint32_t kSetup = opamp::kInput0 | opamp::kProgrammableGain | opamp::kHighSpeed |
                                     opamp::kInternalOutput | opamp::kGain16BiasOnInput0;
    for (std::size_t i = 0; i < kPhases; ++i) {
      amplifiers_.csr[i].write(kSetup);
      amplifiers_.csr[i].write(kSetup | opamp::kEnable);
    }
  }

  static void command(AdcRegisters<W>& converter, std::uint32_t set) {
    converter.cr.write((converter.cr.read() & ~adc::kSetOnly) | set);
  }

  /// RM0440 21.4.6 regulator, 21.4.8 calibration, 21.4.9 enabling.
  static Error power_up(AdcRegisters<W>& converter, const MicrosecondClock<W>& clock) {
    converter.cr.write(0);
    converter.cr.write(adc::kRegulator);
    clock.wait_us(kRegulatorStart_us);
    command(converter, adc::kCalibrate);
    if (wait_until(converter.cr, adc::kCalibrate, 0, kPolls) != Error::none) {
      return Error::failed;
    }
    // The converter takes ADEN only four of its cycles after the calibration.
    clock.wait_us(1);
    converter.isr.write(adc::kReady);
    command(converter, adc::kEnable);
    return wait_until(converter.isr, adc::kReady, adc::kReady, kPolls);
  }

  void configure() {
    constexpr std::uint32_t kTrigger = adc::kTriggerTim1Trgo2 | adc::kRisingEdge;
    for (AdcRegisters<W>* converter : {&adc1_, &adc2_}) {
      converter->cfgr.write(adc::kNoInjectedQueue);
    }
    adc1_.smpr[1].write(adc::sample_24_5_cycles(13));
    adc2_.smpr[1].write(adc::sample_24_5_cycles(16) | adc::sample_24_5_cycles(18));
    adc1_.jsqr.write(adc::injected_length(1) | kTrigger | adc::injected_channel(1, 13));
    adc2_.jsqr.write(adc::injected_length(2) | kTrigger | adc::injected_channel(1, 16) |
                     adc::injected_channel(2, 18));
  }

  OpampRegisters<W>& amplifiers_;
  AdcRegisters<W>& adc1_;
  AdcRegisters<W>& adc2_;
  AdcCommonRegisters<W>& common_;
};

/// Largest integer whose square is at most `value`; 16 steps.
constexpr std::uint32_t square_root(std::uint32_t value) {
  std::uint32_t root = 0;
  for (std::uint32_t place = 1u << 30; place != 0; place >>= 2) {
    const std::uint32_t trial = root + place;
    root >>= 1;
    if (value >= trial) {
      value -= trial;
      root += place;
    }
  }
  return root;
}

/// Turns counts of three shunts into the amplitude of the motor current.
///
/// Three sinusoidal phase currents of amplitude I have i_u^2 + i_v^2 + i_w^2 = 3/2 I^2 at every
/// angle, so the amplitude needs no angle. It has no sign: a tendon only pulls.
class PhaseCurrent {
 public:
  /// 3.3 V / 4096 / (3 mohm * 64/7) of UM2516's amplifiers, as raw MotorCurrent: 29.4 mA.
  static constexpr std::uint32_t kRawPerCount = 492'800;
  /// Samples at rest for the zeros.
  static constexpr std::uint32_t kRestSamples = 256;
  /// A zero that is further from mid scale than this is a fault of the amplifier.
  static constexpr std::uint32_t kWidestZero = 512;
  /// A count within this of either end of the scale is clipped.
  static constexpr std::uint32_t kClipped = 8;
  /// The three currents add up to nothing, but for this: 4.7 A.
  static constexpr std::int32_t kLargestSum = 160;

  /// One of kRestSamples samples with the drive off.
  void take_rest(const PhaseCounts& counts) {
    for (std::size_t i = 0; i < kPhases; ++i) {
      zeros_[i] += counts[i];
    }
    ++rest_samples_;
  }
  /// After the last of them: failed, where an amplifier does not rest near mid scale.
  Error finish_rest() {
    known_ = false;
    for (const std::uint32_t zero : zeros_) {
      const std::uint32_t from = (2048 - kWidestZero) * kRestSamples;
      if (rest_samples_ != kRestSamples || zero < from ||
          zero - from > 2 * kWidestZero * kRestSamples) {
        return Error::failed;
      }
    }
    known_ = true;
    return Error::none;
  }

  /// failed: not calibrated, clipped, or the currents do not add up.
  [[nodiscard]] Result<lifemodel::MotorCurrent> isr_amplitude(const PhaseCounts& counts) const {
    std::int32_t sum = 0;
    std::uint32_t squares = 0;
    for (std::size_t i = 0; i < kPhases; ++i) {
      if (!known_ || counts[i] < kClipped || counts[i] > 4095 - kClipped) {
        return Error::failed;
      }
      // In eighths of a count: at most 2^15, so that three squares fit.
      const std::int32_t eighths =
          static_cast<std::int32_t>(counts[i] * 8) -
          static_cast<std::int32_t>((zeros_[i] + kRestSamples / 16) / (kRestSamples / 8));
      sum += eighths;
      squares += static_cast<std::uint32_t>(eighths * eighths);
    }
    if (sum > kLargestSum * 8 || sum < -kLargestSum * 8) {
      return Error::failed;
    }
    const std::uint32_t amplitude = square_root(squares / 3 * 2);
    constexpr std::uint32_t kHighest =
        static_cast<std::uint32_t>(lifemodel::kInt32Max) / (kRawPerCount / 8);
    if (amplitude > kHighest) {
      return Error::failed;
    }
    return lifemodel::MotorCurrent::from_raw(
        static_cast<std::int32_t>(amplitude * (kRawPerCount / 8)));
  }

 private:
  std::array<std::uint32_t, kPhases> zeros_{};  ///< sums over kRestSamples
  std::uint32_t rest_samples_ = 0;
  bool known_ = false;
};

/// hal::CurrentSensor of the one motor of the board.
template <Word W>
class CurrentSensor {
 public:
  using Sample = lifemodel::MotorCurrent;

  explicit CurrentSensor(ShuntConverters<W>& converters) : converters_(converters) {}

  /// Measures the zeros while the drive is off and nothing moves, before the interrupt is enabled.
  /// failed, where the trigger does not come or an amplifier is broken; every sample then fails.
  Error calibrate_at_rest() {
    for (std::uint32_t i = 0; i < PhaseCurrent::kRestSamples; ++i) {
      std::uint32_t polls = 0;
      while (!converters_.isr_ready()) {
        if (++polls == kPolls) {
          return Error::failed;
        }
      }
      current_.take_rest(converters_.isr_take());
    }
    return current_.finish_rest();
  }

  /// First in the interrupt: takes what the converters have, which ends their request.
  void isr_latch() {
    if (converters_.isr_ready()) {
      latched_ = converters_.isr_take();
    }
  }

  /// One tendon: out_of_range for others. missing, where nothing was latched since.
  [[nodiscard]] Result<Sample> isr_read(std::size_t tendon) {
    if (tendon != 0) {
      return Error::out_of_range;
    }
    if (!latched_) {
      return Error::missing;
    }
    const PhaseCounts counts = *latched_;
    latched_.reset();
    return current_.isr_amplitude(counts);
  }

 private:
  static constexpr std::uint32_t kPolls = 1'000'000;
  ShuntConverters<W>& converters_;
  PhaseCurrent current_;
  std::optional<PhaseCounts> latched_;
};

}  // namespace hal::stm32g4
