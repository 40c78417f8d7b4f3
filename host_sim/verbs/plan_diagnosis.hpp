#pragma once

#include <cstdint>
#include <string>

namespace host_sim {

struct PlanDiagnosisArguments {
  std::string plan;
  std::string json;
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// What a campaign of recordings could show and tell apart, before anyone runs it: the exit status.
int plan_for_diagnosis(const PlanDiagnosisArguments& arguments);

}  // namespace host_sim
