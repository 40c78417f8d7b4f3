#include <fmt/ostream.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/verbs/batch_outputs.hpp"
#include "host_sim/verbs/calibrate_arguments.hpp"
#include "host_sim/verbs/outputs.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::printable;

namespace {

namespace fs = std::filesystem;

std::string name_of(const std::string& folder) {
  return fs::path(folder).filename().string();
}

std::vector<std::string> folders_of(const std::string& folder) {
  std::vector<std::string> folders;
  for (const fs::path& campaign : list_campaigns(folder)) {
    folders.push_back(campaign.string());
  }
  if (folders.empty()) {
    throw InputError(folder, 0, 0, "no campaign in it",
                     "a folder of folders that hold a campaign.toml");
  }
  return folders;
}

batch::Answer calibrated(const std::string& folder, const calibrate::CalibrateOptions& options) {
  const std::string name = name_of(folder);
  const calibrate::CalibrateResult result = calibrate::calibrate(read_campaign(folder), options);
  std::string object = calibrate::calibrate_json(result, -1);
  object.pop_back();
  return {calibrate::table_row(name, result),
          fmt::format("{{\"folder\":{},\"result\":{}}}", nlohmann::json(printable(name)).dump(),
                      object),
          {},
          calibrate::found_in(result)};
}

batch::Answer refused(const std::string& folder, const std::string& error) {
  const std::string name = name_of(folder);
  const nlohmann::ordered_json object{{"folder", printable(name)}, {"error", error}};
  return {calibrate::refused_row(name, error), object.dump(), error, {}};
}

int tell(const CalibrateArguments& arguments, BatchOutputs& outputs,
         const std::vector<batch::Answer>& answers) {
  outputs.write(calibrate::table_head(), "campaigns", answers);
  const std::size_t errors = tell_errors(answers);
  fmt::print(summary_stream(arguments.outputs()), "{}: {} campaigns calibrated, {} refused\n",
             printable(arguments.folder), answers.size() - errors, errors);
  return status_of(answers, arguments.fail_on);
}

}  // namespace

int calibrate_batch(const CalibrateArguments& arguments) {
  batch::Ranks ranks;
  BatchOutputs outputs;
  batch::Batch batch;
  batch.label = "calibrate";
  batch.threads = arguments.threads;
  batch.list = [&] {
    std::vector<std::string> folders = folders_of(arguments.folder);
    check_files("calibrate", arguments.files(folders));
    outputs.open(arguments.table, arguments.json);
    return folders;
  };
  batch.work = [options = arguments.options()](const std::string& folder,
                                               const batch::Means& means) {
    calibrate::CalibrateOptions own = options;
    own.threads = means.threads;
    own.progress = means.progress;
    return calibrated(folder, own);
  };
  batch.refuse = [](const std::string& folder, const std::exception& error) {
    return refused(folder, batch::error_line(error, folder));
  };
  batch.tell = [&](const std::vector<batch::Answer>& answers) {
    return tell(arguments, outputs, answers);
  };
  return run_batch(ranks, batch);
}

}  // namespace host_sim
