#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/calibration.hpp"
#include "host_sim/diagnose/lives/fit.hpp"

namespace host_sim::diagnose::lives {

/// One explanation of the lives, in all of its forms.
struct Hypothesis {
  struct Form {
    Model model;
    ModelFit fit;
    double ln_weight = 0;
  };
  std::vector<std::string> effects;  ///< ids, rising; none where nothing is wrong
  bool outside = false;              ///< nothing of the catalogue, then `effects` has its covariate
  std::vector<Form> forms;           ///< the most probable first
  double log_evidence = 0;           ///< averaged over the forms
  double probability = 0;            ///< of all, calibrated

  [[nodiscard]] const Form& best() const { return forms.front(); }
  /// "none", "unknown", an effect or two joined by "+".
  [[nodiscard]] std::string id() const;
};

/// Every explanation that the catalogue and the covariates of a campaign allow: nothing, each
/// effect, the most probable effects with each other one, and what is outside of the catalogue.
/// Most probable first.
/// @param visible ids of the effects that take part
std::vector<Hypothesis> weigh(const LifeSample& sample, const std::vector<std::string>& visible,
                              const Calibration& calibration, unsigned threads);

/// Probabilities from the evidence; sorts by them.
void calibrate(std::vector<Hypothesis>& hypotheses, const Calibration& calibration);

}  // namespace host_sim::diagnose::lives
