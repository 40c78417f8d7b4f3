#pragma once

#include <ostream>
#include <string_view>

#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose {

/// The diagnosis for people: the verdict; then for recordings and lives what was found with its
/// probability and intervals, what else it may be, what is invisible, the experiment to make next,
/// the gain and the cost in life; warnings last. Lines are safe on a terminal.
void write_summary(std::ostream& out, std::string_view campaign, const Diagnosis& diagnosis);

}  // namespace host_sim::diagnose
