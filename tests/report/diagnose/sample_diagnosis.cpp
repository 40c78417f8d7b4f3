#include "tests/report/diagnose/sample_diagnosis.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "tests/report/diagnose/sample_pictures.hpp"

namespace host_sim::samples {
namespace {

using diagnose::Diagnosis;
using diagnose::Findings;
using diagnose::LifeDiagnosis;
using diagnose::TensionDiagnosis;
using diagnose::Verdict;

void add_common(Findings& findings) {
  findings.equivalent_sets = {{"compliance", "filter_lag"}};
  findings.invisible = {
      {"torque_ripple", "the motor angle was not recorded; record motor_angle_rad"},
      {"small_cycles", "it changes no tension; sweep the threshold of the counter"}};
  findings.refitted = {{"friction_coefficient", "1", 0.131, 0.127, 0.135},
                       {"log_gain", "1", -0.004, -0.012, 0.004}};
}

TensionDiagnosis recordings(double wear) {
  TensionDiagnosis tension;
  add_common(tension.findings);
  add_traces(tension, wear);
  add_remainders(tension, wear);
  tension.friction_coefficient = 0.131;
  tension.log_gain = -0.004;
  return tension;
}

void name_wear(TensionDiagnosis& tension) {
  Findings& findings = tension.findings;
  findings.verdict = Verdict::named;
  findings.prose =
      "Friction grows with the cycles, in proportion to the bend angle. With wear in the model the "
      "residual is noise again.";
  findings.effects = {
      {"friction_wear",
       "wear or run-in of the sheath",
       "mu(n) = mu (1 + a (n/1000)^p), or mu (1 + a exp(-n/n0)) where p = 0",
       "the amplitude (13) grows with mu phi as the sheath wears, so that later "
       "cycles do more damage than Miner books for new ones",
       0.987,
       {{"wear_coefficient", "1", 0.152, 0.139, 0.166}, {"wear_exponent", "1", 1, 0.8, 1.2}}}};
  findings.candidates = {{"friction_wear", 0.987},
                         {"friction_temperature", 0.006},
                         {"torque_gain", 0.004},
                         {"unknown", 0.002},
                         {"none", 0.001}};
  findings.credible_set = {"friction_wear"};
  findings.gain = {"session",
                   {{"rmse_N", 1.21, 0.31},
                    {"log_predictive_density", 2.04, 3.12},
                    {"damage_error_percent", 14.2, 1.1}}};
  findings.discrepancies = {{"cycle", 9.8, 0.0002, 0.41},
                            {"sheath_temperature", 2.1, 0.22, 0.37},
                            {"velocity", 1.4, 0.61, 0.58}};
  findings.extensions = {
      {"friction_wear", {{"wear_coefficient", {0.152}}, {"wear_exponent", {1}}}}};
  tension.damage_ratio = 0.88;
}

LifeDiagnosis lots() {
  LifeDiagnosis lives;
  add_points(lives, 0.25);
  Findings& findings = lives.findings;
  findings.verdict = Verdict::named;
  findings.prose = "Lots differ by more than the scatter of specimens.";
  findings.effects = {{"lot_frailty",
                       "batch-to-batch scatter",
                       "ln alpha of a lot is normal with standard deviation sigma",
                       "B10 of a lot that was not tested is shorter than of those that were",
                       0.973,
                       {{"lot_log_sd", "1", 0.24, 0.11, 0.52}}}};
  findings.candidates = {{"lot_frailty", 0.973}, {"second_mode", 0.02}, {"none", 0.007}};
  findings.credible_set = {"lot_frailty"};
  findings.gain = {"level", {{"log_predictive_density", -0.21, 0.18}, {"b10_coverage", 0.21, 0.1}}};
  findings.discrepancies = {{"lot", 21.3, 0.0006, 0.52}, {"level", 3.2, 0.31, 0.33}};
  findings.refitted = {{"ipl_scale", "cycles", 2.01e5, 1.5e5, 2.7e5},
                       {"ipl_exponent", "1", 1.45, 1.38, 1.52},
                       {"weibull_shape", "1", 5.8, 4.6, 7.2}};
  findings.invisible = {{"bending_fatigue", "all wires run over one diameter; test two"}};
  findings.extensions = {{"lot_frailty", {{"lot_log_sd", {0.24}}}}};
  lives.b10_ratio = 1.31;
  lives.ipl_scale = 2.01e5;
  lives.ipl_exponent = 1.45;
  lives.weibull_shape = 5.8;
  return lives;
}

std::string hostile_name() {
  return "</script><script>throw 1</script><plaintext><img src=x onerror='throw 2'>"
         "\" onclick='throw 3' {{title}} &lt; Überlast 腕 \xff";
}

}  // namespace

Diagnosis wear_named() {
  Diagnosis diagnosis;
  diagnosis.tension = recordings(0.3);
  name_wear(*diagnosis.tension);
  diagnosis.warnings = {
      "session s4, output_tension_N: saturated at 120 N from sample 812 on, 14 "
      "samples; they are left out"};
  return diagnosis;
}

Diagnosis outside_of_catalogue() {
  Diagnosis diagnosis = wear_named();
  Findings& findings = diagnosis.tension->findings;
  findings.prose = "The load cell has a zero of its own.";
  findings.effects = {{"zero_of_rig",
                       "zero of the load cell of the rig",
                       "T_out + b",
                       "none: the tendon does not see it",
                       0.99,
                       {{"output_zero_N", "N", 0.4, 0.3, 0.5}}}};
  findings.candidates = {{"zero_of_rig", 0.99}, {"slack+zero_of_rig", 0.01}};
  findings.credible_set = {"zero_of_rig"};
  findings.equivalent_sets = {{"slack", "zero_of_rig"}};
  findings.invisible.push_back({"never_heard_of", "nobody knows"});
  findings.extensions.clear();
  findings.remainder = {0.12, 2.4, 1.1, "travel_since_reversal", 0.005};
  return diagnosis;
}

Diagnosis nothing_wrong() {
  Diagnosis diagnosis;
  diagnosis.tension = recordings(0);
  Findings& findings = diagnosis.tension->findings;
  findings.prose = "The residual is what noise and the scatter of sessions give.";
  findings.candidates = {{"none", 0.991}, {"friction_wear", 0.005}, {"unknown", 0.004}};
  findings.credible_set = {"none"};
  findings.discrepancies = {{"cycle", 1.9, 0.43, 0.43}};
  return diagnosis;
}

Diagnosis ambiguous_pair() {
  Diagnosis diagnosis;
  diagnosis.tension = recordings(0.15);
  Findings& findings = diagnosis.tension->findings;
  findings.verdict = Verdict::ambiguous;
  findings.prose = "Pulling and letting go differ. At one pose two causes give the same.";
  findings.candidates = {{"gear_asymmetry", 0.56},
                         {"bend_angle", 0.41},
                         {"friction_preload+gear_asymmetry", 0.02},
                         {"none", 0.01}};
  findings.credible_set = {"gear_asymmetry", "bend_angle"};
  findings.equivalent_sets = {{"bend_angle", "gear_asymmetry"}};
  findings.effects = {{"gear_asymmetry",
                       "direction-dependent gear efficiency",
                       "T_in (1 + c s)",
                       "peaks are higher than booked",
                       0.56,
                       {{"gear_log_asymmetry", "1", 0.021, 0.011, 0.031}}}};
  findings.next_experiment = "record at several bend angles";
  findings.discrepancies = {{"direction", 6.2, 0.002, 0.002}};
  return diagnosis;
}

Diagnosis unexplained() {
  Diagnosis diagnosis = ambiguous_pair();
  Findings& findings = diagnosis.tension->findings;
  findings.verdict = Verdict::unknown;
  findings.prose = "A structure at 7 Hz is left by every candidate and pair of candidates.";
  findings.effects.clear();
  findings.candidates = {{"unknown", 0.98}, {"torque_ripple", 0.02}};
  findings.credible_set = {"unknown"};
  findings.next_experiment = "repeat one session with a second load cell";
  return diagnosis;
}

Diagnosis explained_in_part() {
  Diagnosis diagnosis = unexplained();
  Findings& findings = diagnosis.tension->findings;
  const auto step = [](const char* id, double output_N, double input_N) {
    diagnose::Step one;
    one.effect.id = id;
    one.effect.probability = 0.99;
    one.output_rmse_N = output_N;
    one.input_rmse_N = input_N;
    one.sessions_better = 5;
    one.sessions = 6;
    return one;
  };
  diagnosis.tension->remainders = {
      {"speed", "m/s", 1, {0.1, 0.2}, {4, 6}, {1, 1}, {1, -1}, {1, 1}},
      {"speed", "m/s", -1, {0.1, 0.2}, {-4, -6}, {1, 1}, {-1, 1}, {1, 1}}};
  diagnosis.tension->session_refits = {{"s1", 0.12, 0.01}, {"s2", 0.15, -0.02}};
  findings.steps = {step("", 8.4, 5.8), step("slack", 6.7, 4.2),
                    step("friction_position", 5.9, 3.9)};
  return diagnosis;
}

Diagnosis lots_named() {
  Diagnosis diagnosis;
  diagnosis.lives = lots();
  return diagnosis;
}

Diagnosis both_named() {
  Diagnosis diagnosis = wear_named();
  diagnosis.lives = lots();
  return diagnosis;
}

Diagnosis hostile_diagnosis() {
  Diagnosis diagnosis = both_named();
  const std::string name = hostile_name();
  diagnosis.warnings = {name};
  for (Findings* findings : {&diagnosis.tension->findings, &diagnosis.lives->findings}) {
    findings->prose = name;
    findings->next_experiment = name;
    findings->effects[0].id = name;
    findings->effects[0].term = name;
    findings->effects[0].equation = name;
    findings->effects[0].life_consequence = name;
    findings->effects[0].parameters[0].name = name;
    findings->effects[0].parameters[0].unit = name;
    findings->candidates[0].id = name;
    findings->credible_set[0] = name;
    findings->equivalent_sets = {{name, name}};
    findings->invisible = {{name, name}};
    findings->gain.held_out_by = name;
    findings->gain.metrics[0].name = name;
    findings->discrepancies[0].covariate = name;
    findings->refitted[0].name = name;
  }
  diagnosis.tension->findings.remainder = {0.5, 1, 1, name, 0.5};
  diagnosis.tension->traces[0].session = name;
  diagnosis.tension->remainders[0].covariate = name;
  diagnosis.tension->remainders[0].unit = name;
  diagnosis.lives->picture.points[0].lot = name;
  diagnosis.lives->picture.points[1].specimen = name;
  return diagnosis;
}

std::vector<DiagnosisSample> all_diagnoses() {
  Diagnosis bare;
  bare.tension.emplace();
  bare.lives.emplace();
  Diagnosis broken = both_named();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  broken.tension->findings.effects[0].parameters[0] = {"wear_coefficient", "1", kNone, kNone,
                                                       std::numeric_limits<double>::infinity()};
  broken.tension->findings.discrepancies[0] = {"cycle", kNone, kNone, kNone};
  broken.tension->findings.candidates[0].probability = kNone;
  broken.tension->findings.remainder = {kNone, kNone, kNone, "cycle", kNone};
  broken.tension->traces[0].before_N[3] = kNone;
  broken.tension->remainders[0].after_N[2] = kNone;
  // Each of the four sessions has a trace and a loop, each remainder a plot; a gain or steps of
  // recordings have one, and lives three.
  return {{"typical", 13, "crossed test of the upper arm", wear_named()},
          {"none", 12, "upper arm, new sheath", nothing_wrong()},
          {"outside", 13, "upper arm, load cell with a zero", outside_of_catalogue()},
          {"ambiguous", 12, "field log at one pose", ambiguous_pair()},
          {"unknown", 12, "upper arm, second rig", unexplained()},
          {"steps", 13, "upper arm, third rig", explained_in_part()},
          {"lives", 3, "three lots", lots_named()},
          {"both", 16, "upper arm, complete", both_named()},
          {"hostile", 15, hostile_name(), hostile_diagnosis()},
          {"bare", 0, "bare", bare},
          {"broken", 16, "not a number", broken},
          {"empty", 0, "", {}}};
}

}  // namespace host_sim::samples
