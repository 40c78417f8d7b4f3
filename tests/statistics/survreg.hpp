#pragma once

#include <span>
#include <string>
#include <vector>

namespace host_sim::survreg {

/// A specimen with one covariate.
struct Row {
  double life = 0;
  bool failed = true;
  double x = 0;
};

/// What R's survreg found. For the Weibull distribution, scale is 1 / beta and the coefficients are
/// those of ln alpha.
struct Fit {
  double log_likelihood = 0;
  double scale = 0;
  std::vector<double> coefficients;
};

/// Whether Rscript with package survival is installed.
bool available();

/// Fits with each distribution of survreg ("weibull", "lognormal", "gaussian"). `formula` is the
/// right-hand side: "1", "x", "x + I(x^2)", "factor(x)".
/// @throws std::runtime_error where R does not answer with one fit for each
std::vector<Fit> fit(std::span<const Row> rows, const std::string& formula,
                     std::span<const std::string> distributions);

/// The Weibull fit with each of several formulas.
/// @throws std::runtime_error where R does not answer with one fit for each
std::vector<Fit> fit_weibull(std::span<const Row> rows, std::span<const std::string> formulas);

}  // namespace host_sim::survreg
