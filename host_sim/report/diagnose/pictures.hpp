#pragma once

#include <string>

#include "host_sim/diagnose/diagnosis.hpp"

/// The sections of plots of each part as HTML with all texts escaped.
namespace host_sim::diagnose_page {

[[nodiscard]] std::string pictures(const diagnose::TensionDiagnosis& tension);
[[nodiscard]] std::string pictures(const diagnose::LifeDiagnosis& lives);

}  // namespace host_sim::diagnose_page
