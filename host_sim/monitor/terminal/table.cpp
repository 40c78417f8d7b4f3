#include "host_sim/monitor/terminal/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include "hal/files/text.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

using hal::files::printable;

namespace {

/// How a cell looks where there are colours. Words say the same.
enum class CellStyle : std::uint8_t {
  plain,
  normal,
  inspect,
  replace,
  worn,
  unknown,
  stale,
  alarm
};

struct Cell {
  std::string text;
  CellStyle style = CellStyle::plain;
};

using protocol::detail::BreakRisk;
using protocol::detail::DamageRate;
using protocol::detail::RemainingLife;

constexpr std::string_view kNothing = "-";
constexpr std::string_view kStale = " STALE";
constexpr std::string_view kCut = "...";
constexpr protocol::schema::Signal kRateSignal =
    protocol::schema::signal_of(&DamageRate::ppb_per_h);

CellStyle style_of(protocol::LifeState state) {
  switch (state) {
    case protocol::LifeState::unknown:
      return CellStyle::unknown;
    case protocol::LifeState::normal:
      return CellStyle::normal;
    case protocol::LifeState::inspect:
      return CellStyle::inspect;
    case protocol::LifeState::replace:
      return CellStyle::replace;
    case protocol::LifeState::worn:
      return CellStyle::worn;
  }
  return CellStyle::unknown;
}

/// A value, which nobody takes for a live one where it is stale.
Cell value_cell(std::string text, bool stale) {
  if (!stale) {
    return {std::move(text), CellStyle::plain};
  }
  return {std::move(text).append(kStale), CellStyle::stale};
}

Cell state_cell(const NodeView& node) {
  if (node.two_controllers) {
    return {fmt::format("TWO CONTROLLERS ({})", name_of(node.life_state())), CellStyle::worn};
  }
  if (!node.status) {
    return {node.vanished ? "no status VANISHED" : "no status",
            node.vanished ? CellStyle::stale : CellStyle::unknown};
  }
  const std::string name(name_of(node.life_state()));
  if (node.vanished) {
    return {name + " VANISHED", CellStyle::stale};
  }
  return node.status->stale ? value_cell(name, true) : Cell{name, style_of(node.life_state())};
}

Cell damage_cell(const NodeView& node) {
  if (!node.status) {
    return {std::string(kNothing), CellStyle::plain};
  }
  return value_cell(percent_of(node.highest_damage_ppb), node.status->stale);
}

std::string hours_of(std::uint16_t tenths) {
  if (tenths == RemainingLife::kUnknown) {
    return "unknown";
  }
  const bool or_more =
      is_at_least(protocol::schema::signal_of(&RemainingLife::b10_dh), std::uint32_t{tenths});
  return fmt::format("{}{}.{}", or_more ? ">=" : "", tenths / 10, tenths % 10);
}

std::string band_of(const RemainingLife& life) {
  return life.b10_dh == RemainingLife::kUnknown
             ? "unknown"
             : hours_of(life.b10_dh) + " - " + hours_of(life.b90_dh) + " h";
}

Cell remaining_cell(const NodeView& node) {
  return node.remaining ? value_cell(band_of(node.remaining->value), node.remaining->stale)
                        : Cell{std::string(kNothing), CellStyle::plain};
}

Cell break_risk_cell(const NodeView& node) {
  if (!node.break_risk) {
    return {std::string(kNothing), CellStyle::plain};
  }
  const BreakRisk& risk = node.break_risk->value;
  return value_cell(
      risk.within_horizon == BreakRisk::kUnknownRisk
          ? "unknown"
          : fmt::format("{:.4g} % in {} h", 100.0 * risk.within_horizon / BreakRisk::kSure,
                        risk.horizon_h),
      node.break_risk->stale);
}

std::string rate_of(const DamageRate& rate) {
  return rate.ppb_per_h == DamageRate::kUnknownRate ? "unknown"
                                                    : percent_of(rate.ppb_per_h, kRateSignal);
}

Cell rate_cell(const NodeView& node) {
  return node.rate ? value_cell(rate_of(node.rate->value), node.rate->stale)
                   : Cell{std::string(kNothing), CellStyle::plain};
}

std::string age_of(std::int64_t age_ns) {
  const double age_s = static_cast<double>(age_ns) / 1e9;
  return age_s < 60 ? fmt::format("{:.1f} s", age_s) : fmt::format("{:.0f} min", age_s / 60);
}

Cell heartbeat_cell(const NodeView& node, std::int64_t now_ns) {
  return node.heartbeat
             ? value_cell(age_of(now_ns - node.heartbeat->time_ns), node.heartbeat->stale)
             : Cell{std::string(kNothing), CellStyle::plain};
}

Cell failures_cell(const NodeView& node) {
  const std::uint64_t failures = node.integrity_failures();
  return {std::to_string(failures), failures == 0 ? CellStyle::plain : CellStyle::alarm};
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
    notes.style = CellStyle::alarm;
  }
}

