#include "host_sim/calibrate/calibrate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/calibrate/levels.hpp"
#include "host_sim/calibrate/stress_life.hpp"
#include "host_sim/calibrate/use_levels.hpp"
#include "host_sim/calibrate/validation.hpp"
#include "host_sim/statistics/fit.hpp"

namespace host_sim::calibrate {

using hal::files::InputError;

namespace {

/// What a fit that does not exist would need, after "no fit, ".
std::string_view need_of(statistics::FitProblem problem) {
  switch (problem) {
    case statistics::FitProblem::none:
      return "which converged";
    case statistics::FitProblem::too_few_failures:
      return "which needs at least 2 failures";
    case statistics::FitProblem::no_spread:
      return "because lives without scatter put the shape on its boundary, at infinity";
    case statistics::FitProblem::not_identified:
      return "because the data do not determine it: failures at two tensions at least are needed";
    case statistics::FitProblem::not_converged:
      return "because the likelihood did not converge to a maximum";
  }
  return "";
}

/// Levels of too few failures that have a warning each; more are reported together.
constexpr std::size_t kLevelsReportedApart = 3;

bool has_too_few_failures(const LevelResult& level) {
  return level.weibull().problem == statistics::FitProblem::too_few_failures;
}

/// Why a level has no Weibull fit of its own, with the line of its first specimen; empty where it
/// has one.
std::string level_warning(const Campaign& campaign, const Level& level, const LevelResult& result) {
  const statistics::Fit& weibull = result.weibull();
  if (weibull.problem == statistics::FitProblem::none) {
    return {};
  }
  const auto file = (campaign.folder / "specimens.csv").string();
  return fmt::format(
      "{}:{}: level {}: {} failed of {}: no Weibull fit of its own, {}; its specimens still count "
      "in the life law",
      file, level.specimens.front()->line, result.name(), result.failed(), result.sample.size(),
      need_of(weibull.problem));
}

class Warnings {
 public:
  Warnings(const Campaign& campaign, std::span<const Level> sources, CalibrateResult& result)
      : campaign_(campaign), sources_(sources), result_(result) {}

  void add_all() {
    add_specimens();
    add_levels();
    add_shape();
    if (result_.stress_life) {
      add_law(*result_.stress_life);
      add_extrapolation();
    }
    add_validation();
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> text, Values&&... values) {
    result_.warnings.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  /// ASTM E739 has 6 to 12 specimens for exploration, 12 to 24 where a design rests on them.
  void add_specimens() {
    constexpr std::size_t kFewForADesign = 12;
    if (result_.specimens < kFewForADesign) {
      add("{} specimens are few: enough to explore, but a design rests on {} and more (ASTM E739)",
          result_.specimens, kFewForADesign);
    }
  }

  void add_levels() {
    const std::vector<std::uint64_t> few = lines_of_few_failures();
    const bool together = few.size() > kLevelsReportedApart;
    if (together) {
      add("{}: {} levels have fewer than 2 failures and so no Weibull fit of their own; their "
          "specimens still count in the life law; they begin at lines {}",
          (campaign_.folder / "specimens.csv").string(), few.size(), fmt::join(few, ", "));
    }
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const LevelResult& level = result_.levels[i];
      if (std::string text = level_warning(campaign_, sources_[i], level);
          !text.empty() && !(together && has_too_few_failures(level))) {
        result_.warnings.push_back(std::move(text));
      }
      if (const std::size_t found = level.found_broken(); found > 0) {
        add("level {}: {} of {} were found broken at inspections: no goodness of fit, which needs "
            "lives that are known",
            level.name(), found, level.sample.size());
      }
      if (!level.left_out.empty()) {
        add("level {} is left out of the life law: {}", level.name(), level.left_out);
      }
    }
  }

  [[nodiscard]] std::vector<std::uint64_t> lines_of_few_failures() const {
    std::vector<std::uint64_t> lines;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (has_too_few_failures(result_.levels[i])) {
        lines.push_back(sources_[i].specimens.front()->line);
      }
    }
    return lines;
  }

