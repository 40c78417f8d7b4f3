#include "tests/diagnose/output/hand_made_diagnosis.hpp"

namespace host_sim_test {

using host_sim::diagnose::Diagnosis;
using host_sim::diagnose::Findings;
using host_sim::diagnose::LifeDiagnosis;
using host_sim::diagnose::Remainder;
using host_sim::diagnose::TensionDiagnosis;
using host_sim::diagnose::Verdict;

TensionDiagnosis wear_in_recordings() {
  TensionDiagnosis tension;
  Findings& findings = tension.findings;
  findings.verdict = Verdict::named;
  findings.effects = {{"friction_wear",
                       "wear of the sheath",
                       "mu(n) = ...",
                       "later cycles do more",
                       0.987,
                       {{"wear_coefficient", "1", 0.152, 0.139, 0.166}}}};
  findings.candidates = {{"friction_wear", 0.987}, {"none", 0.013}};
  findings.credible_set = {"friction_wear"};
  findings.equivalent_sets = {{"compliance", "filter_lag"}};
  findings.invisible = {{"torque_ripple", "record the motor angle"}};
  findings.next_experiment = "sweep the frequency";
  findings.gain = {"session", {{"rmse_N", 1.5, 0.5}, {"log_predictive_density", 2, 3}}};
  findings.discrepancies = {{"cycle", 9.8, 0.0002, 0.41}};
  findings.refitted = {{"friction_coefficient", "1", 0.131, 0.127, 0.135}};
  findings.extensions = {
      {"friction_wear",
       {{"wear_coefficient", {0.152}}, {"wear_exponent", {0.5}}, {"run_in_cycles", {0}}}}};
  findings.prose = "Friction grows.";
  tension.damage_ratio = 0.8;
  tension.friction_coefficient = 0.131;
  tension.log_gain = 0.0198026272961797;  // ln 1.02
  return tension;
}

LifeDiagnosis lots_in_lives() {
  LifeDiagnosis lives;
  Findings& findings = lives.findings;
  findings.verdict = Verdict::named;
  findings.effects = {{"lot_frailty",
                       "lots",
                       "sigma",
                       "B10 is short",
                       0.973,
                       {{"lot_log_sd", "1", 0.24, 0.1, 0.5}}}};
  findings.candidates = {{"lot_frailty", 0.973}, {"second_mode", 0.027}};
  findings.credible_set = {"lot_frailty"};
  findings.invisible = {{"bending_fatigue", "test two diameters"}};
  findings.next_experiment = "test more lots";
  findings.gain = {"level", {{"log_predictive_density", -0.2, 0.1}, {"b10_coverage", 0.21, 0.1}}};
  findings.discrepancies = {{"lot", 21, 0.0006, 0.52}};
  findings.extensions = {{"lot_frailty", {{"lot_log_sd", {0.24}}}}};
  findings.prose = "Lots differ.";
  lives.picture.shape_before = 3.9;
  lives.picture.shape_after = 5.8;
  lives.b10_ratio = 1.25;
  lives.ipl_scale = 2.01e5;
  lives.ipl_exponent = 1.45;
  lives.weibull_shape = 5.8;
  return lives;
}

Remainder left_over_position() {
  return {0.12, 2.4, 1.1, "position", 0.005};
}

TensionDiagnosis zero_of_rig() {
  TensionDiagnosis tension = wear_in_recordings();
  Findings& findings = tension.findings;
  findings.effects = {{"zero_of_rig",
                       "zero of the rig",
                       "T_out + b",
                       "none",
                       0.99,
                       {{"output_zero_N", "N", 0.4, 0.3, 0.5}}}};
  findings.candidates = {{"zero_of_rig", 0.99}, {"slack+zero_of_rig", 0.01}};
  findings.credible_set = {"zero_of_rig"};
  findings.equivalent_sets = {{"slack", "zero_of_rig"}};
  findings.extensions = {{"zero_of_rig", {{"output_zero_N", {0.4}}}}};
  return tension;
}

Diagnosis both_parts() {
  Diagnosis diagnosis;
  diagnosis.tension = wear_in_recordings();
  diagnosis.lives = lots_in_lives();
  diagnosis.warnings = {"session s4: saturated"};
  return diagnosis;
}

}  // namespace host_sim_test
