#include "host_sim/diagnose/force/force_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/diagnose/force/structure.hpp"

namespace host_sim::diagnose {
namespace {

/// The output force that each model has for the input of a session.
TracePicture trace_of(const effects::ForceRecord& record, std::size_t session,
                      const PicturedModel& before, const PicturedModel& after) {
  const auto output_N = [&](const PicturedModel& model) {
    std::vector<double> all_N = record.output_N;
    for (std::size_t i = 0; i < all_N.size(); ++i) {
      all_N[i] += model.left_N[session][i] / model.gain;
    }
    return all_N;
  };
  return {record.session,  record.time_s,    record.input_N,
          record.output_N, output_N(before), output_N(after)};
}

double squares_N2(const std::vector<double>& left_N) {
  return std::inner_product(left_N.begin(), left_N.end(), left_N.begin(), 0.0);
}

}  // namespace

std::vector<TracePicture> traces_of(const ForceData& data, const PicturedModel& before,
                                    const PicturedModel& after) {
  constexpr std::size_t kTraces = 4;
  std::vector<TracePicture> traces;
  for (std::size_t j = 0; j < std::min(kTraces, data.records().size()); ++j) {
    traces.push_back(trace_of(data.records()[j], j, before, after));
  }
  return traces;
}

std::vector<CausePicture> causes_of(const ForceData& data, const std::vector<PicturedModel>& stairs,
                                    const std::vector<Step>& steps) {
  std::vector<CausePicture> causes;
  for (std::size_t i = 1; i < stairs.size(); ++i) {
    const PicturedModel& before = stairs[i - 1];
    const PicturedModel& after = stairs[i];
    std::vector<double> lessened_N2;
    for (std::size_t j = 0; j < data.records().size(); ++j) {
      lessened_N2.push_back(squares_N2(before.left_N[j]) - squares_N2(after.left_N[j]));
    }
    if (std::accumulate(lessened_N2.begin(), lessened_N2.end(), 0.0) > 0) {
      const auto most =
          static_cast<std::size_t>(std::ranges::max_element(lessened_N2) - lessened_N2.begin());
      causes.push_back({steps[i].effect.id, trace_of(data.records()[most], most, before, after)});
    }
  }
  return causes;
}

std::vector<SessionRefit> session_refits_of(const ForceData& data, const ForceFit& nominal) {
  const std::vector<ForceCovariance::Refit> beside = refits_of(data, data.residuals_N(nominal));
  std::vector<SessionRefit> refits;
  refits.reserve(beside.size());
  for (std::size_t j = 0; j < beside.size(); ++j) {
    refits.push_back({data.records()[j].session, nominal.parameters[1] + beside[j].value(1),
                      -std::log(nominal.parameters[0]) - beside[j].value(0)});
  }
  return refits;
}

}  // namespace host_sim::diagnose
