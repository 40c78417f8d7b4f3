#include "host_sim/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/calibrate/levels.hpp"
#include "host_sim/calibrate/mixes.hpp"
#include "host_sim/calibrate/problem_text.hpp"
#include "host_sim/calibrate/replicates.hpp"
#include "host_sim/calibrate/shape.hpp"
#include "host_sim/calibrate/specimens.hpp"
#include "host_sim/calibrate/stress_life.hpp"
#include "host_sim/calibrate/use_levels.hpp"
#include "host_sim/calibrate/validation.hpp"
#include "host_sim/calibrate/warnings.hpp"
#include "host_sim/io/input_error.hpp"

namespace host_sim::calibrate {
namespace {

void count_specimens(const Campaign& campaign, CalibrateResult& result) {
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    result.in_blocks += specimen.constant_load() ? 0U : 1U;
    if (specimen.role == Campaign::Role::fit) {
      ++result.specimens;
      ++(specimen.status == Campaign::Status::failed ? result.failed : result.suspended);
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
      result_.warnings.push_back(
          fmt::format("there is no life law: {}", problem_text(fit.problem)));
      return;
    }
    const LifeLaw law = fit.law();
    const std::vector<LifeLaw> refits = refitted_laws(data, law, options_);
    progress(kAfterReplicates);
    result_.stress_life =
        stress_life(data, fit, refits, result_.levels, result_.common_shape, options_);
    progress(kAfterLaw);
    result_.mixes = mixes(campaign_, law);
    add_use_levels(data, fit, refits);
    add_validation(law, refits);
  }

  void add_use_levels(const life_law::LifeData& data, const life_law::LifeFit& fit,
                      const std::vector<LifeLaw>& refits) {
    const auto add = [&](const std::string& name, double tension_N) {
      result_.use_levels.push_back(
          use_level(name, tension_N, data, fit, refits, result_.use_levels.size(), options_));
    };
    std::size_t next_mix = 0;
    for (const Campaign::Use& use : campaign_.uses) {
      add(use.name, use.parts.size() > 1 ? result_.mixes[next_mix++].by_damage_N
                                         : use.parts.front().load.effective_tension_N);
    }
    for (const double tension_N : options_.use_tensions_N) {
      add(fmt::format("{:g} N", tension_N), tension_N);
    }
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
