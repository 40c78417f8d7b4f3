#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/statistics/common_shape.hpp"

namespace host_sim::calibrate {

/// The result for people: levels, common shape, life law beside the paper's least squares, use
/// levels, validation, mixes, and warnings last.
void write_summary(std::ostream& out, const CalibrateResult& result);

/// The result as one JSON object with the fields of the file format; what is infinite or was not
/// computed is null. Lives in cycles, intervals as [low, high].
/// @param indent spaces for each depth; negative: all on one line
std::string calibrate_json(const CalibrateResult& result, int indent = 2);

/// The text of `model.toml`: the campaign's nominal model with the fitted law as its [life], in
/// numbers that read back exactly.
/// @pre require_nominal_model(campaign) holds
/// @throws InputError where there is no law or a model cannot hold it
std::string model_text(const Campaign& campaign, const CalibrateResult& result,
                       std::string_view program_version);

/// The header line of a table of campaigns (RFC 4180).
std::string table_head();

/// The line of one campaign; what was not computed is empty, an end that does not exist `inf`.
/// @param name of its folder
std::string table_row(std::string_view name, const CalibrateResult& result);

/// The line of a campaign that was refused.
std::string refused_row(std::string_view name, std::string_view error);

/// All that found_in() can name, in its order.
std::vector<std::string> all_findings();

/// What is evidence against the model or its data:
///   left-out    a level of role fit is not in the life model;
///   shape       one shape for all levels of the life model is rejected;
///   fit         the law is rejected against free levels, curvature or growing scatter, or there is
///               none;
///   validation  a validation level differs from its prediction.
std::vector<std::string> found_in(const CalibrateResult& result);

/// `normal`, `lognormal` or `weibull`.
std::string_view family_name(statistics::Family family);

/// The family of the greatest likelihood (all have two parameters), none where none could be
/// fitted.
std::optional<statistics::Family> best_family(const LevelResult& level);

/// The level of a validation, or `in blocks`.
std::string validation_name(const CalibrateResult& result, const ValidationResult& validation);

/// Four significant digits; `-` for what was not computed, `no limit` for what is infinite.
std::string figure(double value);

/// `low .. high`.
std::string figure(const statistics::Interval& interval);

/// Cycles: whole below a million, four significant digits above.
std::string cycles_text(double cycles);
std::string cycles_text(const statistics::Interval& interval_cycles);

/// A p-value with three decimals, below 0.001 with one significant digit.
std::string p_text(double p);

}  // namespace host_sim::calibrate
