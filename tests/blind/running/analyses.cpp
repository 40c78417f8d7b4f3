#include "tests/blind/running/analyses.hpp"

#include "host_sim/campaign/campaign.hpp"

namespace blind {
namespace {

using host_sim::diagnose::DiagnoseOptions;
using host_sim::diagnose::Diagnosis;
using host_sim::diagnose::Findings;

Diagnosis diagnosis_of(const std::filesystem::path& folder, const DiagnoseOptions& options) {
  return host_sim::diagnose::diagnose(host_sim::read_campaign(folder), options);
}

}  // namespace

Analysis analysis_of_recordings() {
  return [](const std::filesystem::path& folder, const DiagnoseOptions& options) -> Findings {
    return diagnosis_of(folder, options).tension.value().findings;
  };
}

Analysis analysis_of_lives() {
  return [](const std::filesystem::path& folder, const DiagnoseOptions& options) -> Findings {
    return diagnosis_of(folder, options).lives.value().findings;
  };
}

}  // namespace blind
