#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "host_sim/command_line/options.hpp"
#include "host_sim/diagnose/plan/foresee.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/plan/course.hpp"
#include "host_sim/report/plan/html.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

using command_line::above;
using plan::PlanRequest;

struct PlanArguments {
  std::string for_diagnosis;
  std::string model;
  std::string json;
  std::string report;
  PlanRequest request;

  [[nodiscard]] std::array<std::string, 2> outputs() const { return {json, report}; }
};

constexpr int kMostSpecimens = 100'000;

[[noreturn]] void refuse(const std::string& why) {
  throw CLI::ValidationError("plan", why);
}

void check_levels(const std::vector<double>& levels_N) {
  if (levels_N.size() < 2) {
    refuse("--levels: the exponent of the law needs at least two levels");
  }
  if (const auto twice = std::adjacent_find(levels_N.begin(), levels_N.end());
      twice != levels_N.end()) {
    refuse(fmt::format("--levels: {} N is there twice", *twice));
  }
}

void check_specimens(const PlanRequest& request) {
  const std::size_t levels = request.conditions.levels_N.size();
  const auto& specimens = request.specimens;
  if (specimens.empty()) {
    if (std::isinf(request.goal.ratio)) {
      refuse("give --ratio to search for a plan, or --specimens to try one");
    }
    if (request.specimens_max < plan::kFewestOfLevel * levels) {
      refuse(fmt::format("--specimens-max: {} levels need at least {} specimens", levels,
                         plan::kFewestOfLevel * levels));
    }
    return;
  }
  if (specimens.size() != levels) {
    refuse(fmt::format("--specimens: {} numbers for {} levels", specimens.size(), levels));
  }
  if (std::count(specimens.begin(), specimens.end(), 0U) + 2 >
      static_cast<std::ptrdiff_t>(levels)) {
    refuse("--specimens: at least two levels need specimens");
  }
}

/// Levels rise, whatever order they were given in, and keep their specimens.
void sort_levels(PlanRequest& request) {
  auto& levels_N = request.conditions.levels_N;
  auto& specimens = request.specimens;
  std::vector<std::pair<double, std::size_t>> levels;
  for (std::size_t i = 0; i < levels_N.size(); ++i) {
    levels.emplace_back(levels_N[i], i < specimens.size() ? specimens[i] : 0);
  }
  std::sort(levels.begin(), levels.end());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    levels_N[i] = levels[i].first;
    if (i < specimens.size()) {
      specimens[i] = levels[i].second;
    }
  }
}

/// @pre the levels are sorted
void take_law_of_model(const std::string& path, PlanRequest& request) {
  const Model model = read_model(path);
  const double strongest_N =
      std::max(request.conditions.levels_N.back(), request.goal.use_tension_N);
  if (strongest_N >= model.cable.ultimate_tension_N) {
    refuse(fmt::format("{} N is not below the ultimate tension of the model, {} N", strongest_N,
                       model.cable.ultimate_tension_N));
  }
  request.conditions.law = {model.life.ipl_scale, model.life.ipl_exponent,
                            model.life.weibull_shape};
}

struct PlanDiagnosisArguments {
  std::string plan;
  std::string json;
  std::uint64_t seed = 1;
  unsigned threads = 0;
};

/// What a campaign of recordings could show and distinguish, before anyone runs it: the exit
/// status.
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
  std::ostream& summary = summary_stream({&arguments.json, 1});
  diagnose::write_foresight(summary, foresight);
  write_next(summary, fmt::format("host_sim synth --plan {} --out FOLDER simulates it, to diagnose",
                                  shell_word(arguments.plan)));
  return 0;
}

int run(PlanArguments& arguments) {
  PlanRequest& request = arguments.request;
  check_files("plan", {.reads = {{"--for-diagnosis", arguments.for_diagnosis},
                                 {"--model", arguments.model}},
                       .writes = {{"--json", arguments.json}, {"--report", arguments.report}},
                       .fills = {}});
  if (!arguments.for_diagnosis.empty()) {
    return plan_for_diagnosis({arguments.for_diagnosis, arguments.json, request.simulation.seed,
                               request.simulation.threads});
  }
  if (request.conditions.levels_N.empty()) {
    throw CLI::RequiredError("--levels");
  }
  if (request.goal.use_tension_N == 0) {
    throw CLI::RequiredError("--use-tension");
  }
  if (arguments.model.empty() && request.conditions.law.scale == 0) {
    refuse("give the law: --model, or --scale, --exponent and --shape");
  }
  check_specimens(request);
  sort_levels(request);
  check_levels(request.conditions.levels_N);
  if (!arguments.model.empty()) {
    take_law_of_model(arguments.model, request);
  }
  auto json = open_if_asked(arguments.json);
  auto report = open_if_asked(arguments.report);
  Progress progress("plan");
  request.progress = [&](double share) { progress.update_share(share); };
  const plan::PlanResult result = plan::make_plan(request);
  const auto courses = report ? plan::courses_of(request, result) : std::vector<plan::Course>();
  progress.finish();
  if (json) {
    json->write(plan::plan_json(request, result));
  }
  if (report) {
    write_plan_report(report->stream(), request, result, courses, kProgramVersion);
  }
  commit_all({&json, &report});
  std::ostream& summary = summary_stream(arguments.outputs());
  plan::write_plan(summary, request, result);
  write_next(summary,
             "host_sim init campaign, for the specimens; then host_sim calibrate CAMPAIGN");
  return 0;
}

