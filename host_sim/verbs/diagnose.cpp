#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>

#include "hal/files/interruption.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/output/extended_model.hpp"
#include "host_sim/diagnose/output/results.hpp"
#include "host_sim/diagnose/output/summary.hpp"
#include "host_sim/effects/counting_effect.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "host_sim/effects/tension/tension_effect.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/report/diagnose/html.hpp"
#include "host_sim/verbs/columns.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::stop_if_interrupted;

namespace {

struct Arguments {
  std::string folder;
  std::string out;
  std::string json;
  std::string report;
  hal::files::ColumnOptions columns;
  diagnose::DiagnoseOptions options;
  bool fail_on_discrepancy = false;

  [[nodiscard]] std::array<std::string, 3> outputs() const { return {out, json, report}; }
};

diagnose::Diagnosis with_progress(const Campaign& campaign, diagnose::DiagnoseOptions options) {
  Progress progress("diagnose");
  std::mutex mutex;
  options.progress = [&](double share) {
    stop_if_interrupted();
    const std::lock_guard lock(mutex);
    progress.update_share(share);
  };
  return diagnose::diagnose(campaign, options);
}

/// A model that replay and the packer read.
std::string checked_model(const Campaign& campaign, const diagnose::Diagnosis& diagnosis,
                          diagnose::InputFrom input, const std::string& path) {
  std::string text = diagnose::extended_model_text(campaign, diagnosis, input, kProgramVersion);
  parameters_of(parse_extended_model(text, path), path);
  return text;
}

/// The model that was asked for. What was found is worth having also without it, so that what it
/// fails by is kept until all else is written.
class ModelOutput {
 public:
  ModelOutput(const Campaign& campaign, const std::string& path)
      : campaign_(campaign), path_(path) {
    attempt([&] {
      if (!path_.empty()) {
        diagnose::require_extensible_model(campaign_);
        input_ = diagnose::input_of(campaign_);
        file_.emplace(path_);
      }
    });
  }

  void write(const diagnose::Diagnosis& diagnosis) {
    attempt([&] {
      if (file_) {
        file_->write(checked_model(campaign_, diagnosis, input_, path_));
        file_->commit();
      }
    });
  }

  /// Empty where there is none.
  [[nodiscard]] std::string path() const { return failure_ ? std::string() : path_; }

  void rethrow() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  template <typename Action>
  void attempt(Action action) {
    try {
      action();
    } catch (const hal::files::Interruption&) {
      throw;
    } catch (const std::exception&) {
      failure_ = std::current_exception();
      file_.reset();
    }
  }

