#pragma once

#include <span>
#include <vector>

#include "host_sim/recording/recording.hpp"
#include "host_sim/recording/sensor.hpp"
#include "host_sim/recording/signal.hpp"

/// One rule for each kind of fault. All look at one session.
namespace host_sim::recording {

/// A channel that is recorded and changes.
struct LiveChannel {
  hal::files::ProfileColumnId id;
  std::span<const double> values;
  Sensor sensor;
};

/// What one session shows.
struct SessionView {
  std::span<const double> time_s;
  std::span<const LiveChannel> channels;
  std::span<const Stretch> slips;  ///< see slips_of(); none where velocity was not measured
};

/// Whether a channel has to change within a session. Temperatures and the bend angle do not.
bool has_to_change(hal::files::ProfileColumnId id);

/// The samples right after which time has jumped: five samples
/// or more are missing, that is a step of more than 5.5 times the median.
std::vector<Stretch> gaps_in(std::span<const double> time_s);

/// How far a tension or current rises, or falls, within one slip in the stretch, beyond six times
/// its noise, as a share of its range. At a reversal tensions jump apart; within a slip they do
/// not.
double rise_in_slip(const LiveChannel& channel, const Stretch& stretch,
                    std::span<const Stretch> slips);
double fall_in_slip(const LiveChannel& channel, const Stretch& stretch,
                    std::span<const Stretch> slips);

/// Whether a channel at `value` would have to show it where `other` changes by a share of its
/// range: relative to their values, the change is at least four steps of the channel's resolution.
bool has_to_show(const LiveChannel& channel, double value, const LiveChannel& other, double share);

/// Where a channel that has to change stands still for at least 0.25 s and 50 samples, though
/// - its sensor is noisy (Sensor::longest_by_chance); not a velocity of exactly zero, as many
///   drives show standstill; or
/// - another tension or current, for a tension or current, rises or falls by 30 % in a slip,
///   which this one has_to_show(); or
/// - the motor angle turns back by 30 % of its range, for a velocity other than zero; or
/// - the integral of velocity moves by 30 % of its range, for a motor angle.
/// A row at the largest or smallest value of the session is left to saturated_in().
std::vector<Stretch> stuck_in(const LiveChannel& channel, const SessionView& session);

/// Where a channel that has to change stays at its largest or smallest value of the session, though
/// - its sensor is noisy, for more samples than chance leaves; or
/// - for at least 5 samples another tension or current continues by 10 % in a slip: up for the
///   largest value, down for the smallest, which this one has_to_show().
std::vector<Stretch> saturated_in(const LiveChannel& channel, const SessionView& session);

}  // namespace host_sim::recording