void add_law_options(CLI::App& verb, PlanArguments& arguments) {
  life_law::LifeLaw& law = arguments.request.conditions.law;
  CLI::Option* model = verb.add_option("--model", arguments.model, "The law: a model, a TOML file");
  CLI::Option* scale =
      verb.add_option("--scale", law.scale, "The law, assumed: A of A / T^gamma, in cycles");
  CLI::Option* exponent = verb.add_option("--exponent", law.exponent, "Assumed gamma");
  CLI::Option* shape = verb.add_option("--shape", law.shape, "Assumed Weibull shape");
  for (CLI::Option* option : {scale, exponent, shape}) {
    option->check(above(0))->excludes(model);
  }
  scale->needs(exponent)->needs(shape);
  exponent->needs(scale);
  shape->needs(scale);
}

void add_design_options(CLI::App& verb, PlanRequest& request) {
  verb.add_option("--levels", request.conditions.levels_N, "Effective tensions to test at, in N")
      ->delimiter(',')
      ->check(above(0));
  verb.add_option("--suspend-at", request.conditions.suspend_at_cycles,
                  "Cycles at which a specimen that still lives is suspended")
      ->check(above(0));
  CLI::Option* specimens =
      verb.add_option("--specimens", request.specimens,
                      "How many specimens each level has: says what this plan gives")
          ->delimiter(',')
          ->check(command_line::in_range(0, kMostSpecimens));
  verb.add_option("--specimens-max", request.specimens_max, "Most specimens of a plan, all levels")
      ->excludes(specimens)
      ->check(command_line::in_range(1, kMostSpecimens))
      ->capture_default_str();
  verb.add_option("--cycles-per-minute", request.cycles_per_minute,
                  "Speed of a rig, for the duration of a test")
      ->check(above(0));
}

void add_goal_options(CLI::App& verb, PlanRequest& request) {
  verb.add_option("--use-tension", request.goal.use_tension_N,
                  "Effective tension that B10 is wanted for, in N")
      ->check(above(0));
  verb.add_option("--ratio", request.goal.ratio,
                  "Wanted: high / low of the 95 % interval of B10 at most this")
      ->check(above(1));
  verb.add_option("--assurance", request.goal.assurance,
                  "Wanted in at least this share of campaigns")
      ->check(command_line::in_range(0.01, 0.999))
      ->capture_default_str();
  verb.add_option("--curvature", request.curvature_factor,
                  "The curvature to look for: life at the use is this many times less")
      ->check(above(1))
      ->capture_default_str();
}

void add_simulation_options(CLI::App& verb, PlanRequest& request) {
  verb.add_option("--simulations", request.simulation.simulations,
                  "Campaigns to simulate for each plan")
      ->check(command_line::in_range(100, 1'000'000))
      ->capture_default_str();
  verb.add_option("--seed", request.simulation.seed, "Of the random numbers")
      ->capture_default_str();
  verb.add_option("--threads", request.simulation.threads,
                  "0 is one for each core; the result does not depend on it")
      ->check(command_line::in_range(0, 1024))
      ->capture_default_str();
}

}  // namespace

void add_plan(CLI::App& app, int& status) {
  auto arguments = std::make_shared<PlanArguments>();
  CLI::App* verb =
      app.add_subcommand("plan", "How many specimens a life test needs, and at which levels");
  CLI::Option* for_diagnosis =
      verb->add_option("--for-diagnosis", arguments->for_diagnosis,
                       "Instead: what a campaign of recordings, planned as for synth, could show");
  add_law_options(*verb, *arguments);
  add_design_options(*verb, arguments->request);
  add_goal_options(*verb, arguments->request);
  add_simulation_options(*verb, arguments->request);
  verb->add_option("--report", arguments->report, "Write a page with plots as HTML");
  const std::array<std::string, 4> for_both{"--help", "--for-diagnosis", "--seed", "--threads"};
  for (CLI::Option* option : verb->get_options()) {
    if (std::ranges::find(for_both, option->get_name()) == for_both.end()) {
      for_diagnosis->excludes(option);
    }
  }
  verb->add_option("--json", arguments->json, "Write the result as JSON; - is standard output");
  verb->footer(
      "Example: host_sim plan --model host_sim/examples/upper_arm.toml --levels "
      "42.5,50.8,60.1,71.0 --use-tension 25.5 --ratio 1.25\n"
      "         host_sim plan --for-diagnosis host_sim/examples/synth/crossed.toml");
  verb->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace host_sim
