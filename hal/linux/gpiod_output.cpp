#include "hal/linux/gpiod_output.hpp"

#include <exception>

#include "hal/digital.hpp"

namespace hal::linux_os {

static_assert(DigitalOut<GpioOutput>);

GpioOutputs::GpioOutputs(const std::string& chip, std::span<const LineSpec> lines)
    : request_(request_lines(chip, lines,
                             ::gpiod::line_settings()
                                 .set_direction(::gpiod::line::direction::OUTPUT)
                                 .set_output_value(::gpiod::line::value::INACTIVE),
                             offsets_)) {}

Error GpioOutputs::set(std::size_t i, bool asserted) {
  try {
    request_.set_value(offsets_[i],
                       asserted ? ::gpiod::line::value::ACTIVE : ::gpiod::line::value::INACTIVE);
    return Error::none;
  } catch (const std::exception&) {
    return Error::failed;
  }
}

}  // namespace hal::linux_os
