#pragma once

#include <string>

#include "host_sim/diagnose/diagnosis.hpp"

/// The first sentences of the page: plain text, not yet escaped.
namespace host_sim::diagnose_page {

/// The verdict in one sentence for each part.
[[nodiscard]] std::string verdict(const diagnose::Diagnosis& diagnosis);

/// What it was found from.
[[nodiscard]] std::string origin(const diagnose::Diagnosis& diagnosis);

}  // namespace host_sim::diagnose_page