  void add_shape() {
    if (result_.common_shape && rejected(result_.common_shape->homogeneity)) {
      add("one shape for all levels is rejected: likelihood ratio {:.2f}, p {:.2g}",
          result_.common_shape->homogeneity.statistic,
          result_.common_shape->homogeneity.p_simulated);
    }
  }

  void add_law(const StressLife& law) {
    add_rejected(law.against_free_levels,
                 "the inverse power law is rejected against levels that are free of it");
    add_rejected(law.against_curvature,
                 "the inverse power law is rejected against a law that bends in log-log");
    add_rejected(law.against_growing_scatter,
                 "one shape is rejected against scatter that changes with tension");
    add_endless("ipl_scale", law.scale_ci95);
    add_endless("ipl_exponent", law.exponent_ci95);
    add_endless("weibull_shape", law.shape_ci95);
  }

  void add_rejected(const std::optional<Test>& test, std::string_view text) {
    if (test && rejected(*test)) {
      add("{}: likelihood ratio {:.2f}, p {:.2g}", text, test->statistic, test->p_simulated);
    }
  }

  void add_endless(std::string_view name, const Interval& interval) {
    if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) {
      add("the 95 % interval of {} has no end on one side", name);
    }
  }

  void add_extrapolation() {
    const auto [low, high] = tested_N();
    for (const UseLevel& use : result_.use_levels) {
      if (use.effective_tension_N < low || use.effective_tension_N > high) {
        add("use level {}: {:.1f} N lies outside of the tested {:.1f} to {:.1f} N: its intervals "
            "hold only if the law continues as it is",
            use.name, use.effective_tension_N, low, high);
      }
    }
  }

  /// Tensions that the law was fitted to.
  [[nodiscard]] Interval tested_N() const {
    Interval range{HUGE_VAL, 0};
    const auto widen = [&range](double tension_N) {
      range = {std::min(range.low, tension_N), std::max(range.high, tension_N)};
    };
    for (const LevelResult& level : result_.levels) {
      if (level.role == Campaign::Role::fit && level.left_out.empty()) {
        widen(level.load.effective_tension_N);
      }
    }
    for (const Campaign::Specimen& specimen : campaign_.specimens) {
      if (specimen.role == Campaign::Role::fit && !specimen.constant_load()) {
        for (const Campaign::Block& block : specimen.blocks) {
          widen(block.load.effective_tension_N);
        }
      }
    }
    return range;
  }

  void add_validation() {
    for (const ValidationResult& validation : result_.validation) {
      if (validation.p < kSignificance) {
        add("validation {}: {}",
            validation.in_blocks ? "in blocks" : result_.levels[validation.level].name(),
            validation.words);
      }
    }
  }

  const Campaign& campaign_;
  std::span<const Level> sources_;
  CalibrateResult& result_;
};

/// Adds to the warnings what a reader of the result has to know before its numbers: levels without
/// a fit, levels left out, tests that reject, extrapolation, intervals without an end.
void add_warnings(const Campaign& campaign, std::span<const Level> sources,
                  CalibrateResult& result) {
  Warnings(campaign, sources, result).add_all();
}

void count_specimens(const Campaign& campaign, CalibrateResult& result) {
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    result.in_blocks += specimen.constant_load() ? 0U : 1U;
    if (specimen.role == Campaign::Role::fit) {
      ++result.specimens;
      ++(specimen.status == Campaign::Status::suspended ? result.suspended : result.failed);
    }
  }
}

void refuse_without_lives(const Campaign& campaign, const CalibrateResult& result) {
  if (campaign.specimens.empty()) {
    throw InputError(campaign.folder.string(), 0, 0, "recordings only, no lives to calibrate from",
                     "a campaign folder with specimens.csv");
  }
  constexpr std::size_t kFewest = 2;
  if (result.failed < kFewest) {
    throw InputError(
        (campaign.folder / "specimens.csv").string(), 0, 0,
        fmt::format("{} failed of {} specimens of role fit", result.failed, result.specimens),
        "at least 2 failed");
  }
}

/// One calibration on its way: what each step needs of those before.
class Calibration {
 public:
  Calibration(const Campaign& campaign, const CalibrateOptions& options)
      : campaign_(campaign), options_(options), sources_(levels_of(campaign)) {
    result_.campaign = campaign.name;
    result_.seed = options.seed;
    result_.bootstraps = options.bootstraps;
    count_specimens(campaign, result_);
    refuse_without_lives(campaign, result_);
  }

