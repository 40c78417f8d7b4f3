#pragma once

#include <string>

#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose_page {

/// The key numbers as HTML.
[[nodiscard]] std::string tiles(const diagnose::Diagnosis& diagnosis);

}  // namespace host_sim::diagnose_page
