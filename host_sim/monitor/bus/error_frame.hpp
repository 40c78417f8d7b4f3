#pragma once

#include "hal/can_frame.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// What an error frame says (linux/can/error.h): its id without the flag is the class, its data say
/// more.
BusError bus_error_of(const hal::CanFrame& frame);

}  // namespace host_sim::monitor
