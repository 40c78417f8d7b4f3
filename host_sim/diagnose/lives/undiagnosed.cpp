#include "host_sim/diagnose/lives/undiagnosed.hpp"

#include <fmt/format.h>

#include "host_sim/effects/life_effect.hpp"

namespace host_sim::diagnose::lives {

std::string hindrance(const LifeSample& sample, const NominalFit& nominal) {
  constexpr std::size_t kLeastToJudge = 6;
  if (sample.failures() < kLeastToJudge) {
    return fmt::format("{} of {} specimens failed; {} failures are the least to judge a law by",
                       sample.failures(), sample.size(), kLeastToJudge);
  }
  if (sample.levels < 2) {
    return "all specimens were tested at one effective tension, which says nothing of gamma; test "
           "at three levels or more";
  }
  switch (nominal.problem) {
    case statistics::FitProblem::none:
      return "";
    case statistics::FitProblem::too_few_failures:
      return "fewer than two specimens failed";
    case statistics::FitProblem::no_spread:
      return "all failures lie on the law without any scatter, which no lives do";
    case statistics::FitProblem::not_identified:
      return "failures at one effective tension alone say nothing of gamma; test at three levels "
             "or "
             "more";
    case statistics::FitProblem::not_converged:
      break;
  }
  return "the nominal law could not be fitted to these lives";
}

LifeDiagnosis undiagnosed(const Campaign& campaign, const std::string& why) {
  LifeDiagnosis diagnosis;
  Findings& findings = diagnosis.findings;
  findings.words = "Nothing can be asked of these lives: " + why + ".";
  findings.next_experiment = why;
  findings.candidates = {{"none", 1}, {"unknown", 0}};
  findings.credible_set = {"none"};
  for (const auto& effect : effects::life_effects()) {
    findings.invisible.push_back({std::string(effect->id()), why});
  }
  if (campaign.nominal.life) {
    diagnosis.ipl_scale = campaign.nominal.life->ipl_scale;
    diagnosis.ipl_exponent = campaign.nominal.life->ipl_exponent;
    diagnosis.weibull_shape = campaign.nominal.life->weibull_shape;
  }
  return diagnosis;
}

}  // namespace host_sim::diagnose::lives
