#include "host_sim/diagnose/audit/gram.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host_sim/statistics/parallel.hpp"

namespace host_sim::diagnose {
namespace {

using effects::ForceParameter;
using effects::ForceRecord;
using effects::ForceScales;
using effects::ForceTerm;
using Eigen::Index;

double value_of(const ForceParameter& parameter, std::size_t start) {
  const double begins = parameter.starts[std::min(start, parameter.starts.size() - 1)];
  return parameter.usual == 0 ? begins : std::copysign(1.0, begins) * parameter.usual;
}

/// A case for each start that a fit tries.
std::vector<GramLayout::Case> cases_of(ForceTerm term, const ForceScales& scales) {
  const std::vector<ForceParameter> parameters = parameters_of(term, scales);
  std::size_t starts = 0;
  double most = 1;
  for (const ForceParameter& parameter : parameters) {
    starts = std::max(starts, parameter.starts.size());
    if (parameter.usual != 0) {
      most = std::max({most, std::abs(parameter.minimum / parameter.usual),
                       std::abs(parameter.maximum / parameter.usual)});
    }
  }
  std::vector<GramLayout::Case> cases;
  for (std::size_t start = 0; start < starts; ++start) {
    GramLayout::Case& one =
        cases.emplace_back(GramLayout::Case{.term = term, .parameters = {}, .most = most});
    for (const ForceParameter& parameter : parameters) {
      one.parameters.push_back(value_of(parameter, start));
    }
    one.count = 1 + parameters.size();
  }
  return cases;
}

void add_cases(const effects::TensionEffect& effect, std::span<const ForceRecord> records,
               const ForceScales& scales, GramLayout& layout) {
  GramLayout::Effect added{.effect = &effect, .missing = {}, .cases = {}};
  if (records.empty()) {
    added.missing = "no recordings";
    layout.effects.push_back(std::move(added));
    return;
  }
  for (const ForceTerm term : effects::kForceTerms) {
    if (law_of(term).effect != &effect) {
      continue;
    }
    if (const std::string_view missing = missing_of(term, records); !missing.empty()) {
      added.missing = added.missing.empty() ? missing : added.missing;
      continue;
    }
    const bool first = added.cases.empty();
    std::ranges::move(cases_of(term, scales), std::back_inserter(added.cases));
    added.typical = first ? added.cases.size() / 2 : added.typical;
  }
  if (!added.cases.empty()) {
    added.missing.clear();
  }
  for (GramLayout::Case& one : added.cases) {
    one.first = layout.size;
    layout.size += one.count;
  }
  layout.effects.push_back(std::move(added));
}

/// The input force of a record by a model of one term at the most.
class Predicted {
 public:
  Predicted(const ForceRecord& record, const ForceScales& scales)
      : record_(record), scales_(scales), kinematics_(kinematics_of(record, scales)) {}

  [[nodiscard]] Eigen::VectorXd input_N(double friction_coefficient,
                                        const effects::ForceTerms& terms,
                                        std::span<const double> of_term) const {
    std::vector<double> parameters{1, friction_coefficient};
    parameters.insert(parameters.end(), of_term.begin(), of_term.end());
    std::vector<double> input_N;
    predict_input(record_, kinematics_, terms, scales_, parameters, input_N);
    for (std::size_t i = 0; i < input_N.size(); ++i) {
      input_N[i] = record_.used[i] ? input_N[i] : 0;
    }
    return Eigen::Map<const Eigen::VectorXd>(input_N.data(), static_cast<Index>(input_N.size()));
  }

 private:
  const ForceRecord& record_;
  const ForceScales& scales_;
  effects::Kinematics kinematics_;
};

void whiten(Eigen::MatrixXd& columns, const std::vector<double>& sd_N, double autocorrelation) {
  for (Index row = 0; row < columns.rows(); ++row) {
    columns.row(row) /= sd_N[static_cast<std::size_t>(row)];
  }
  for (Index row = columns.rows() - 1; row > 0; --row) {
    columns.row(row) -= autocorrelation * columns.row(row - 1);
  }
  if (columns.rows() > 0) {
    columns.row(0) *= std::sqrt(1 - autocorrelation * autocorrelation);
  }
}

Eigen::MatrixXd products_of(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  gram.triangularView<Eigen::StrictlyUpper>() = gram.transpose();
  return gram;
}

}  // namespace

const GramLayout::Effect& GramLayout::of(std::string_view id) const {
  for (const Effect& entry : effects) {
    if (entry.effect->id == id) {
      return entry;
    }
  }
  throw std::out_of_range("no effect of this id");
}

ForceScales sharp_scales_of(std::span<const ForceRecord> records) {
  constexpr double kSharp = 1e-6;  // of the scale of speed
  ForceScales scales = scales_of(records);
  scales.turn_over_m_s = kSharp * scales.speed_m_s;
  return scales;
}

GramLayout layout_of(std::span<const ForceRecord> records, const ForceScales& scales) {
  GramLayout layout;
  for (const effects::TensionEffect* const effect : effects::tension_effects()) {
    add_cases(*effect, records, scales, layout);
  }
  return layout;
}

Eigen::MatrixXd columns_of(const ForceRecord& record, const GramLayout& layout,
                           const ForceScales& scales, double friction_coefficient) {
  constexpr double kFrictionStep = 1e-4;
  const Predicted predicted(record, scales);
  const Eigen::VectorXd nominal_N = predicted.input_N(friction_coefficient, {}, {});
  Eigen::MatrixXd columns(nominal_N.size(), static_cast<Index>(layout.size));
  columns.col(Index{GramLayout::kGain}) = nominal_N;
  columns.col(Index{GramLayout::kFriction}) =
      (predicted.input_N(friction_coefficient + kFrictionStep, {}, {}) - nominal_N) / kFrictionStep;
  for (const GramLayout::Effect& effect : layout.effects) {
    for (const GramLayout::Case& one : effect.cases) {
      const effects::ForceTerms terms{one.term};
      const std::vector<ForceParameter> parameters = parameters_of(one.term, scales);
      const Eigen::VectorXd there_N =
          predicted.input_N(friction_coefficient, terms, one.parameters);
      auto next = static_cast<Index>(one.first);
      columns.col(next++) = there_N - nominal_N;
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        std::vector<double> moved = one.parameters;
        const double step = parameters[k].chosen ? 0 : step_of(parameters[k], moved[k]);
        moved[k] += step;
        columns.col(next++) = (predicted.input_N(friction_coefficient, terms, moved) - there_N) /
                              (step == 0 ? 1 : step);
      }
    }
  }
  return columns;
}

Grams gram_of(std::span<const ForceRecord> records, double friction_coefficient,
              const NoiseModel& noise, unsigned threads) {
  const ForceScales scales = sharp_scales_of(records);
  Grams grams{.layout = layout_of(records, scales), .sessions = {}};
  grams.sessions.resize(records.size());
  statistics::parallel_for(
      records.size(),
      [&](std::size_t i) {
        Eigen::MatrixXd columns =
            columns_of(records[i], grams.layout, scales, friction_coefficient);
        whiten(columns, noise.sample_sd_N[i], noise.autocorrelation);
        grams.sessions[i] = products_of(columns);
      },
      threads);
  return grams;
}

}  // namespace host_sim::diagnose
