#pragma once

#include <string>

#include "host_sim/recording/fault_rules.hpp"
#include "host_sim/recording/recording.hpp"

namespace host_sim::recording {

/// Where a fault is, what it is and what is done about it, in a sentence.
std::string gap_words(const Recording& recording, const Stretch& gap);
std::string constant_words(const Recording& recording, ProfileColumnId channel);
std::string stuck_words(const Recording& recording, const LiveChannel& channel,
                        const Stretch& stretch);
std::string saturated_words(const Recording& recording, const LiveChannel& channel,
                            const Stretch& stretch);
std::string not_positive_words(const Recording& recording, const LiveChannel& channel,
                               const Stretch& stretch);

}  // namespace host_sim::recording
