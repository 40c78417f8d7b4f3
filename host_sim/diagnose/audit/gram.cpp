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

/// The input force of a record by a model, 0 where a sample does not count.
Eigen::VectorXd predicted_N(const ForceRecord& record, const effects::Kinematics& kinematics,
                            const effects::ForceTerms& terms, const ForceScales& scales,
                            const std::vector<double>& parameters) {
  std::vector<double> input_N;
  predict_input(record, kinematics, terms, scales, parameters, input_N);
  for (std::size_t i = 0; i < input_N.size(); ++i) {
    input_N[i] = record.used[i] ? input_N[i] : 0;
  }
  return Eigen::Map<const Eigen::VectorXd>(input_N.data(), static_cast<Index>(input_N.size()));
}

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
  const effects::Kinematics kinematics = kinematics_of(record, scales);
  Eigen::MatrixXd columns(static_cast<Index>(record.samples()), static_cast<Index>(layout.size));
  constexpr double kStep = 1e-4;
  const Eigen::VectorXd nominal_N =
      predicted_N(record, kinematics, {}, scales, {1, friction_coefficient});
  const Eigen::VectorXd above_N =
      predicted_N(record, kinematics, {}, scales, {1, friction_coefficient + kStep});
  columns.leftCols<2>() << nominal_N, (above_N - nominal_N) / kStep;
  for (const GramLayout::Effect& effect : layout.effects) {
    for (const GramLayout::Case& one : effect.cases) {
      const auto with_N = [&](const std::vector<double>& of_term) {
        std::vector<double> parameters{1, friction_coefficient};
        parameters.insert(parameters.end(), of_term.begin(), of_term.end());
        return predicted_N(record, kinematics, {one.term}, scales, parameters);
      };
      const std::vector<ForceParameter> parameters = parameters_of(one.term, scales);
      const Eigen::VectorXd there_N = with_N(one.parameters);
      auto next = static_cast<Index>(one.first);
      columns.col(next++) = there_N - nominal_N;
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        if (parameters[k].chosen) {
          columns.col(next++).setZero();
          continue;
        }
        std::vector<double> moved = one.parameters;
        const double step = step_of(parameters[k], moved[k]);
        moved[k] += step;
        columns.col(next++) = (with_N(moved) - there_N) / step;
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
