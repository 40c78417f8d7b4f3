#include <mutex>
#include <optional>

#include "hal/files/interruption.hpp"
#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/campaign/nominal_model.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/report/calibrate/html.hpp"
#include "host_sim/verbs/calibrate_arguments.hpp"
#include "host_sim/verbs/fail_on.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::stop_if_interrupted;

namespace {

calibrate::CalibrateResult with_progress(const Campaign& campaign,
                                         const CalibrateArguments& arguments) {
  Progress progress("calibrate");
  std::mutex mutex;
  calibrate::CalibrateOptions options = arguments.options();
  options.progress = [&](double share) {
    stop_if_interrupted();
    const std::lock_guard lock(mutex);
    progress.update_share(share);
  };
  return calibrate::calibrate(campaign, options);
}

/// A model that replay and the packer read.
std::string checked_model(const Campaign& campaign, const calibrate::CalibrateResult& result,
                          const std::string& path) {
  std::string text = calibrate::model_text(campaign, result, kProgramVersion);
  parameters_of(parse_model(text, path), path);
  return text;
}

}  // namespace

int calibrate_one(const CalibrateArguments& arguments) {
  const Campaign campaign = read_campaign(arguments.folder);
  if (!arguments.out.empty()) {
    require_nominal_model(campaign);
  }
  auto out = open_if_asked(arguments.out);
  auto json = open_if_asked(arguments.json);
  auto page = open_if_asked(arguments.report);

  const calibrate::CalibrateResult result = with_progress(campaign, arguments);
  if (out) {
    out->write(checked_model(campaign, result, arguments.out));
  }
  if (json) {
    json->write(calibrate::calibrate_json(result));
  }
  if (page) {
    write_calibrate_report(page->stream(), result, kProgramVersion);
  }
  commit_all({&out, &json, &page});
  calibrate::write_summary(summary_stream(arguments.outputs()), result);
  return fails_on(arguments.fail_on, calibrate::found_in(result)) ? kFoundInData : 0;
}

}  // namespace host_sim
