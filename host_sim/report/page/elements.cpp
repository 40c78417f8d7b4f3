#include "host_sim/report/page/elements.hpp"

#include <fmt/format.h>

#include "host_sim/report/page/number_text.hpp"

namespace host_sim {
namespace {

std::string dump(const nlohmann::json& value) {
  return value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string valid_utf8(std::string_view text) {
  return nlohmann::json::parse(dump(nlohmann::json(text))).get<std::string>();
}

bool is_shown_control(char c) {
  return c == '\t' || c == '\n';
}

bool is_control(char c) {
  constexpr unsigned char kFirstPrintable = 0x20;
  constexpr unsigned char kDelete = 0x7f;
  const auto byte = static_cast<unsigned char>(c);
  return byte < kFirstPrintable || byte == kDelete;
}

}  // namespace

std::string html_escape(std::string_view text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    if (c == '&') {
      escaped += "&amp;";
    } else if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else if (c == '\'') {
      escaped += "&#39;";
    } else if (is_control(c) && !is_shown_control(c)) {
      escaped += "\ufffd";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string script_json(const nlohmann::json& value) {
  std::string safe;
  for (const char c : dump(value)) {
    if (c == '<') {
      safe += "\\u003c";
    } else if (c == '>') {
      safe += "\\u003e";
    } else if (c == '&') {
      safe += "\\u0026";
    } else {
      safe += c;
    }
  }
  return safe;
}

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

namespace host_sim::elements {

std::string tile(std::string_view name, std::string_view value, std::string_view note) {
  return fmt::format(
      "<div><dt>{}</dt><dd class=\"value\">{}</dd><dd class=\"note\">{}</dd></div>\n",
      html_escape(name), html_escape(value), html_escape(note));
}

std::string empty(std::string_view reason) {
  return fmt::format("<p class=\"empty\">{}</p>\n", html_escape(reason));
}

std::string chart_place(std::string_view id, std::string_view name, std::string_view summary) {
  return fmt::format(
      "<div class=\"chart\" data-chart=\"{0}\" tabindex=\"0\" role=\"group\" aria-label=\"{1}\" "
      "aria-describedby=\"chart-hint\" data-summary=\"{1}. {2}\"></div>\n",
      id, html_escape(name), html_escape(summary));
}

namespace {

std::string list_items(const std::vector<std::string>& sentences) {
  std::string html;
  for (const std::string& sentence : sentences) {
    html += fmt::format("<li>{}</li>\n", html_escape(sentence));
  }
  return html;
}

}  // namespace

std::string warnings(const std::vector<std::string>& warnings) {
  if (warnings.empty()) {
    return {};
  }
  return fmt::format(
      "<section class=\"warnings\" aria-labelledby=\"warnings-heading\">\n"
      "<h2 id=\"warnings-heading\">{}</h2>\n<ul>\n{}</ul>\n</section>\n",
      counted_text(warnings.size(), "warning"), list_items(warnings));
}

std::string words(const std::vector<std::string>& sentences) {
  return sentences.empty() ? std::string()
                           : fmt::format("<ul class=\"words\">\n{}</ul>\n", list_items(sentences));
}

std::string chart(const Chart& chart, std::string_view caption, std::string_view why_empty) {
  if (chart.layers.empty()) {
    return empty(why_empty);
  }
  return fmt::format("<h3>{}</h3>\n<p class=\"caption\">{}</p>\n{}", html_escape(chart.name),
                     html_escape(caption), chart_place(chart.id, chart.name, caption));
}

std::string table_or(bool has_rows, const std::string& table, std::string_view why_empty) {
  return has_rows ? table : empty(why_empty);
}

}  // namespace host_sim::elements
