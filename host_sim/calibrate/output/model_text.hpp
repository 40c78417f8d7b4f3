#pragma once

#include <string>
#include <string_view>

#include "host_sim/calibrate/result.hpp"

namespace host_sim::calibrate {

/// The text of `model.toml`: the campaign's nominal model with the fitted law as its [life], in
/// numbers that read back exactly.
/// @pre require_nominal_model(campaign) holds
/// @throws InputError where there is no law or a model cannot hold it
std::string model_text(const Campaign& campaign, const CalibrateResult& result,
                       std::string_view program_version);

}  // namespace host_sim::calibrate
