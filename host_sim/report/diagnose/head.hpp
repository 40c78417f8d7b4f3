#pragma once

#include <string>

#include "host_sim/diagnose/diagnosis.hpp"

/// The head of the page.
namespace host_sim::diagnose_page {

/// The verdict in one sentence for each part: plain text, not yet escaped.
[[nodiscard]] std::string verdict(const diagnose::Diagnosis& diagnosis);

/// What it was found from: plain text, not yet escaped.
[[nodiscard]] std::string origin(const diagnose::Diagnosis& diagnosis);

/// The key numbers as HTML.
[[nodiscard]] std::string tiles(const diagnose::Diagnosis& diagnosis);

}  // namespace host_sim::diagnose_page