/// What is advised for a tendon whose load does not last; stale values are left out.
void add_advice(Cell& notes, const NodeView& node) {
  using protocol::AdviceState;
  for (const auto& [tendon, page] : node.advice) {
    if (page.stale) {
      continue;
    }
    const protocol::detail::Advice& advice = page.value;
    add_note(notes, advice.state == AdviceState::unreachable,
             fmt::format("tendon {}: no tension lasts", tendon));
    add_note(notes, advice.state == AdviceState::limited,
             fmt::format("tendon {}: at most {:.4g} % tension or {:.4g} % pace", tendon,
                         100.0 * advice.highest_tension / protocol::detail::Advice::kWhole,
                         100.0 * advice.pace / protocol::detail::Advice::kWhole));
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
    add_note(notes, status.broken, "broken");
    add_note(notes, status.slack, "slack");
    add_note(notes, status.locked, "locked");
    add_note(notes, !status.sensor_ok, "sensor fault");
    add_note(notes, !status.storage_ok, "storage fault");
    add_note(notes, status.quality != protocol::Quality::measured, name_of(status.quality));
  }
  add_advice(notes, node);
  if (notes.style == CellStyle::alarm && (node.vanished || (node.status && node.status->stale))) {
    return value_cell(std::move(notes.text), true);
  }
  return notes;
}

/// A column of the table.
struct Column {
  std::string_view title;
  int importance = 0;  ///< where the terminal is narrow the lowest goes first
};

/// In the order of cells_of().
std::vector<Column> columns() {
  return {{"NODE", 10},      {"STATE", 9},    {"DAMAGE %", 8},  {"LEFT B10 - B90", 2},
          {"BREAK RISK", 3}, {"RATE %/h", 1}, {"HEARTBEAT", 4}, {"FAILED", 7},
          {"LOST", 6},       {"NOTES", 5}};
}

/// The notes, the last column, are cut before others are left out, but not below this.
constexpr std::size_t kShortestNotes = 12;

/// What a node is called, shows and suffers from, a cell for each of columns().
std::vector<Cell> cells_of(const NodeView& node, std::int64_t now_ns) {
  return {{std::to_string(node.node), CellStyle::plain},
          state_cell(node),
          damage_cell(node),
          remaining_cell(node),
          break_risk_cell(node),
          rate_cell(node),
          heartbeat_cell(node, now_ns),
          failures_cell(node),
          {std::to_string(lost_of(node)), CellStyle::plain},
          notes_cell(node)};
}

constexpr std::size_t kGap = 2;

std::string_view code_of(CellStyle style) {
  switch (style) {
    case CellStyle::plain:
      return "";
    case CellStyle::normal:
      return "32";
    case CellStyle::inspect:
      return "33";
    case CellStyle::replace:
      return "1;31";
    case CellStyle::worn:
      return "1;37;41";
    case CellStyle::unknown:
      return "35";
    case CellStyle::stale:
      return "90";
    case CellStyle::alarm:
      return "31";
  }
  return "";
}

