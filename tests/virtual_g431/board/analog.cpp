#include "tests/virtual_g431/board/analog.hpp"

#include <string>

namespace virtual_g431 {
namespace {

// OPAMPx_CSR
constexpr std::uint32_t kAmplifierOn = bit(0), kAmplifierLock = bit(31);
// ADC_ISR and ADC_IER
constexpr std::uint32_t kReady = bit(0), kInjectedEnd = bit(5), kInjectedSequence = bit(6);
// ADC_CR
constexpr std::uint32_t kEnable = bit(0), kInjectedStart = bit(3), kRegulator = bit(28);
constexpr std::uint32_t kDeepPowerDown = bit(29), kCalibrate = bit(31);
constexpr std::uint32_t kCommands = 0x3F | kCalibrate;
// Offsets
constexpr std::uint32_t kIsr = 0x00, kIer = 0x04, kCr = 0x08, kCfgr = 0x0C, kCfgr2 = 0x10,
                        kSmpr1 = 0x14;
constexpr std::uint32_t kSmpr2 = 0x18, kJsqr = 0x4C, kJdr = 0x80, kDifsel = 0xB0, kCommon = 0x300,
                        kCcr = 0x08;

std::string name_of(std::size_t which) {
  return "ADC" + std::to_string(which + 1);
}

}  // namespace

std::uint32_t Amplifiers::read(std::uint32_t offset) {
  if (offset > 8 || offset % 4 != 0) {
    rules_.broken("OPAMP: read of " + hex(offset));
    return 0;
  }
  return csr_[offset / 4];
}

void Amplifiers::write(std::uint32_t offset, std::uint32_t value) {
  if (offset > 8 || offset % 4 != 0) {
    rules_.broken("OPAMP: write of " + hex(offset));
    return;
  }
  std::uint32_t& csr = csr_[offset / 4];
  rules_.require((csr & kAmplifierLock) == 0, "OPAMP: written while locked");
  rules_.require((csr & kAmplifierOn) == 0 || (value | 0) == csr, "OPAMP: changed while it is on");
  if ((value & kAmplifierOn) != 0) {
    // VP_SEL VINP0, VM_SEL PGA, PGA_GAIN 16 with VINM0 (RM0440 25.5.1).
    rules_.require(
        field(value, 3, 2) == 0 && field(value, 6, 5) == 2 && field(value, 18, 14) == 0x0B,
        "OPAMP: not set as the board is wired");
  }
  csr = value;
}

void Converters::reset() {
  ++life_;
  converters_ = {};
  for (Converter& converter : converters_) {
    converter.cr = kDeepPowerDown;
    converter.registers[kCfgr / 4] = bit(31);
  }
  ccr_ = 0;
}

Ticks Converters::cycle() const {
  const std::uint32_t mode = field(ccr_, 17, 16);
  return clocks_.hclk() * (mode == 3 ? 4 : mode == 2 ? 2 : 1);
}

bool Converters::interrupt() const {
  for (const Converter& converter : converters_) {
    if ((converter.isr & converter.at(kIer)) != 0) {
      return true;
    }
  }
  return false;
}

std::uint32_t Converters::read(std::uint32_t offset) {
  if (offset == kCommon + kCcr) {
    return ccr_;
  }
  const std::size_t which = offset >> 8;
  const std::uint32_t place = offset & 0xFF;
  if (which > 1 || place >= 0xD0 || place % 4 != 0) {
    rules_.broken("ADC: read of " + hex(offset));
    return 0;
  }
  const Converter& converter = converters_[which];
  return place == kIsr ? converter.isr : place == kCr ? converter.cr : converter.at(place);
}

void Converters::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kCommon + kCcr) {
    for (const Converter& converter : converters_) {
      rules_.require((converter.cr & kCommands) == 0, "ADC: CCR written while a converter is on");
    }
    ccr_ = value;
    return;
  }
  const std::size_t which = offset >> 8;
  const std::uint32_t place = offset & 0xFF;
  if (which > 1 || place >= 0xD0 || place % 4 != 0) {
    rules_.broken("ADC: write of " + hex(offset));
    return;
  }
  Converter& converter = converters_[which];
  const bool armed = (converter.cr & kInjectedStart) != 0;
  switch (place) {
    case kIsr:
      converter.isr &= ~value;
      return;
    case kCr:
      return write_cr(which, value);
    case kIer:
    case kCfgr:
    case kCfgr2:
    case kSmpr1:
    case kSmpr2:
    case kJsqr:
    case kDifsel:
      // Silicon ignores the write (RM0440 21.6: "only when JADSTART = 0").
      rules_.require(!armed, name_of(which) + ": " + hex(place) + " written while JADSTART = 1");
      if (!armed) {
        converter.registers[place / 4] = value;
      }
      return;
    default:
      rules_.broken(name_of(which) + ": write of " + hex(place));
  }
}

