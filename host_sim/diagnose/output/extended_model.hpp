#pragma once

#include <string>
#include <string_view>

#include "host_sim/campaign/campaign.hpp"
#include "host_sim/diagnose/diagnosis.hpp"

namespace host_sim::diagnose {

/// What the input tension of the recordings comes from.
enum class InputFrom { load_cell, current };

/// Checks, before the long work, that the campaign's nominal model has what a model needs besides
/// what the diagnosis fits.
/// @throws InputError naming campaign.toml and what to add to it
void require_extensible_model(const Campaign& campaign);

/// Where the input tension of this campaign's recordings comes from; the load cell where there is
/// none. @throws InputError as read_recordings() does
InputFrom input_of(const Campaign& campaign);

/// The text of `model.toml`: the campaign's nominal model with the refitted friction coefficient
/// and, where the current is the input, with the drive times the refitted gain (the efficiency of
/// the gear, or what of the gain it cannot hold the torque constant); with the refitted life; and a
/// table [extension.<id>] for each effect that was named. Where there are no recordings or no lives
/// their part of the model is the nominal one.
/// @pre require_extensible_model(campaign) holds
/// @throws InputError where a model cannot hold what was fitted
std::string extended_model_text(const Campaign& campaign, const Diagnosis& diagnosis,
                                InputFrom input, std::string_view program_version);

}  // namespace host_sim::diagnose
