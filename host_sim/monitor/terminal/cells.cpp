#include "host_sim/monitor/terminal/cells.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "host_sim/monitor/fleet/words.hpp"

namespace host_sim::monitor {
namespace {

using protocol::detail::DamageRate;
using protocol::detail::RemainingLife;

constexpr std::string_view kNothing = "-";
constexpr protocol::schema::Signal kRateSignal =
    protocol::schema::signal_of(&DamageRate::ppb_per_h);

Look look_of(protocol::LifeState state) {
  switch (state) {
    case protocol::LifeState::unknown:
      return Look::unknown;
    case protocol::LifeState::normal:
      return Look::normal;
    case protocol::LifeState::inspect:
      return Look::inspect;
    case protocol::LifeState::replace:
      return Look::replace;
    case protocol::LifeState::worn:
      return Look::worn;
  }
  return Look::unknown;
}

/// A value, which nobody takes for a live one where it is stale.
Cell value_cell(std::string text, bool stale) {
  if (!stale) {
    return {std::move(text), Look::plain};
  }
  return {std::move(text) + " STALE", Look::stale};
}

Cell state_cell(const NodeView& node) {
  if (node.two_controllers) {
    return {fmt::format("TWO CONTROLLERS ({})", name_of(node.life_state())), Look::worn};
  }
  if (!node.status) {
    return {node.vanished ? "no status VANISHED" : "no status",
            node.vanished ? Look::stale : Look::unknown};
  }
  const std::string name(name_of(node.life_state()));
  if (node.vanished) {
    return {name + " VANISHED", Look::stale};
  }
  return node.status->stale ? value_cell(name, true) : Cell{name, look_of(node.life_state())};
}

Cell damage_cell(const NodeView& node) {
  if (!node.status) {
    return {std::string(kNothing), Look::plain};
  }
  return value_cell(percent_of(node.highest_damage_ppb), node.status->stale);
}

std::string hours_of(std::uint16_t tenths) {
  return fmt::format("{}.{}", tenths / 10, tenths % 10);
}

std::string band_of(const RemainingLife& life) {
  if (life.b10_dh == RemainingLife::kUnknown) {
    return "unknown";
  }
  if (life.b90_dh == RemainingLife::kUnknown) {
    return hours_of(life.b10_dh) + " - more than " + hours_of(RemainingLife::kUnknown - 1) + " h";
  }
  return hours_of(life.b10_dh) + " - " + hours_of(life.b90_dh) + " h";
}

Cell remaining_cell(const NodeView& node) {
  return node.remaining ? value_cell(band_of(node.remaining->value), node.remaining->stale)
                        : Cell{std::string(kNothing), Look::plain};
}

std::string rate_of(const DamageRate& rate) {
  return rate.ppb_per_h == DamageRate::kUnknownRate ? "unknown"
                                                    : percent_of(rate.ppb_per_h, kRateSignal);
}

Cell rate_cell(const NodeView& node) {
  return node.rate ? value_cell(rate_of(node.rate->value), node.rate->stale)
                   : Cell{std::string(kNothing), Look::plain};
}

std::string age_of(std::int64_t age_ns) {
  const double age_s = static_cast<double>(age_ns) / 1e9;
  return age_s < 60 ? fmt::format("{:.1f} s", age_s) : fmt::format("{:.0f} min", age_s / 60);
}

Cell heartbeat_cell(const NodeView& node, std::int64_t now_ns) {
  return node.heartbeat
             ? value_cell(age_of(now_ns - node.heartbeat->time_ns), node.heartbeat->stale)
             : Cell{std::string(kNothing), Look::plain};
}

Cell failures_cell(const NodeView& node) {
  const std::uint64_t failures = node.integrity_failures();
  return {std::to_string(failures), failures == 0 ? Look::plain : Look::alarm};
}

std::uint64_t lost_of(const NodeView& node) {
  std::uint64_t lost = 0;
  for (const StreamView& stream : node.streams) {
    lost += stream.lost;
  }
  return lost;
}

void add_note(Cell& notes, bool there, std::string_view note) {
  if (there) {
    notes.text.append(notes.text.empty() ? "" : ", ").append(note);
    notes.look = Look::alarm;
  }
}

Cell notes_cell(const NodeView& node) {
  Cell notes;
  add_note(notes, node.two_controllers, "two controllers have this node id");
  if (node.emergency && node.emergency->value.code != protocol::EmergencyCode::none) {
    add_note(notes, true, name_of(node.emergency->value.code));
  }
  if (node.status) {
    const protocol::LifeStatus& status = node.status->value;
    add_note(notes, status.locked, "locked");
    add_note(notes, !status.sensor_ok, "sensor fault");
    add_note(notes, !status.storage_ok, "storage fault");
    add_note(notes, status.quality != protocol::Quality::measured, name_of(status.quality));
  }
  if (notes.look == Look::alarm && (node.vanished || (node.status && node.status->stale))) {
    return value_cell(std::move(notes.text), true);
  }
  return notes;
}

}  // namespace

std::vector<Column> columns() {
  return {{"NODE", 9},      {"STATE", 8},  {"DAMAGE %", 7}, {"LEFT B10 - B90", 4}, {"RATE %/h", 3},
          {"HEARTBEAT", 5}, {"FAILED", 6}, {"LOST", 1},     {"NOTES", 2}};
}

std::vector<Cell> cells_of(const NodeView& node, std::int64_t now_ns) {
  return {{std::to_string(node.node), Look::plain},
          state_cell(node),
          damage_cell(node),
          remaining_cell(node),
          rate_cell(node),
          heartbeat_cell(node, now_ns),
          failures_cell(node),
          {std::to_string(lost_of(node)), Look::plain},
          notes_cell(node)};
}

}  // namespace host_sim::monitor