std::string painted(std::string_view text, CellStyle style, bool colours) {
  const std::string_view code = colours ? code_of(style) : std::string_view();
  return code.empty() ? std::string(text) : fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

std::string cut(const std::string& line, std::size_t width) {
  if (width == 0 || line.size() <= width) {
    return line;
  }
  const std::string_view end = kCut.substr(0, width);
  return line.substr(0, width - end.size()).append(end);
}

/// Cut before its mark.
std::string cut_value(const std::string& text, std::size_t width) {
  return text.size() > width && text.ends_with(kStale)
             ? cut(text.substr(0, text.size() - kStale.size()), width - kStale.size())
                   .append(kStale)
             : cut(text, width);
}

using Row = std::vector<Cell>;

class Table {
 public:
  Table(std::vector<Row> rows, const TableStyle& style) : rows_(std::move(rows)), style_(style) {
    for (const Column& column : columns()) {
      std::size_t width = column.title.size();
      for (const Row& row : rows_) {
        width = std::max(width, row[shown_.size()].text.size());
      }
      widths_.push_back(width);
      shown_.push_back(true);
    }
    if (style_.width != 0) {
      find_room();
    }
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    std::vector<std::string> lines = left_out_lines();
    Row head;
    for (const Column& column : columns()) {
      head.push_back({std::string(column.title), CellStyle::plain});
    }
    lines.push_back(line_of(head));
    for (const Row& row : rows_) {
      lines.push_back(line_of(row));
    }
    return lines;
  }

 private:
  [[nodiscard]] std::size_t width() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < widths_.size(); ++i) {
      sum += shown_[i] ? widths_[i] + kGap : 0;
    }
    return sum - kGap;
  }

  void find_room() {
    std::size_t& notes = widths_.back();
    const std::size_t longest = notes;
    notes = std::min(notes, kShortestNotes);
    leave_out_what_has_no_room();
    if (shown_.back() && width() < style_.width) {
      notes = std::min(longest, notes + style_.width - width());
    }
    for (Row& row : rows_) {
      row.back().text = cut_value(row.back().text, notes);
    }
  }

  void leave_out_what_has_no_room() {
    const std::vector<Column> all = columns();
    for (int importance = 1; width() > style_.width; ++importance) {
      const auto least = std::find_if(all.begin(), all.end(), [importance](const Column& column) {
        return column.importance == importance;
      });
      if (least == all.end() || least == all.begin()) {
        return;  // the node is always shown
      }
      shown_[static_cast<std::size_t>(least - all.begin())] = false;
    }
  }

  /// What has no room, in as many lines as that takes.
  [[nodiscard]] std::vector<std::string> left_out_lines() const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      if (shown_[i]) {
        continue;
      }
      const std::string_view title = columns()[i].title;
      if (lines.empty()) {
        lines.emplace_back("Too narrow for ").append(title);
      } else if (lines.back().size() + 3 + title.size() <= style_.width) {
        lines.back().append(", ").append(title);
      } else {
        lines.back() += ',';
        lines.emplace_back(title);
      }
    }
    for (std::string& line : lines) {
      line = cut(line, style_.width);
    }
    return lines;
  }

  [[nodiscard]] std::string line_of(const Row& row) const {
    std::string line;
    std::size_t owed = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!shown_[i] || row[i].text.empty()) {
        owed += shown_[i] ? widths_[i] + kGap : 0;
        continue;
      }
      line.append(owed, ' ');
      line += painted(row[i].text, row[i].style, style_.colours);
      owed = widths_[i] - row[i].text.size() + kGap;
    }
    return line;
  }

  std::vector<Row> rows_;
  TableStyle style_;
  std::vector<std::size_t> widths_;
  std::vector<bool> shown_;
};

std::string bus_line(const FleetView& view) {
  std::string line = printable(view.source);
  fmt::format_to(std::back_inserter(line), "  {} frames  {:.0f}/s  load {:.1f} %  {} node{}",
                 view.frames, view.frames_per_s, view.bus_load_percent, view.nodes.size(),
                 view.nodes.size() == 1 ? "" : "s");
  return line;
}

std::vector<std::string> alarms_of(const FleetView& view) {
  std::vector<std::string> alarms;
  if (view.source_lost) {
    alarms.push_back("BUS LOST: " + printable(view.source));
  }
  if (view.bus_off) {
    alarms.emplace_back("BUS OFF");
  }
  if (view.receive_overflows != 0) {
    alarms.push_back(fmt::format("{} frames were lost before the monitor", view.receive_overflows));
  }
  return alarms;
}

}  // namespace

std::vector<std::string> table_of(const FleetView& view, const TableStyle& style) {
  std::vector<std::string> lines{cut(bus_line(view), style.width)};
  for (const std::string& alarm : alarms_of(view)) {
    lines.push_back(painted(cut(alarm, style.width), CellStyle::alarm, style.colours));
  }
  std::vector<Row> rows;
  for (const NodeView* const node : gravest_first(view)) {
    rows.push_back(cells_of(*node, view.now_ns));
  }
  for (std::string& line : Table(std::move(rows), style).lines()) {
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace host_sim::monitor
