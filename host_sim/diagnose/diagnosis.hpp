#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::diagnose {

enum class Verdict {
  none,       ///< nothing is wrong that this campaign could show
  named,      ///< each effect at kNamed or more
  ambiguous,  ///< something is wrong, and more than one cause explains it
  unknown,    ///< structure is left that nothing in the catalogue explains
};

/// "none", "named", "ambiguous" or "unknown".
std::string_view name_of(Verdict verdict);

inline constexpr double kNamed = 0.95;

/// A parameter with its 95 % interval.
struct Estimate {
  std::string name;  ///< with its unit as suffix
  std::string unit;
  double value = 0, low = 0, high = 0;
};

struct FoundEffect {
  std::string id;
  std::string term, equation, life_consequence;  ///< the catalogue's, or its own outside of it
  double probability = 0;
  std::vector<Estimate> parameters;
};

/// A cause and its probability; the ids "none" and "unknown" stand for themselves, two effects at
/// once are "one+other" in order of their ids. All probabilities of a list sum to 1.
struct Candidate {
  std::string id;
  double probability = 0;
};

/// Ids of the first that hold `share` together.
/// @param candidates most probable first
std::vector<std::string> credible_set_of(const std::vector<Candidate>& candidates,
                                         double share = kNamed);

struct Invisible {
  std::string id;
  std::string why;  ///< and what would show it
};

/// The residual against one covariate, of the maximum over directions: does it hold more than noise
/// and the scatter of sessions?
struct Discrepancy {
  std::string covariate;
  double statistic = 0;
  double p = 0;        ///< under the nominal model, its parameters refitted
  double p_after = 0;  ///< under the extended one
};

/// On data that the fit never saw.
struct Metric {
  std::string name;  ///< "rmse_N", "log_predictive_density", "damage_error_percent", "b10_coverage"
  double before = 0, after = 0;
};

struct HeldOutGain {
  std::string held_out_by;  ///< "session", "pose", "level"; empty where nothing was extended
  std::vector<Metric> metrics;
  /// Whether the error of the input is larger by no more than sessions scatter, if it is.
  bool within_scatter = false;
};

/// Whether the error on such data becomes less: of the input tension where that is known, which a
/// tendon breaks by, or its density larger with an error that is at most 2 % larger, or 10 % within
/// the scatter, since the density takes that into account, and in either case an error of the
/// damage of at most 10 % or half as much again; else of the output tension; else whether the
/// density is larger. What does not gain is no extension, however probable it is.
[[nodiscard]] bool improves(const HeldOutGain& gain);

/// One effect of the catalogue more in the model, beside those of the steps before it.
struct Step {
  FoundEffect effect;  ///< with its probability should the catalogue hold all that there is, and
                       ///< its parameters beside those before; of the nominal model without an id
  double output_rmse_N = 0;           ///< of T_out from T_in, on sessions that the fit never saw
  double input_rmse_N = 0;            ///< of T_in from T_out, on the same
  double log_predictive_density = 0;  ///< of a sample
  int sessions_better = 0;            ///< whose error of T_out is less than in the step before
  int sessions = 0;                   ///< of all
};

/// What the model, extended or not, leaves of recordings, on sessions that the fit never saw.
struct Remainder {
  double share = 0;  ///< of the squared error of the nominal model
  double input_rmse_N = 0;
  double output_rmse_N = 0;
  std::string covariate;  ///< that it shows most against
  double p = 1;           ///< that chance alone shows as much against it
};

/// What an extension adds besides causes, as a table over one covariate by direction. It has none.
struct Correction {
  std::string covariate;
  std::size_t knots = 0;
  double before_N = 0;  ///< root mean square error of T_in on sessions that the fit never saw
  double after_N = 0;
};

/// What is likely to be wrong with the data or the nominal model as they were written down.
struct Doubt {
  std::vector<std::string> sessions;  ///< none: all
  std::string column;                 ///< empty: of several
  std::string words;                  ///< without either
  /// Nothing is named beside it; where it is of single sessions, these are left out.
  bool spoils = false;
};

/// Whether one of all sessions spoils the result.
bool spoil_all(const std::vector<Doubt>& doubts);

/// With sessions, column and what is done about it, as a sentence.
std::string doubt_prose(const Doubt& doubt);

/// What is found in the recordings of a campaign, or in its lives.
struct Findings {
  Verdict verdict = Verdict::none;
  std::vector<FoundEffect> effects;  ///< named ones, or the most probable where ambiguous
  std::vector<Candidate> candidates;
  std::vector<std::string> credible_set;  ///< ids of candidates that hold 95 % together
  std::vector<std::vector<std::string>> equivalent_sets;
  std::vector<Invisible> invisible;
  std::string next_experiment;  ///< empty where none is needed
  HeldOutGain gain;
  /// Of recordings: the nominal model, then effect by effect as far as each gains.
  std::vector<Step> steps;
  std::optional<Remainder> remainder;  ///< of recordings
  std::optional<Correction>
      correction;  ///< of recordings, in the extensions as [extension.empirical]
  std::vector<Discrepancy> discrepancies;
  std::vector<Estimate> refitted;     ///< parameters that are not effects
  std::vector<Extension> extensions;  ///< to be written: named causes and the correction
  std::string prose;                  ///< the verdict in a few sentences
  std::vector<Doubt> doubts;
};

