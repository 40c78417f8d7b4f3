#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"
#include "host_sim/diagnose/lives/life_settings.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim::diagnose::lives {

/// A parameter as the fits see it: a coordinate u with a standard normal prior. Its value is
/// minimum + (maximum - minimum) logistic(centre + spread u), or centre + spread u where it has no
/// bounds.
struct TermParameter {
  std::string name;  ///< with its unit as suffix
  std::string unit;
  bool bounded = false;
  double minimum = 0, maximum = 0;
  double centre = 0, spread = 1;

  [[nodiscard]] double value(double u) const;
};

/// One departure from the nominal law in one form: an effect of the catalogue, or what stands for
/// all that the catalogue does not have.
struct Term {
  std::string id;  ///< of the effect; of what is outside the covariate it shows against
  bool outside = false;
  double ln_weight = 0;    ///< of this form among those of its id
  std::string law = {};    ///< of mean stress, by its author
  std::string words = {};  ///< the form, in place of the effect's own term; empty for that
  std::vector<TermParameter> parameters = {};
  std::function<void(std::span<const double> values, LifeSettings& settings)> apply = nullptr;
  /// Values for the table of an extension, in order of the effect's parameters.
  std::function<std::vector<double>(std::span<const double> values, const LifeSettings& settings)>
      of_catalogue = nullptr;
  /// What the equation needs beside the parameters, for the table of an extension too.
  std::vector<Extension::Value> companions = {};
};

/// The parameter of an effect by its name, with the prior about its typical size: `spread` is that
/// of the logistic coordinate.
/// @throws std::out_of_range where the effect has none of that name
TermParameter parameter_of(const effects::LifeEffect& effect, std::string_view name, double spread);

/// A shift without bounds, normal about 0.
TermParameter shift(std::string name, double sd);

/// The effect of that id. @throws std::out_of_range
const effects::LifeEffect& life_effect(std::string_view id);

/// What no effect says, one for each covariate that the campaign has.
std::vector<Term> outside_terms(const LifeSample& sample);

/// The forms of one effect. @throws std::out_of_range
std::vector<Term> terms_of(const std::string& effect, const LifeSample& sample);

}  // namespace host_sim::diagnose::lives
