#include "host_sim/diagnose/force/extended_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/extension/model_file.hpp"
#include "host_sim/reference/reference.hpp"

namespace host_sim::diagnose {

ExtendedModel ModelExtension::corrected(ExtendedModel model) const {
  model.correction = correction_of(data_, model.fit, model.held_N, covariates_, rotor_known());
  if (model.correction) {
    model.held_N = model.correction->held_N;
  }
  return model;
}

ExtendedModel ModelExtension::written(const ExtendedModel& model) const {
  ForceFit fit = model.fit;
  for (std::size_t i = 0; i < fit.terms.size();) {
    if (is_writable(fit, i)) {
      ++i;
    } else {
      fit = in_a_written_model(fit, i);
    }
  }
  return fit.terms == model.fit.terms ? model : corrected({fit, data_.held_out(fit).residuals_N});
}

ForceFit ModelExtension::in_a_written_model(const ForceFit& model, std::size_t place) const {
  ForceFit without = data_.without(model, place);
  std::vector<effects::ForceTerm> others;
  for (const effects::ForceTerm law : effects::kForceTerms) {
    if (same_effect(law, model.terms[place]) && is_shown(law, data_.records())) {
      others.push_back(law);
    }
  }
  const auto judged = std::ranges::find(search_.judged(), model.terms[place], &Judged::term);
  if (judged != search_.judged().end()) {
    for (const Judged::Other& other : judged->others) {
      others.push_back(other.term);
    }
  }
  std::erase(others, model.terms[place]);
  for (const effects::ForceTerm other : others) {
    if (!has_table(other)) {
      continue;
    }
    ForceFit with_other = data_.with(without, other, 1);
    if (is_writable(with_other, with_other.terms.size() - 1)) {
      return with_other;
    }
  }
  return without;
}

/// A controller knows the position by its rotor alone.
bool ModelExtension::rotor_known() const {
  return std::ranges::all_of(data_.records(), &effects::ForceRecord::rotor_known);
}

bool ModelExtension::has_table(effects::ForceTerm term) const {
  return law_of(term).written != nullptr && (term != effects::ForceTerm::position || rotor_known());
}

bool ModelExtension::is_writable(const ForceFit& model, std::size_t place) const {
  const effects::ForceTerm term = model.terms[place];
  return has_table(term) &&
         is_within_bounds(*written_term(
             term, parameters_at(place, model.terms, model.parameters, data_.scales()),
             data_.scales()));
}

/// What the correction adds at a sample.
double ModelExtension::added_N(const ExtendedModel& model, std::size_t record,
                               std::size_t i) const {
  return model.correction ? model.correction->table.at_N(
                                covariates_[model.correction->covariate].values[record][i],
                                data_.records()[record].velocity_m_s[i] < 0)
                          : 0;
}

std::vector<std::vector<double>> ModelExtension::left_N(const ExtendedModel& model) const {
  std::vector<std::vector<double>> residuals_N = data_.residuals_N(model.fit);
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    for (std::size_t i = 0; i < residuals_N[j].size(); ++i) {
      residuals_N[j][i] -= data_.records()[j].used[i] ? added_N(model, j, i) : 0;
    }
  }
  return residuals_N;
}

double ModelExtension::output_rmse_N(const ExtendedModel& model) const {
  constexpr double kStep = 1e-3;
  const effects::ForceScales& scales = data_.scales();
  const double step_N = kStep * scales.force_N;
  const std::vector<std::vector<double>> residuals_N = left_N(model);
  double square_N2 = 0;
  std::vector<double> at;
  std::vector<double> above;
  for (std::size_t j = 0; j < data_.records().size(); ++j) {
    effects::ForceRecord moved = data_.records()[j];
    moved.used[0] = false;  // that it begins as it was read would take the step off again
    const effects::Kinematics& kinematics = data_.kinematics()[j];
    predict_input(moved, kinematics, model.fit.terms, scales, model.fit.parameters, at);
    for (double& output_N : moved.output_N) {
      output_N += step_N;
    }
    predict_input(moved, kinematics, model.fit.terms, scales, model.fit.parameters, above);
    for (std::size_t i = 0; i < at.size(); ++i) {
      constexpr double kLeastSlope = 0.05;
      const double slope = std::max((above[i] - at[i]) / step_N, kLeastSlope);
      square_N2 += residuals_N[j][i] * residuals_N[j][i] / (slope * slope);
    }
  }
  return std::sqrt(square_N2 / data_.samples());
}

double ModelExtension::damage_ratio(const ExtendedModel& model,
                                    const reference::Constants& constants) const {
  double sum = 0;
  double sessions = 0;
  std::vector<double> before;
  std::vector<double> after;
  const ForceFit& nominal = search_.nominal().fit;
  const effects::ForceScales& scales = data_.scales();
  for (std::size_t j = 0; j < data_.records().size(); ++j) {
    const effects::ForceRecord& record = data_.records()[j];
    const effects::Kinematics& kinematics = data_.kinematics()[j];
    predict_input(record, kinematics, nominal.terms, scales, nominal.parameters, before);
    predict_input(record, kinematics, model.fit.terms, scales, model.fit.parameters, after);
    for (std::size_t i = 0; i < after.size(); ++i) {
      after[i] += added_N(model, j, i);
    }
    const double damage_before = damage_of(before, constants);
    const double damage_after = damage_of(after, constants);
    if (damage_before > 0 && damage_after > 0) {
      sum += std::log(damage_before / damage_after);
      sessions += 1;
    }
  }
  return sessions > 0 ? std::exp(sum / sessions) : 1;
}

double damage_of(std::span<const double> tension_N, const reference::Constants& constants) {
  reference::Reference count(constants);
  for (const double value_N : tension_N) {
    count.push(value_N);
  }
  return count.reading().damage.total;
}

double written_friction(double friction, std::span<const Extension> extensions,
                        const effects::ForceScales& scales) {
  constexpr double kReference_N = 50;
  const Extension* const load = extension_of(extensions, "friction_load");
  return load == nullptr ? friction
                         : friction * std::pow(kReference_N / scales.force_N,
                                               -value_of(*load, "load_exponent"));
}

}  // namespace host_sim::diagnose
