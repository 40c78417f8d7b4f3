#pragma once

#include <string>
#include <string_view>

#include "host_sim/diagnose/diagnosis.hpp"

/// What to see in each plot: plain text, not yet escaped.
namespace host_sim::diagnose_page::captions {

[[nodiscard]] std::string traces(const diagnose::TensionDiagnosis& tension);
[[nodiscard]] std::string trace(const diagnose::TensionDiagnosis& tension, std::size_t index);
[[nodiscard]] std::string loop(const diagnose::TensionDiagnosis& tension, std::size_t index);
[[nodiscard]] std::string causes();
[[nodiscard]] std::string cause(const diagnose::TensionDiagnosis& tension, std::size_t index);
[[nodiscard]] std::string remainders();
[[nodiscard]] std::string remainder(const diagnose::TensionDiagnosis& tension, std::size_t index);
[[nodiscard]] std::string sessions();
[[nodiscard]] std::string weibull(const diagnose::LifeDiagnosis& lives);
[[nodiscard]] std::string ratio_before();
[[nodiscard]] std::string ratio_after();
[[nodiscard]] std::string ranking(const diagnose::Findings& findings);
[[nodiscard]] std::string discrepancies();
[[nodiscard]] std::string steps(const diagnose::Findings& findings);
[[nodiscard]] std::string steps_chart();
[[nodiscard]] std::string gain_chart();
[[nodiscard]] std::string gain(const diagnose::HeldOutGain& gain);

}  // namespace host_sim::diagnose_page::captions
