#include "host_sim/verbs/plan_diagnosis.hpp"

#include <mutex>

#include "host_sim/diagnose/plan/foresee.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/verbs/outputs.hpp"

namespace host_sim {

int plan_for_diagnosis(const PlanDiagnosisArguments& arguments) {
  const synth::SynthPlan plan = synth::read_synth_plan(arguments.plan);
  auto json = open_if_asked(arguments.json);
  Progress progress("plan");
  std::mutex mutex;
  const auto show = [&](double share) {
    const std::lock_guard lock(mutex);
    progress.update_share(share);
  };
  const diagnose::Foresight foresight =
      diagnose::foresee(plan, {arguments.seed, arguments.threads, show});
  progress.finish();
  if (json) {
    json->write(diagnose::foresight_json(foresight));
  }
  commit_all({&json});
  diagnose::write_foresight(summary_stream({&arguments.json, 1}), foresight);
  return 0;
}

}  // namespace host_sim
