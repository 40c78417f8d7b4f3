#pragma once

#include <string>
#include <string_view>

#include "host_sim/diagnose/diagnosis.hpp"

namespace blind {

/// The records keep their words even if those of the program change.
std::string_view verdict_word(host_sim::diagnose::Verdict verdict);

/// @throws std::runtime_error
host_sim::diagnose::Verdict verdict_named(const std::string& word);

}  // namespace blind
