#pragma once

#include <map>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "host_sim/diagnose/lives/fit.hpp"

namespace host_sim::diagnose::lives {

/// What turns evidence into probabilities that come true as often as they say. Fitted on campaigns
/// that were simulated for it, see calibration.cpp.
struct Calibration {
  double power = 1;  ///< of the evidence
  /// ln of the prior odds against nothing being wrong: of all single effects together, of all pairs
  /// and of all that is outside.
  double ln_single = 0, ln_pair = 0, ln_outside = 0;
  /// ln of the prior odds of an effect against the mean of those that a campaign can show; of a
  /// pair both count. 0 where an effect has none.
  std::map<std::string, double> ln_weights = {};

  [[nodiscard]] double ln_weight(const std::string& effect) const;
};

const Calibration& calibration();

/// One explanation of the lives, in all of its forms.
struct Hypothesis {
  struct Form {
    Model model;
    ModelFit fit;
    double ln_weight = 0;
    std::vector<Eigen::VectorXd> starts = {};  ///< coordinates to fit from
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