/// Of what is named and does not gain, nothing is left to be written: it is ambiguous.
/// @return whether that is so
bool withdraw_unless_improved(Findings& findings);

/// The ids of a candidate, "a+b+c", as parts of it.
std::vector<std::string_view> effects_in(std::string_view candidate);

/// "a", "a and b", "a, b and c".
/// @param last the word before the last one
std::string listed(const std::vector<std::string>& items, std::string_view last);

/// Why nothing was extended, as a sentence behind others; empty where that is not for want of a
/// gain.
[[nodiscard]] std::string no_gain_prose(const Findings& findings);

/// Output tension of one session over time, and the loop T_in to T_out, thinned for a picture.
struct TracePicture {
  std::string session;
  std::vector<double> time_s, input_N, measured_N, before_N, after_N;
};

/// What one cause does where it shows most: before_N without it, after_N with it, beside the causes
/// that were found before it.
struct CausePicture {
  std::string id;  ///< of the effect
  TracePicture trace;
};

/// What models leave of the input force in bins of the covariate that Remainder names, for one
/// direction: the mean over sessions of their mean residuals, and their standard deviation.
struct RemainderPicture {
  std::string covariate, unit;
  int direction = 1;  ///< 1 while pulling, -1 while letting go
  std::vector<double> centre, before_N, before_sd_N, after_N, after_sd_N;
};

/// What the nominal model gives where it is fitted to one session alone.
struct SessionRefit {
  std::string session;
  double friction_coefficient = 0;
  double log_gain = 0;
};

/// One specimen's life over the predicted one.
struct LifePoint {
  std::string specimen, lot;
  double effective_N = 0;
  double ratio_before = 0, ratio_after = 0;  ///< N over alpha of the model
  bool failed = true;
};

struct LifePicture {
  std::vector<LifePoint> points;
  double shape_before = 0, shape_after = 0;  ///< Weibull shape of the ratios
};

struct TensionDiagnosis {
  Findings findings;
  std::vector<std::string> faults;  ///< of sensors, whose samples were left out: in words
  std::vector<TracePicture> traces;
  std::vector<CausePicture> causes;  ///< of those of Findings::steps that lessen the error
  std::vector<RemainderPicture> remainders;
  std::vector<SessionRefit> session_refits;
  /// Damage of a recording as the nominal model books it over that of the extended one, geometric
  /// mean of the recordings; 1 where nothing was extended.
  double damage_ratio = 1;
  double friction_coefficient = 0;  ///< refitted, for the written model
  double log_gain = 0;              ///< refitted, of T_out over T_in
};

struct LifeDiagnosis {
  Findings findings;
  LifePicture picture;
  double b10_ratio = 1;  ///< B10 of the nominal model over that of the extended one, lowest level
  double ipl_scale = 0, ipl_exponent = 0, weibull_shape = 0;  ///< refitted, for the written model
};

/// A campaign holds recordings, lives or both.
struct Diagnosis {
  std::optional<TensionDiagnosis> tension;
  std::optional<LifeDiagnosis> lives;
  std::vector<std::string> warnings;  ///< faults of the data, in words

  /// Of both parts: unknown before ambiguous before named before none.
  [[nodiscard]] Verdict verdict() const;
};

struct DiagnoseOptions {
  std::uint64_t seed = 1;
  unsigned threads = 0;              ///< 0: all cores; the answer does not depend on it
  std::vector<std::string> without;  ///< effects that are taken out of the catalogue
  std::function<void(double share)> progress = nullptr;
};

/// @throws InputError where the campaign cannot be diagnosed, with what is missing
Diagnosis diagnose(const Campaign& campaign, const DiagnoseOptions& options);

/// Of the recordings alone.
TensionDiagnosis diagnose_tension(const Campaign& campaign, const DiagnoseOptions& options);

/// Of the lives alone.
LifeDiagnosis diagnose_lives(const Campaign& campaign, const DiagnoseOptions& options);

/// One part of a diagnosis.
struct DataFindings {
  std::string_view name;  ///< "recordings" or "lives"
  const Findings* findings = nullptr;
};

/// The parts that there are, recordings first. They point into `diagnosis`.
std::vector<DataFindings> findings_by_data(const Diagnosis& diagnosis);

/// The findings of both parts in one: lists one after the other, sentences joined. The gain is that
/// of the parts that were extended; a metric that both have stands for the recordings, that of the
/// lives gets the name "lives_...". The remainder is that of the recordings.
Findings merged(const Diagnosis& diagnosis);

}  // namespace host_sim::diagnose