  CalibrateResult run() {
    fit_levels();
    result_.common_shape = common_shape(result_.levels, options_);
    progress(kAfterShape);
    fit_law();
    add_warnings(campaign_, sources_, result_);
    progress(1);
    return std::move(result_);
  }

 private:
  static constexpr double kAfterLevels = 0.5;
  static constexpr double kAfterShape = 0.7;
  static constexpr double kAfterReplicates = 0.8;
  static constexpr double kAfterLaw = 0.95;

  void progress(double share) const {
    if (options_.progress) {
      options_.progress(share);
    }
  }

  void fit_levels() {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      progress(kAfterLevels * static_cast<double>(i) / static_cast<double>(sources_.size()));
      result_.levels.push_back(level_result(sources_[i], i, options_));
    }
    progress(kAfterLevels);
  }

  void fit_law() {
    const life_law::LifeData data = specimens_to_fit(campaign_, result_.levels, sources_);
    const life_law::LifeFit fit = life_law::fit_life(data);
    if (fit.problem != statistics::FitProblem::none) {
      result_.warnings.push_back(fmt::format("there is no life law: {}", need_of(fit.problem)));
      return;
    }
    const LifeLaw law = fit.law();
    const std::vector<LifeLaw> refits = refitted_laws(data, law, options_);
    progress(kAfterReplicates);
    result_.mixes = mixes(campaign_, law);
    const std::vector<Use> uses = use_loads();
    std::vector<double> use_N;
    use_N.reserve(uses.size());
    for (const Use& use : uses) {
      use_N.push_back(use.tension_N);
    }
    result_.stress_life =
        stress_life(data, fit, refits, result_.levels, result_.common_shape, use_N, options_);
    progress(kAfterLaw);
    for (const Use& use : uses) {
      result_.use_levels.push_back(use_level(use.name, use.tension_N, data, fit, refits,
                                             result_.use_levels.size(), options_));
    }
    add_validation(law, refits);
  }

  struct Use {
    std::string name;
    double tension_N;  ///< effective
  };

  /// @pre the mixes are there
  [[nodiscard]] std::vector<Use> use_loads() const {
    std::vector<Use> uses;
    std::size_t next_mix = 0;
    for (const Campaign::Use& use : campaign_.uses) {
      uses.push_back({use.name, use.parts.size() > 1 ? result_.mixes[next_mix++].by_damage_N
                                                     : use.parts.front().load.effective_tension_N});
    }
    for (const double tension_N : options_.use_tensions_N) {
      uses.push_back({fmt::format("{:g} N", tension_N), tension_N});
    }
    return uses;
  }

  void add_validation(const LifeLaw& law, const std::vector<LifeLaw>& refits) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (sources_[i].role != Campaign::Role::validation) {
        continue;
      }
      const double scale = law.characteristic_life(sources_[i].load.effective_tension_N);
      add_validation(level_specimens(sources_[i], i), law, refits, i, scale);
    }
    if (const life_law::LifeData blocks = validation_in_blocks(campaign_); !blocks.empty()) {
      add_validation(blocks, law, refits, sources_.size(), 1);
    }
  }

  /// @param cycles_per_damage turns means in damage into cycles
  void add_validation(const life_law::LifeData& specimens, const LifeLaw& law,
                      const std::vector<LifeLaw>& refits, std::size_t index,
                      double cycles_per_damage) {
    std::optional<ValidationResult> found = validate(specimens, law, refits, index, options_);
    if (found) {
      found->level = index;
      found->in_blocks = index == sources_.size();
      found->predicted_mean *= cycles_per_damage;
      found->measured_mean *= cycles_per_damage;
      result_.validation.push_back(std::move(*found));
    }
  }

  const Campaign& campaign_;
  const CalibrateOptions& options_;
  std::vector<Level> sources_;
  CalibrateResult result_;
};

}  // namespace

CalibrateResult calibrate(const Campaign& campaign, const CalibrateOptions& options) {
  return Calibration(campaign, options).run();
}

}  // namespace host_sim::calibrate
