#pragma once

#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/blind/generator/scenario.hpp"
#include "tests/blind/scoring/record.hpp"

namespace blind {

/// Judges one answer against what was hidden.
class Judgement {
 public:
  explicit Judgement(const Record& record) : record_(record), answer_(answer_of(record.truth)) {}

  /// The most probable candidate; empty without any.
  [[nodiscard]] std::string first() const;
  [[nodiscard]] double first_probability() const;
  /// Whether each effect of it is hidden.
  [[nodiscard]] bool first_is_hidden() const;

  /// Whether that is the truth: none, an effect, both of two, or unknown for what is from outside.
  [[nodiscard]] bool right_first() const { return first() == answer_; }

  /// Also right where the analysis says ambiguous and counts the truth and its first candidate
  /// among one class of equivalent causes.
  [[nodiscard]] bool right_class() const;

  [[nodiscard]] bool named() const;
  /// Whether each effect that is named is hidden. @pre named()
  [[nodiscard]] bool named_right() const;
  /// Whether all that is hidden is named, and nothing else.
  [[nodiscard]] bool named_all() const;

  [[nodiscard]] bool unknown() const;
  /// Whether the 95 % set holds the truth.
  [[nodiscard]] bool covered() const;
  [[nodiscard]] std::size_t set_size() const { return record_.findings.credible_set.size(); }

  /// Whether an oracle sees each hidden effect at so many standard deviations.
  [[nodiscard]] bool visible_at(double sigmas) const;

 private:
  [[nodiscard]] bool hides(const std::string& id) const;

  const Record& record_;
  std::string answer_;
};

/// A parameter of the catalogue with its true value.
struct TrueParameter {
  std::string name;
  double value = 0;
};

/// What the hidden effect means in parameters of the catalogue, those alone that mean the same in
/// the simulation: none for an effect that the catalogue has in another form.
std::vector<TrueParameter> true_parameters(const HiddenEffect& effect);

/// One estimate against the truth.
struct ParameterScore {
  double relative_error = 0;  ///< |estimate - truth| / |truth|
  bool covered = false;       ///< by the 95 % interval
};

/// Of those parameters that the effect was found with.
std::vector<ParameterScore> score_parameters(const std::vector<TrueParameter>& truth,
                                             const host_sim::diagnose::FoundEffect& found);

}  // namespace blind