  const Campaign& campaign_;
  std::string path_;
  diagnose::InputFrom input_ = diagnose::InputFrom::load_cell;
  std::optional<hal::files::OutputFile> file_;
  std::exception_ptr failure_;
};

std::string next_step(const Arguments& arguments, const diagnose::Diagnosis& diagnosis,
                      bool written) {
  const diagnose::Verdict verdict = diagnosis.verdict();
  const std::vector<diagnose::Doubt> doubts = diagnose::merged(diagnosis).doubts;
  if (diagnose::spoil_all(doubts) || (!doubts.empty() && verdict == diagnose::Verdict::none)) {
    return "settle what is in doubt, as above, and diagnose again";
  }
  switch (verdict) {
    case diagnose::Verdict::none:
      return "take the model; host_sim plan --for-diagnosis PLAN says what another campaign would "
             "show";
    case diagnose::Verdict::named:
      return !written ? "--out extended.toml writes the model with what was named"
                      : "host_sim pack " + shell_word(arguments.out) + " --out block.bin";
    case diagnose::Verdict::ambiguous:
      return "make the experiment that separates them, as above, and diagnose again";
    case diagnose::Verdict::unknown:
      break;
  }
  return "--report diagnosis.html shows what the residuals follow";
}

int run(const Arguments& arguments) {
  Campaign campaign = read_campaign(arguments.folder);
  campaign.columns = arguments.columns;
  auto json = open_if_asked(arguments.json);
  auto page = open_if_asked(arguments.report);
  ModelOutput model(campaign, arguments.out);
  if (!json && !page) {
    model.rethrow();  // before the long work, which nothing would be left of
  }
  const diagnose::Diagnosis diagnosis = with_progress(campaign, arguments.options);
  model.write(diagnosis);
  if (json) {
    json->write(
        diagnose::diagnosis_json(diagnosis, {campaign.name, model.path(), arguments.options.seed}));
  }
  if (page) {
    write_diagnose_report(page->stream(), campaign.name, diagnosis, kProgramVersion);
  }
  commit_all({&json, &page});
  std::ostream& summary = summary_stream(arguments.outputs());
  diagnose::write_summary(summary, campaign.name, diagnosis);
  write_next(summary, next_step(arguments, diagnosis, !model.path().empty()));
  model.rethrow();
  const bool found = diagnosis.verdict() != diagnose::Verdict::none ||
                     diagnose::spoil_all(diagnose::merged(diagnosis).doubts);
  return arguments.fail_on_discrepancy && found ? kFoundInData : 0;
}

std::vector<std::string> catalogue() {
  std::vector<std::string> ids;
  for (const effects::TensionEffect* const effect : effects::tension_effects()) {
    ids.emplace_back(effect->id);
  }
  for (const effects::CountingEffect& effect : effects::kCountingEffects) {
    ids.emplace_back(effect.id);
  }
  for (const auto& effect : effects::life_effects()) {
    ids.emplace_back(effect->id());
  }
  return ids;
}

void add_outputs(CLI::App& verb, Arguments& arguments) {
  verb.add_option("--out", arguments.out,
                  "Write the nominal model, refitted and with what was named added, which replay "
                  "and pack read");
  verb.add_option("--report", arguments.report, "Write a page with plots as HTML");
  verb.add_option("--json", arguments.json, "Write the result as JSON; - is standard output");
}

void add_computation(CLI::App& verb, diagnose::DiagnoseOptions& options) {
  verb.add_option("--seed", options.seed, "Of all random numbers")->capture_default_str();
  verb.add_option("--threads", options.threads,
                  "How many threads; all cores without it. The result does not depend on it")
      ->check(command_line::in_range(1U, kMostThreads));
  command_line::one_at_a_time(
      verb.add_option(
          "--without", options.without,
          "Take effects out of the catalogue, a comma between them: what they alone explain "
          "becomes unknown"))
      ->delimiter(',')
      ->check(CLI::IsMember(catalogue()));
}

}  // namespace

void add_diagnose(CLI::App& app, int& status) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand(
      "diagnose", "Where simulation and measurement disagree, why, and what mending it gains");
  verb->add_option("CAMPAIGN", arguments->folder,
                   "Folder with campaign.toml and recordings (sessions.csv), lives "
                   "(specimens.csv) or both")
      ->required()
      ->type_name(command_line::kFolder);
  add_columns(*verb, arguments->columns);
  add_outputs(*verb, *arguments);
  add_computation(*verb, arguments->options);
  verb->add_flag("--fail-on-discrepancy", arguments->fail_on_discrepancy,
                 "Exit with status 3 unless the verdict is none");
  verb->footer(
      "Example: host_sim synth --plan host_sim/examples/synth/crossed.toml --out crossed\n"
      "         host_sim diagnose crossed --out extended.toml --report diagnosis.html");
  verb->callback([arguments, &status] {
    check_files("diagnose",
                {.reads = named("CAMPAIGN", recording::files_of_campaign(arguments->folder)),
                 .writes = {{"--out", arguments->out},
                            {"--json", arguments->json},
                            {"--report", arguments->report}},
                 .fills = {}});
    status = run(*arguments);
  });
}

}  // namespace host_sim
