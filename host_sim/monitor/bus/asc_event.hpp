#pragma once

#include <optional>

#include "host_sim/monitor/bus/asc_words.hpp"
#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// What the words of an ASC line after its time tell, without a time; nothing where it is an event
/// of another kind. `base` is that of identifiers and data, 10 or 16.
/// @throws InputError
std::optional<SeenFrame> asc_event(AscWords& words, int base);

}  // namespace host_sim::monitor
