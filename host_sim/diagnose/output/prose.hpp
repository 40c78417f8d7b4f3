#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"

/// Sentences on a diagnosis, in ASCII, for the summary and the report alike.
namespace host_sim::diagnose {

/// A metric of the gain for people.
struct MetricDescription {
  std::string name;  ///< "error of the output tension (RMSE)"
  std::string unit;  ///< "N", "%" or none
  /// What a good value is: the lower the better, the higher, or near to a goal.
  enum class Good { low, high, goal } good = Good::low;
  double goal = 0;
};

/// A name that is not known stands for itself.
MetricDescription description_of(std::string_view metric);

/// Whether the extended model is better in this metric.
bool improved(const Metric& metric);

/// What the error of the nominal model costs: what it says of the damage of the recordings.
std::string cost_prose(const TensionDiagnosis& tension);

/// What it says of B10.
std::string cost_prose(const LifeDiagnosis& lives);

/// "friction_wear and slack" of the id of a candidate.
std::string candidate_prose(std::string_view id);

/// The field's words for the id of a candidate, from the catalogue: "backlash or dead zone"; what
/// "none" and "unknown" mean. An id that is not known stands for itself.
std::string term_of(std::string_view id);

/// The same, by the terms that effects of the findings bring along, which the catalogue may lack.
std::string term_of(std::string_view id, const Findings& findings);

/// "travel since reversal" of "travel_since_reversal".
std::string covariate_prose(std::string_view covariate);

/// "12 % of the squared error, 2.4 N of input tension, most against position (p 0.005)"; without
/// what is not known.
std::string remainder_prose(const Remainder& remainder);

/// "12 knots over travel by direction, input 2.4 N -> 1.9 N; no cause".
std::string correction_summary(const Correction& correction);

/// What distinguishes the effects of a set, pair by pair, as the catalogue has it from either side;
/// "; " between them. Empty where it has nothing.
std::string experiments_for(const std::vector<std::string>& ids);

}  // namespace host_sim::diagnose
