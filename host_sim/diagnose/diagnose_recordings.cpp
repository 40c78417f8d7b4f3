#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/diagnose/audit/audit.hpp"
#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/force/alone.hpp"
#include "host_sim/diagnose/force/diagnose_forces.hpp"
#include "host_sim/diagnose/force/remainder.hpp"
#include "host_sim/diagnose/force_records.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/reference/equations.hpp"

namespace host_sim::diagnose {

using hal::files::InputError;

namespace {

/// Of the paper's wire, where the campaign does not say: damage is compared with damage only.
constexpr reference::Constants kUsualWire{177.4, 0.2, 1.53e5, 1.38, 5.94};

reference::Constants constants_of(const NominalModel& nominal) {
  reference::Constants constants = kUsualWire;
  if (nominal.cable) {
    constants.ultimate_tension_N = nominal.cable->ultimate_tension_N;
  }
  if (nominal.counting) {
    constants.hysteresis_N = nominal.counting->hysteresis_N;
  }
  if (nominal.life) {
    constants.ipl_scale = nominal.life->ipl_scale;
    constants.ipl_exponent = nominal.life->ipl_exponent;
  }
  return constants;
}

/// Where both were recorded, what the current stands for.
std::vector<Doubt> doubts_of_current(const std::vector<recording::Recording>& recordings,
                                     const NominalModel& nominal) {
  using enum hal::files::ProfileColumnId;
  double products_N2 = 0;
  double squares_N2 = 0;
  for (const recording::Recording& recording : recordings) {
    if (!nominal.drive || !recording.has(kInputTensionColumn) ||
        !recording.has(kMotorCurrentColumn)) {
      continue;
    }
    const reference::Drive drive = nominal.drive->reference();
    for (std::size_t i = 0; i < recording.samples(); ++i) {
      const double by_current_N =
          reference::input_tension_from_current(recording[kMotorCurrentColumn][i], drive);
      products_N2 += by_current_N * recording[kInputTensionColumn][i];
      squares_N2 += by_current_N * by_current_N;
    }
  }
  const double times = squares_N2 > 0 ? products_N2 / squares_N2 : 1;
  if (times > 0 && std::abs(std::log(times)) < kDoubtfulLogGain) {
    return {};
  }
  return {{{},
           column(kMotorCurrentColumn),
           fmt::format("the input tension is {:.3g} times what the current stands for: are its "
                       "unit and sign, the radius and the torque constant right?",
                       times),
           false}};
}

TensionDiagnosis nothing_to_see(bool faulty) {
  TensionDiagnosis diagnosis;
  diagnosis.findings.candidates = {{"none", 1}};
  diagnosis.findings.credible_set = {"none"};
  diagnosis.findings.prose =
      faulty ? "Nothing is left of the recordings once the faults of their sensors are taken out: "
               "nothing can be diagnosed."
             : "The recordings contain no motion from which friction could be determined: nothing "
               "can be diagnosed.";
  for (const effects::TensionEffect* const effect : effects::tension_effects()) {
    diagnosis.findings.invisible.push_back(
        {std::string(effect->id), "no recording with motion and both tensions"});
  }
  return diagnosis;
}

/// The first effect of one candidate that the other does not hold; null where there is none.
const effects::TensionEffect* other_than(std::string_view one, std::string_view other) {
  const std::vector<std::string_view> known = effects_in(other);
  for (const std::string_view id : effects_in(one)) {
    const effects::TensionEffect* const effect = effects::tension_effect(id);
    if (effect != nullptr && std::ranges::find(known, id) == known.end()) {
      return effect;
    }
  }
  return nullptr;
}

/// What distinguishes the causes that are still in question; empty where none are.
std::string next_experiment(const Findings& findings) {
  if (findings.verdict == Verdict::unknown && findings.remainder) {
    const std::string& covariate = findings.remainder->covariate;
    return covariate == kOfTime || covariate == kSession || covariate == kOfSessions
               ? "repeat one session several times with nothing changed"
               : fmt::format("repeat a few sessions with nothing changed but the {}", covariate);
  }
  if (findings.verdict != Verdict::ambiguous || findings.credible_set.size() < 2) {
    return "";
  }
  const std::string& first = findings.credible_set[0];
  const std::string& second = findings.credible_set[1];
  const effects::TensionEffect* one = other_than(first, second);
  const effects::TensionEffect* other = other_than(second, first);
  if (one != nullptr && other != nullptr) {
    return experiment_for(*one, *other);
  }
  const effects::TensionEffect* doubtful = one != nullptr ? one : other;
  return doubtful == nullptr
             ? ""
             : fmt::format(
                   "record more sessions in which {} would show: a wider range of what it "
                   "depends on, at the same poses and loads",
                   doubtful->term);
}

}  // namespace

TensionDiagnosis diagnose_tension(const Campaign& campaign, const DiagnoseOptions& options) {
  const auto recordings = recording::read_recordings(campaign.folder, campaign.columns);
  const auto faults = recording::faults_of(recordings);
  if (!campaign.two_sided && !recordings.empty() && !campaign.nominal.sheath) {
    throw InputError((campaign.folder / "campaign.toml").string(), 0, 0,
                     "no table [model.sheath], which friction is compared with",
                     "[model.sheath] with friction_coefficient and bend_angle_deg");
  }
  const std::vector<effects::ForceRecord> records =
      force_records(recordings, faults, campaign.nominal, !campaign.two_sided);
  TensionDiagnosis diagnosis =
      records.empty()
          ? nothing_to_see(!faults.empty())
          : diagnose_forces(records, campaign.nominal, constants_of(campaign.nominal), options);
  std::ranges::move(doubts_of_current(recordings, campaign.nominal),
                    std::back_inserter(diagnosis.findings.doubts));
  diagnosis.findings.next_experiment = next_experiment(diagnosis.findings);
  for (const recording::FaultSummary& summary : recording::summary_of(faults)) {
    diagnosis.faults.push_back(summary.words);
  }
  return diagnosis;
}

}  // namespace host_sim::diagnose
