#include "host_sim/calibrate/warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "host_sim/calibrate/levels.hpp"
#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {
namespace {

/// Levels of too few failures that have a warning each; more are told together.
constexpr std::size_t kLevelsToldApart = 3;

bool has_too_few_failures(const LevelResult& level) {
  return level.weibull().problem == statistics::FitProblem::too_few_failures;
}

class Warnings {
 public:
  Warnings(const Campaign& campaign, std::span<const Level> sources, CalibrateResult& result)
      : campaign_(campaign), sources_(sources), result_(result) {}

  void add_all() {
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

  void add_levels() {
    const std::vector<std::uint64_t> few = lines_of_few_failures();
    const bool together = few.size() > kLevelsToldApart;
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
    if (result_.common_shape && rejects(result_.common_shape->homogeneity)) {
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
    if (test && rejects(*test)) {
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
            "hold only if the law goes on as it is",
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

  static bool rejects(const Test& test) { return test.p_simulated < kSignificance; }

  const Campaign& campaign_;
  std::span<const Level> sources_;
  CalibrateResult& result_;
};

}  // namespace

void add_warnings(const Campaign& campaign, std::span<const Level> sources,
                  CalibrateResult& result) {
  Warnings(campaign, sources, result).add_all();
}

}  // namespace host_sim::calibrate
