#include "host_sim/io/json.hpp"

#include "host_sim/calibrate/output/output.hpp"

namespace host_sim::calibrate {
namespace {

using nlohmann::ordered_json;
using statistics::Family;
using statistics::FitProblem;

ordered_json pair(const Interval& interval) {
  return ordered_json::array({json_number(interval.low), json_number(interval.high)});
}

ordered_json test_json(const Test& test) {
  return {{"statistic", json_number(test.statistic)},
          {"df", json_number(test.degrees_of_freedom)},
          {"p", json_number(p_of(test))},
          {"p_chi_square", json_number(test.p_chi_square)},
          {"p_simulated", json_number(test.p_simulated)}};
}

ordered_json test_json(const std::optional<Test>& test) {
  return test ? test_json(*test) : ordered_json(nullptr);
}

ordered_json load_json(const Campaign::Load& load) {
  return {{"bend_angle_deg",
           load.bend_angle_deg ? json_number(*load.bend_angle_deg) : ordered_json(nullptr)},
          {"input_tension_mean_N", json_number(load.input_tension_mean_N)},
          {"input_tension_amplitude_N", json_number(load.input_tension_amplitude_N)},
          {"effective_tension_N", json_number(load.effective_tension_N)}};
}

/// The names of the parameters of each family.
struct ParameterNames {
  const char* first;
  const char* second;
};

ParameterNames parameter_names(Family family) {
  switch (family) {
    case Family::normal:
      return {"mean", "standard_deviation"};
    case Family::lognormal:
      return {"mean_of_ln", "standard_deviation_of_ln"};
    case Family::weibull:
      break;
  }
  return {"scale", "shape"};
}

ordered_json fit_json(const statistics::Fit& fit, Family family) {
  if (fit.problem != FitProblem::none) {
    return {{"problem", problem_name(fit.problem)}};
  }
  const ParameterNames names = parameter_names(family);
  return {{names.first, json_number(fit.distribution.first)},
          {names.second, json_number(fit.distribution.second)},
          {"log_likelihood", json_number(fit.log_likelihood)}};
}

ordered_json goodness_json(const std::optional<statistics::GoodnessOfFit>& goodness) {
  if (!goodness) {
    return nullptr;
  }
  return {{"ks", json_number(goodness->ks)},
          {"ks_p", json_number(goodness->ks_p)},
          {"ad", json_number(goodness->ad)},
          {"ad_p", json_number(goodness->ad_p)}};
}

ordered_json probability_plot_json(const LevelResult& level) {
  ordered_json band = ordered_json::array();
  for (std::size_t i = 0; i < level.band.p.size(); ++i) {
    band.push_back(
        {{"p", level.band.p[i]}, {"ci95", pair({level.band.low.at(i), level.band.high.at(i)})}});
  }
  return {
      {"positions",
       json_list(level.positions,
                 [](const statistics::PlottingPosition& at) {
                   return ordered_json{{"life", json_number(at.life)}, {"p", json_number(at.p)}};
                 })},
      {"band", band}};
}

ordered_json level_json(const LevelResult& level) {
  const statistics::Fit& weibull = level.weibull();
  const bool fitted = weibull.problem == FitProblem::none;
  const auto if_fitted = [fitted](double value) { return fitted ? json_number(value) : nullptr; };
  ordered_json json{{"name", level.name()},
                    {"role", level.role == Campaign::Role::fit ? "fit" : "validation"}};
  json.update(load_json(level.load));
  json["n"] = level.sample.size();
  json["failed"] = level.failed();
  json["suspended"] = level.sample.size() - level.failed();
  json["found_broken"] = level.found_broken();
  json["trimmed"] = level.trimmed();
  json["scale"] = if_fitted(weibull.distribution.first);
  json["shape"] = if_fitted(weibull.distribution.second);
  json["shape_unbiased"] = if_fitted(level.shape_unbiased);
  json["mean_life"] = if_fitted(level.mean_life);
  for (const Family family : {Family::normal, Family::lognormal, Family::weibull}) {
    const auto at = static_cast<std::size_t>(family);
    json["fits"][family_name(family)] = fit_json(level.fits[at], family);
    json["goodness_of_fit"][family_name(family)] = goodness_json(level.goodness[at]);
  }
  const std::optional<Family> best = best_family(level);
  json["best_family"] = best ? ordered_json(family_name(*best)) : ordered_json(nullptr);
  json["left_out"] = level.left_out.empty() ? ordered_json(nullptr) : ordered_json(level.left_out);
  json["lives"] = json_list(level.sample, [](const statistics::Observation& life) {
    ordered_json seen{{"cycles", json_number(life.value)}, {"failed", life.failed}};
    if (life.from) {
      seen["cycles_from"] = json_number(*life.from);
    }
    if (life.trimmed) {
      seen["trimmed"] = true;
    }
    return seen;
  });
  json["probability_plot"] = probability_plot_json(level);
  return json;
}

ordered_json common_shape_json(const CommonShape& shape) {
  return {{"value", json_number(shape.value)},
          {"ci95", pair(shape.ci95)},
          {"unbiased", json_number(shape.unbiased)}};
}

ordered_json homogeneity_json(const CalibrateResult& result) {
  const CommonShape& shape = *result.common_shape;
  ordered_json json = test_json(shape.homogeneity);
  json["with_all_levels"] = test_json(shape.with_all_levels);
  json["odd_levels"] = json_list(shape.odd_levels, [&result](const OddLevel& odd) {
    ordered_json one = test_json(odd.test);
    one["level"] = result.levels.at(odd.level).name();
    one["p_corrected"] = json_number(odd.p_corrected);
    return one;
  });
  return json;
}

ordered_json law_json(const LifeLaw& law) {
  return {{"scale", json_number(law.scale)},
          {"exponent", json_number(law.exponent)},
          {"shape", json_number(law.shape)}};
}

ordered_json least_squares_json(const StressLife& life) {
  if (!life.least_squares) {
    return nullptr;
  }
  ordered_json json = law_json(*life.least_squares);
  json["rmse_cycles"] = json_number(life.least_squares_rmse);
  return json;
}

ordered_json band_json(const StressLife& life) {
  ordered_json json = ordered_json::array();
  for (std::size_t i = 0; i < life.band_tension_N.size(); ++i) {
    json.push_back({{"effective_tension_N", json_number(life.band_tension_N[i])},
                    {"ci95", pair(life.band_mean.at(i))}});
  }
  return json;
}

ordered_json ipl_json(const StressLife& life) {
  ordered_json json = law_json(life.law);
  json["ci95_scale"] = pair(life.scale_ci95);
  json["ci95_exponent"] = pair(life.exponent_ci95);
  json["ci95_shape"] = pair(life.shape_ci95);
  json["pivot_tension_N"] = json_number(life.pivot_tension_N);
  json["ci95_life_at_pivot"] = pair(life.life_at_pivot_ci95);
  json["shape_unbiased"] = json_number(life.shape_unbiased);
  json["method"] = "maximum likelihood";
  json["least_squares"] = least_squares_json(life);
  json["adequacy"] = {{"against_free_levels", test_json(life.against_free_levels)},
                      {"against_curvature", test_json(life.against_curvature)},
                      {"against_growing_scatter", test_json(life.against_growing_scatter)}};
  json["mean_life_band"] = band_json(life);
  return json;
}

ordered_json use_json(const UseLevel& use) {
  return {{"name", use.name},
          {"effective_tension_N", json_number(use.effective_tension_N)},
          {"mean", json_number(use.mean)},
          {"ci95_mean", pair(use.mean_ci95)},
          {"B10", json_number(use.b10)},
          {"ci95_B10", pair(use.b10_ci95)},
          {"B50", json_number(use.b50)},
          {"B90", json_number(use.b90)},
          {"next_specimen_95", pair(use.next_specimen_95)}};
}

ordered_json validation_json(const CalibrateResult& result, const ValidationResult& validation) {
  ordered_json json{{"level", validation_name(result, validation)}};
  if (!validation.in_blocks) {
    json.update(load_json(result.levels.at(validation.level).load));
  }
  json["predicted_mean"] = json_number(validation.predicted_mean);
  json["measured_mean"] = json_number(validation.measured_mean);
  json["ci95_true_over_predicted"] = pair(validation.ratio_ci95);
  json["p"] = json_number(validation.p);
  json["below_B10"] = validation.below_b10;
  json["inside_B10_B90"] = validation.inside_b10_b90;
  json["above_B90"] = validation.above_b90;
  json["words"] = validation.words;
  return json;
}

ordered_json mix_json(const MixResult& mix) {
  return {{"name", mix.name},
          {"parts", json_list(mix.parts,
                              [](const MixResult::Part& part) {
                                return ordered_json{
                                    {"effective_tension_N", json_number(part.effective_tension_N)},
                                    {"share", json_number(part.share)}};
                              })},
          {"by_damage_N", json_number(mix.by_damage_N)},
          {"by_average_of_lives_N", json_number(mix.by_average_of_lives_N)}};
}

}  // namespace

std::string calibrate_json(const CalibrateResult& result, int indent) {
  const bool shape = result.common_shape.has_value();
  const bool life = result.stress_life.has_value();
  const ordered_json json{
      {"campaign", result.campaign},
      {"specimens", result.specimens},
      {"failed", result.failed},
      {"suspended", result.suspended},
      {"in_blocks", result.in_blocks},
      {"levels", json_list(result.levels, level_json)},
      {"common_shape", shape ? common_shape_json(*result.common_shape) : ordered_json(nullptr)},
      {"shape_homogeneity", shape ? homogeneity_json(result) : ordered_json(nullptr)},
      {"ipl", life ? ipl_json(*result.stress_life) : ordered_json(nullptr)},
      {"log_likelihood",
       life ? json_number(result.stress_life->log_likelihood) : ordered_json(nullptr)},
      {"use_levels", json_list(result.use_levels, use_json)},
      {"validation",
       json_list(result.validation,
                 [&](const ValidationResult& v) { return validation_json(result, v); })},
      {"mixes", json_list(result.mixes, mix_json)},
      {"findings", found_in(result)},
      {"seed", result.seed},
      {"bootstraps", result.bootstraps},
      {"warnings", result.warnings},
  };
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace host_sim::calibrate
