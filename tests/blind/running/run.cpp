#include "tests/blind/running/run.hpp"

#include <chrono>

#include "hal/files/input_error.hpp"
#include "hal/files/output_file.hpp"
#include "tests/blind/oracle/visibility.hpp"

namespace blind {
namespace {

using Clock = std::chrono::steady_clock;

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  hal::files::OutputFile file(path);
  file.write(text);
  file.commit();
}

void analyse(const std::filesystem::path& folder, const Analysis& analysis,
             const RunOptions& options, Record& record) {
  host_sim::diagnose::DiagnoseOptions asked;
  asked.seed = record.truth.seed;
  asked.threads = 1;
  asked.without = options.without;
  const Clock::time_point start = Clock::now();
  try {
    record.findings = analysis(folder, asked);
  } catch (const hal::files::InputError& error) {
    record.error = error.what();
  }
  record.seconds = std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Record run_campaign(const Scenario& scenario, const Analysis& analysis, const RunOptions& options) {
  const std::string name = std::to_string(scenario.seed);
  const std::filesystem::path folder = options.folder / "campaigns" / name;
  const std::filesystem::path truth = options.folder / "truths" / (name + ".json");
  std::filesystem::remove_all(folder);
  const Sealed sealed = make_blind_campaign(scenario, folder);
  write(truth, sealed.text);
  if (options.sealed) {
    options.sealed(scenario.seed, sealed.sha256);
  }
  Record record;
  record.truth = scenario;
  record.truth.plan.clear();
  record.truth_sha256 = sealed.sha256;
  analyse(folder, analysis, options, record);
  if (options.oracle) {
    record.visibility = visibility_of(scenario);
    record.rmse_floor_N = record.findings.gain.metrics.empty() ? 0 : rmse_floor_N(scenario);
  }
  if (!options.keep) {
    std::filesystem::remove_all(folder);
    std::filesystem::remove(truth);
  }
  return record;
}

}  // namespace blind
