#include "host_sim/monitor/terminal/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "host_sim/io/printable.hpp"
#include "host_sim/monitor/terminal/cells.hpp"

namespace host_sim::monitor {
namespace {

constexpr std::size_t kGap = 2;

std::string_view code_of(Look look) {
  switch (look) {
    case Look::plain:
      return "";
    case Look::normal:
      return "32";
    case Look::inspect:
      return "33";
    case Look::replace:
      return "1;31";
    case Look::worn:
      return "1;37;41";
    case Look::unknown:
      return "35";
    case Look::stale:
      return "90";
    case Look::alarm:
      return "31";
  }
  return "";
}

std::string painted(std::string_view text, Look look, bool colours) {
  const std::string_view code = colours ? code_of(look) : std::string_view();
  return code.empty() ? std::string(text) : fmt::format("\x1b[{}m{}\x1b[0m", code, text);
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
    leave_out_what_has_no_room();
  }

  [[nodiscard]] std::vector<std::string> lines() const {
    Row head;
    for (const Column& column : columns()) {
      head.push_back({std::string(column.title), Look::plain});
    }
    std::vector<std::string> lines{line_of(head)};
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

  void leave_out_what_has_no_room() {
    const std::vector<Column> all = columns();
    for (int importance = 1; style_.width != 0 && width() > style_.width; ++importance) {
      const auto least = std::find_if(all.begin(), all.end(), [importance](const Column& column) {
        return column.importance == importance;
      });
      if (least == all.end() || least == all.begin()) {
        return;  // the node is always shown
      }
      shown_[static_cast<std::size_t>(least - all.begin())] = false;
    }
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
      line += painted(row[i].text, row[i].look, style_.colours);
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

std::string cut(const std::string& line, std::size_t width) {
  return width != 0 && line.size() > width ? line.substr(0, width) : line;
}

}  // namespace

std::vector<std::string> table_of(const FleetView& view, const TableStyle& style) {
  std::vector<std::string> lines{cut(bus_line(view), style.width)};
  for (const std::string& alarm : alarms_of(view)) {
    lines.push_back(painted(cut(alarm, style.width), Look::alarm, style.colours));
  }
  std::vector<Row> rows;
  for (const auto& [number, node] : view.nodes) {
    rows.push_back(cells_of(node, view.now_ns));
  }
  for (std::string& line : Table(std::move(rows), style).lines()) {
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace host_sim::monitor
