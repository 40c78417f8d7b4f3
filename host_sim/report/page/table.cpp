#include "host_sim/report/page/table.hpp"

#include <fmt/format.h>

#include "host_sim/report/page/escape.hpp"

namespace host_sim {
Table::Table(std::string_view label, std::initializer_list<std::string_view> columns, Cells cells)
    : cell_attributes_(cells == Cells::numbers ? " class=\"number\"" : "") {
  html_ = fmt::format(
      "<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n"
      "<table>\n<thead><tr>",
      html_escape(label));
  bool first = true;
  for (const std::string_view column : columns) {
    html_ += fmt::format("<th scope=\"col\"{}>{}</th>", first ? "" : cell_attributes_,
                         html_escape(column));
    first = false;
  }
  html_ += "</tr></thead>\n<tbody>\n";
}

void Table::row(std::string_view name, const std::vector<std::string>& cells) {
  html_ += fmt::format("<tr><th scope=\"row\">{}</th>", html_escape(name));
  for (const std::string& cell : cells) {
    html_ += fmt::format("<td{}>{}</td>", cell_attributes_, html_escape(cell));
  }
  html_ += "</tr>\n";
}

std::string Table::html() const {
  return html_ + "</tbody>\n</table>\n</div>\n";
}

}  // namespace host_sim
