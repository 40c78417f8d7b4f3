#pragma once

#include <string_view>
#include <tuple>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/frame.hpp"
#include "firmware/protocol/schema/frames.hpp"

/// Layouts of the pages of LifeDetail. Each has the six bytes after the header.
namespace protocol::schema {

struct PageLayout {
  static constexpr const Frame& kFrame = kLifeDetailFrame;
};

template <>
struct Layout<detail::Identity> : PageLayout {
  static constexpr std::string_view kName = "Identity";
  static constexpr std::string_view kComment = "what is speaking";
  static constexpr std::tuple kFields{
      field(&detail::Identity::schema, {.name = "SchemaVersion",
                                        .start_bit = 16,
                                        .bits = 8,
                                        .comment = "version of this frame plan"}),
      field(&detail::Identity::firmware, {.name = "FirmwareVersion",
                                          .start_bit = 24,
                                          .bits = 8,
                                          .comment = "major in the high 4 bits, minor in the low"}),
      field(&detail::Identity::configuration, {.name = "Configuration",
                                               .start_bit = 32,
                                               .bits = 32,
                                               .comment = "CRC-32 over the parameter blocks"}),
  };
};

template <>
struct Layout<detail::Cycles> : PageLayout {
  static constexpr std::string_view kName = "Cycles";
  static constexpr std::string_view kComment = "cycles of all tendons";
  static constexpr std::tuple kFields{
      field(&detail::Cycles::cycles,
            {.name = "Cycles",
             .start_bit = 16,
             .bits = 32,
             .comment = "closed in this epoch, stops at the end of its range",
             .stops = true}),
      field(&detail::Cycles::cycles_per_min, {.name = "CycleRate",
                                              .start_bit = 48,
                                              .bits = 16,
                                              .unit = "1/min",
                                              .comment = "over the last minute, stops at 65534",
                                              .values = kCycleRateUnknown,
                                              .stops = true}),
  };
};

template <>
struct Layout<detail::DamageRate> : PageLayout {
  static constexpr std::string_view kName = "DamageRate";
  static constexpr std::string_view kComment = "how fast the worst tendon wears";
  static constexpr std::tuple kFields{
      field(&detail::DamageRate::ppb_per_h,
            {.name = "DamageRate",
             .start_bit = 16,
             .bits = 32,
             .factor = "0.000000001",
             .unit = "1/h",
             .comment = "over the last minute, stops at 4.294967294",
             .values = kDamageRateUnknown,
             .stops = true}),
      field(&detail::DamageRate::unsaved_ppb,
            {.name = "UnsavedDamage",
             .start_bit = 48,
             .bits = 16,
             .factor = "0.000000001",
             .comment = "what a power cut now would lose, stops at the end of its range",
             .stops = true}),
  };
};

template <>
struct Layout<detail::TendonDamage> : PageLayout {
  static constexpr std::string_view kName = "TendonDamage";
  static constexpr std::string_view kComment = "one tendon after the other";
  static constexpr std::tuple kFields{
      field(&detail::TendonDamage::tendon,
            {.name = "Tendon", .start_bit = 16, .bits = 5, .comment = "which one, from 0"}),
      field(&detail::TendonDamage::damage_ppb,
            {.name = "TendonDamage",
             .start_bit = 24,
             .bits = 32,
             .factor = "0.000000001",
             .comment = "1 is its characteristic life, stops at the end of its range",
             .stops = true}),
      field(&detail::TendonDamage::state, {.name = "TendonLifeState",
                                           .start_bit = 56,
                                           .bits = 4,
                                           .comment = "how far its life is used",
                                           .values = kLifeStates}),
  };
};

template <>
struct Layout<detail::RainflowBin> : PageLayout {
  static constexpr std::string_view kName = "RainflowBin";
  static constexpr std::string_view kComment = "one bin of the range and mean matrix";
  static constexpr std::tuple kFields{
      field(
          &detail::RainflowBin::tendon,
          {.name = "BinTendon", .start_bit = 16, .bits = 5, .comment = "of which tendon, from 0"}),
      field(&detail::RainflowBin::range_class,
            {.name = "BinRange",
             .start_bit = 21,
             .bits = 3,
             .comment = "range, whole eighths of the ultimate tension, 7 is open above"}),
      field(&detail::RainflowBin::mean_class,
            {.name = "BinMean",
             .start_bit = 24,
             .bits = 3,
             .comment = "mean, whole eighths of the ultimate tension, 0 is open below"}),
      field(&detail::RainflowBin::half_cycles, {.name = "BinHalfCycles",
                                                .start_bit = 27,
                                                .bits = 5,
                                                .comment = "open now, besides, stops at 31",
                                                .stops = true}),
      field(&detail::RainflowBin::cycles,
            {.name = "BinCycles",
             .start_bit = 32,
             .bits = 32,
             .comment = "closed since the start, stops at the end of its range",
             .stops = true}),
  };
};

template <>
struct Layout<detail::RemainingLife> : PageLayout {
  static constexpr std::string_view kName = "RemainingLife";
  static constexpr std::string_view kComment =
      "of the whole life of a new tendon, at the present damage rate";
  static constexpr std::tuple kFields{
      field(&detail::RemainingLife::b10_dh,
            {.name = "RemainingB10",
             .start_bit = 16,
             .bits = 16,
             .factor = "0.1",
             .unit = "h",
             .comment =
                 "until 10 % of such tendons, all counted from new, have failed, stops at 6553.4",
             .values = kRemainingLifeUnknown,
             .stops = true}),
      field(&detail::RemainingLife::b50_dh,
            {.name = "RemainingB50",
             .start_bit = 32,
             .bits = 16,
             .factor = "0.1",
             .unit = "h",
             .comment =
                 "until 50 % of such tendons, all counted from new, have failed, stops at 6553.4",
             .values = kRemainingLifeUnknown,
             .stops = true}),
      field(&detail::RemainingLife::b90_dh,
            {.name = "RemainingB90",
             .start_bit = 48,
             .bits = 16,
             .factor = "0.1",
             .unit = "h",
             .comment =
                 "until 90 % of such tendons, all counted from new, have failed, stops at 6553.4",
             .values = kRemainingLifeUnknown,
             .stops = true}),
  };
};

template <>
struct Layout<detail::Storage> : PageLayout {
  static constexpr std::string_view kName = "Storage";
  static constexpr std::string_view kComment = "the record that outlives a power cut";
  static constexpr std::tuple kFields{
      field(&detail::Storage::sequence, {.name = "StorageSequence",
                                         .start_bit = 16,
                                         .bits = 24,
                                         .comment = "of the last record, stops at the end",
                                         .stops = true}),
      field(&detail::Storage::worst_unsaved_ppb,
            {.name = "WorstUnsavedDamage",
             .start_bit = 40,
             .bits = 24,
             .factor = "0.000000001",
             .comment = "since the start, stops at the end of its range",
             .stops = true}),
  };
};

template <>
struct Layout<detail::Timing> : PageLayout {
  static constexpr std::string_view kName = "Timing";
  static constexpr std::string_view kComment = "the control loop";
  static constexpr std::tuple kFields{
      field(&detail::Timing::worst_jitter_us, {.name = "WorstJitter",
                                               .start_bit = 16,
                                               .bits = 16,
                                               .unit = "us",
                                               .comment = "since the start",
                                               .stops = true}),
      field(&detail::Timing::p99_jitter_us, {.name = "P99Jitter",
                                             .start_bit = 32,
                                             .bits = 16,
                                             .unit = "us",
                                             .comment = "99 % of the periods were better",
                                             .stops = true}),
      field(&detail::Timing::missed_deadlines, {.name = "MissedDeadlines",
                                                .start_bit = 48,
                                                .bits = 16,
                                                .comment = "since the start",
                                                .stops = true}),
  };
};

template <>
struct Layout<detail::Bus> : PageLayout {
  static constexpr std::string_view kName = "Bus";
  static constexpr std::string_view kComment = "the CAN controller and what it brought";
  static constexpr std::tuple kFields{
      field(&detail::Bus::transmit_errors, {.name = "TransmitErrors",
                                            .start_bit = 16,
                                            .bits = 8,
                                            .comment = "transmit error counter (ISO 11898-1)"}),
      field(&detail::Bus::receive_errors, {.name = "ReceiveErrors",
                                           .start_bit = 24,
                                           .bits = 8,
                                           .comment = "receive error counter (ISO 11898-1)"}),
      field(&detail::Bus::bus_offs, {.name = "BusOffs",
                                     .start_bit = 32,
                                     .bits = 8,
                                     .comment = "how often the node was off the bus",
                                     .stops = true}),
      field(&detail::Bus::dropped, {.name = "DroppedPages",
                                    .start_bit = 40,
                                    .bits = 8,
                                    .comment = "pages that found no room",
                                    .stops = true}),
      field(&detail::Bus::refused,
            {.name = "Refused",
             .start_bit = 48,
             .bits = 16,
             .comment = "frames that failed the integrity check, and commands refused",
             .stops = true}),
  };
};

template <>
struct Layout<detail::ConditionalLife> : PageLayout {
  static constexpr std::string_view kName = "ConditionalLife";
  static constexpr std::string_view kComment =
      "of a tendon that is whole now, at the present damage rate";
  static constexpr std::tuple kFields{
      field(&detail::ConditionalLife::to_10_dh,
            {.name = "HoursToRisk10",
             .start_bit = 16,
             .bits = 16,
             .factor = "0.1",
             .unit = "h",
             .comment = "until it has broken with 10 % probability, stops at 6553.4",
             .values = kRemainingLifeUnknown,
             .stops = true}),
      field(&detail::ConditionalLife::to_50_dh,
            {.name = "HoursToRisk50",
             .start_bit = 32,
             .bits = 16,
             .factor = "0.1",
             .unit = "h",
             .comment = "until it has broken with 50 % probability, stops at 6553.4",
             .values = kRemainingLifeUnknown,
             .stops = true}),
      field(&detail::ConditionalLife::to_90_dh,
            {.name = "HoursToRisk90",
             .start_bit = 48,
             .bits = 16,
             .factor = "0.1",
             .unit = "h",
             .comment = "until it has broken with 90 % probability, stops at 6553.4",
             .values = kRemainingLifeUnknown,
             .stops = true}),
  };
};

template <>
struct Layout<detail::BreakRisk> : PageLayout {
  static constexpr std::string_view kName = "BreakRisk";
  static constexpr std::string_view kComment = "of the same tendon";
  static constexpr std::tuple kFields{
      field(&detail::BreakRisk::horizon_h, {.name = "BreakHorizon",
                                            .start_bit = 16,
                                            .bits = 8,
                                            .unit = "h",
                                            .comment = "of operation, from now on"}),
      field(&detail::BreakRisk::within_horizon,
            {.name = "BreakRisk",
             .start_bit = 24,
             .bits = 12,
             .factor = "0.00025",
             .comment = "probability of a break within the horizon, rounded up",
             .values = kBreakRiskUnknown}),
      field(&detail::BreakRisk::to_10_low_30min,
            {.name = "HoursToRisk10Low",
             .start_bit = 36,
             .bits = 14,
             .factor = "0.5",
             .unit = "h",
             .comment = "lower end of the 95 % interval of HoursToRisk10, stops at 8191",
             .values = kBoundUnknown,
             .stops = true}),
      field(&detail::BreakRisk::to_10_high_30min,
            {.name = "HoursToRisk10High",
             .start_bit = 50,
             .bits = 14,
             .factor = "0.5",
             .unit = "h",
             .comment = "upper end of the 95 % interval of HoursToRisk10, stops at 8191",
             .values = kBoundUnknown,
             .stops = true}),
  };
};

template <>
struct Layout<detail::WireHistory> : PageLayout {
  static constexpr std::string_view kName = "WireHistory";
  static constexpr std::string_view kComment =
      "what happened to the wire of one tendon after the other";
  static constexpr std::tuple kFields{
      field(
          &detail::WireHistory::tendon,
          {.name = "WireTendon", .start_bit = 16, .bits = 5, .comment = "of which tendon, from 0"}),
      field(&detail::WireHistory::broken, {.name = "WireBroken",
                                           .start_bit = 21,
                                           .bits = 1,
                                           .comment = "it has broken, until its new epoch"}),
      field(&detail::WireHistory::slack,
            {.name = "WireSlack", .start_bit = 22, .bits = 1, .comment = "it hangs loose"}),
      field(&detail::WireHistory::peak_percent,
            {.name = "WirePeak",
             .start_bit = 24,
             .bits = 8,
             .comment = "highest tension in percent of the ultimate one, stops at the end",
             .stops = true}),
      field(&detail::WireHistory::event, {.name = "WireEvent",
                                          .start_bit = 32,
                                          .bits = 2,
                                          .comment = "what is counted, one after the other",
                                          .values = kWireEvents}),
      field(&detail::WireHistory::count, {.name = "WireCount",
                                          .start_bit = 34,
                                          .bits = 14,
                                          .comment = "of that, stops at the end of its range",
                                          .stops = true}),
      field(&detail::WireHistory::below_minimum_min,
            {.name = "BelowMinimum",
             .start_bit = 48,
             .bits = 16,
             .unit = "min",
             .comment = "time below the minimum tension, stops at the end of its range",
             .stops = true}),
  };
};

template <>
struct Layout<detail::Advice> : PageLayout {
  static constexpr std::string_view kName = "Advice";
  static constexpr std::string_view kComment =
      "what one tendon after the other may do so that it lasts as long as the model wants";
  static constexpr std::tuple kFields{
      field(&detail::Advice::tendon, {.name = "AdviceTendon",
                                      .start_bit = 16,
                                      .bits = 5,
                                      .comment = "of which tendon, from 0"}),
      field(&detail::Advice::state,
            {.name = "AdviceState",
             .start_bit = 21,
             .bits = 3,
             .comment = "whether the load as it is lets it last, unreachable by no tension",
             .values = kAdviceStates}),
      field(&detail::Advice::highest_tension,
            {.name = "AdviceTension",
             .start_bit = 24,
             .bits = 12,
             .factor = "0.00025",
             .comment = "highest tension relative to the ultimate one, rounded down",
             .values = kAdviceUnknown}),
      field(&detail::Advice::pace,
            {.name = "AdvicePace",
             .start_bit = 36,
             .bits = 12,
             .factor = "0.00025",
             .comment = "instead of that, cycles relative to the heaviest minute since the start",
             .values = kAdviceUnknown}),
  };
};

}  // namespace protocol::schema
