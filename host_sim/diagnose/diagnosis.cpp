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