/// RM0440 21.4.6 regulator, 21.4.8 calibration, 21.4.9 enabling, 21.6.3.
void Converters::write_cr(std::size_t which, std::uint32_t value) {
  Converter& converter = converters_[which];
  const std::string name = name_of(which);
  const Ticks now = agenda_.now();
  const std::uint32_t set = value & ~converter.cr;
  rules_.require(
      (value & ~(kEnable | kInjectedStart | kRegulator | kDeepPowerDown | kCalibrate)) == 0,
      name + ": CR with " + hex(value));
  if (((converter.cr ^ value) & (kRegulator | kDeepPowerDown)) != 0) {
    rules_.require((converter.cr & kCommands) == 0,
                   name + ": regulator changed while the converter is on");
  }
  if ((set & kRegulator) != 0) {
    rules_.require((converter.cr & kDeepPowerDown) == 0,
                   name + ": regulator on in deep power down");
    converter.regulated_at = now + 20 * kMicrosecond;  // DS12589, t_ADCVREG_SETUP
  }
  const bool regulated = (converter.cr & kRegulator) != 0 && now >= converter.regulated_at;
  const auto life = life_;
  if ((set & kCalibrate) != 0) {
    rules_.require(regulated, name + ": calibrated before the regulator is up");
    rules_.require((converter.cr & kCommands) == 0, name + ": calibrated while it is on");
    rules_.require(field(ccr_, 17, 16) != 0, name + ": without a clock");
    converter.calibrated_at = kNever;
    agenda_.in(116 * cycle(), [this, which, life] {
      if (life == life_ && !broken) {
        converters_[which].cr &= ~kCalibrate;
        converters_[which].calibrated_at = agenda_.now() + 4 * cycle();
      }
    });
  }
  if ((set & kEnable) != 0) {
    rules_.require(regulated && (converter.cr & kCommands) == 0,
                   name + ": enabled while it is not ready for that");
    rules_.require(now >= converter.calibrated_at,
                   name + ": enabled within 4 cycles of the calibration");
    agenda_.in(kMicrosecond, [this, which, life] {
      converters_[which].isr |= life == life_ && !broken ? kReady : 0;
    });
  }
  if ((set & kInjectedStart) != 0) {
    rules_.require((converter.cr & kEnable) != 0 && (converter.isr & kReady) != 0,
                   name + ": started before it is ready");
    rules_.require(field(converter.at(kJsqr), 6, 2) == 8 && field(converter.at(kJsqr), 8, 7) == 1,
                   name + ": not triggered by the rising edge of TRGO2 of TIM1");
    rules_.require((converter.at(kCfgr) & bit(31)) != 0,
                   name + ": with the queue, which is not modelled");
    converter.since_start = 0;
  }
  converter.cr = (converter.cr & kCommands) | value;
}

std::uint32_t Converters::input(std::size_t which, std::uint32_t channel) {
  // Inside the device: OPAMP1 on ADC1 13, OPAMP2 on ADC2 16, OPAMP3 on ADC2 18 (RM0440 21.4.11).
  const std::size_t phase = which == 0 && channel == 13   ? 0
                            : which == 1 && channel == 16 ? 1
                            : which == 1 && channel == 18 ? 2
                                                          : 3;
  if (phase == 3 || !amplifiers_.connected(phase)) {
    rules_.broken(name_of(which) + ": converts channel " + std::to_string(channel) +
                  ", to which no amplifier is connected");
    return 0;
  }
  return counts_[phase];
}

void Converters::trigger() {
  bool armed = false;
  for (const Converter& converter : converters_) {
    armed = armed || (converter.cr & kInjectedStart) != 0;
  }
  if (!armed) {
    return;
  }
  counts_ = signal(agenda_.now());
  ++conversions_;
  for (std::size_t which = 0; which < 2; ++which) {
    Converter& converter = converters_[which];
    if ((converter.cr & kInjectedStart) == 0) {
      continue;
    }
    if (converter.converting != 0) {
      ++collisions_;
      continue;
    }
    converter.converting = field(converter.at(kJsqr), 1, 0) + 1;
    convert(which, 1);
  }
}

void Converters::convert(std::size_t which, std::uint32_t rank) {
  Converter& converter = converters_[which];
  const std::uint32_t channel = field(converter.at(kJsqr), 13 + 6 * (rank - 1), 9 + 6 * (rank - 1));
  constexpr std::array<std::uint32_t, 8> kHalfCycles{5, 13, 25, 49, 95, 185, 495, 1281};
  const std::uint32_t sampling =
      channel < 10 ? field(converter.at(kSmpr1), 3 * channel + 2, 3 * channel)
                   : field(converter.at(kSmpr2), 3 * channel - 28, 3 * channel - 30);
  const Ticks span = (kHalfCycles[sampling] + 25) * cycle() / 2;
  const std::uint32_t value = input(which, channel);
  agenda_.in(span, [this, which, rank, value, life = life_] {
    Converter& done = converters_[which];
    if (life != life_ || broken) {
      return;
    }
    const bool wrong = done.since_start < wrong_first_conversions;
    done.registers[kJdr / 4 + rank - 1] = wrong ? 0 : value;
    done.isr |= kInjectedEnd;
    if (--done.converting == 0) {
      ++done.since_start;
      done.isr |= kInjectedSequence;
    } else {
      convert(which, rank + 1);
    }
  });
}

}  // namespace virtual_g431
