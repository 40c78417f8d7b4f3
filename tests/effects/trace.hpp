#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension_effect.hpp"

namespace host_sim::effects::testing {

/// Of a signature against a derivative by differences.
inline constexpr double kTolerance = 1e-6;

inline constexpr double kMu = 0.128;
inline constexpr Baseline kBaseline{.friction_coefficient = kMu,
                                    .sheath_reference_C = 20,
                                    .winding_reference_C = 25,
                                    .poses_rad = {}};

/// Forty samples with three reversals and every channel but the load cell, all different from
/// sample to sample and none at a special value. T_out is what the baseline makes of T_in.
recording::Covariates trace();

/// The same with a load cell that reads what the current stands for.
recording::Covariates trace_with_load_cell();

/// The same with the output tension that a model gives.
recording::Covariates with_output(recording::Covariates covariates,
                                  const std::function<double(std::size_t i)>& output_N);

/// r = ln T_out - ln T_in + mu phi s of each sample, both tensions as measured.
std::vector<double> residuals(const recording::Covariates& covariates);

/// The effect of this id. @throws std::out_of_range
const TensionEffect& effect(std::string_view id);

std::vector<std::vector<double>> columns(std::string_view id,
                                         const recording::Covariates& covariates,
                                         const std::vector<double>& shape = {},
                                         const Baseline& baseline = kBaseline);

/// Output tension of sample i of the whole nonlinear model at parameter p.
using OutputTension = std::function<double(std::size_t i, double p)>;

/// dr/dp at 0 of r = ln T_out - ln T_in + mu phi s by central differences, T_in as measured.
std::vector<double> derivative(const recording::Covariates& covariates,
                               const OutputTension& output_N, double step);

/// Fails unless both agree within `tolerance` times the largest magnitude, which is not 0.
void expect_same(const std::vector<double>& found, const std::vector<double>& expected,
                 double tolerance);

}  // namespace host_sim::effects::testing
