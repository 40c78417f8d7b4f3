#include "host_sim/diagnose/diagnosis.hpp"

#include <algorithm>

namespace host_sim::diagnose {

std::string_view word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::named:
      return "named";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unknown:
      return "unknown";
  }
  return "";
}

bool gains(const Gain& gain) {
  const auto error = std::ranges::find(gain.metrics, "rmse_N", &Metric::name);
  if (error != gain.metrics.end()) {
    return error->after < error->before;
  }
  const auto density = std::ranges::find(gain.metrics, "log_predictive_density", &Metric::name);
  return density != gain.metrics.end() && density->after > density->before;
}

bool withdraw_what_does_not_gain(Findings& findings) {
  const bool withdrawn = findings.verdict == Verdict::named && !gains(findings.gain);
  if (withdrawn) {
    findings.verdict = Verdict::ambiguous;
    findings.extensions.clear();
  }
  return withdrawn;
}

std::string no_gain_words(const Findings& findings) {
  return findings.gain.metrics.empty() || gains(findings.gain)
             ? ""
             : " In the model it would not gain on data that the fit never saw: nothing was "
               "extended.";
}

Verdict Diagnosis::verdict() const {
  Verdict verdict = Verdict::none;
  if (tension) {
    verdict = tension->findings.verdict;
  }
  if (lives) {
    verdict = std::max(verdict, lives->findings.verdict);
  }
  return verdict;
}

}  // namespace host_sim::diagnose
