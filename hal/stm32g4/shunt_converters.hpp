#pragma once

#include <array>
#include <cstdint>

#include "hal/error.hpp"
#include "hal/stm32g4/microsecond_clock.hpp"
#include "hal/stm32g4/registers/adc.hpp"
#include "hal/stm32g4/registers/opamp.hpp"

namespace hal::stm32g4 {

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

}  // namespace hal::stm32g4
