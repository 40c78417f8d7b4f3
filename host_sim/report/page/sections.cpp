#include "host_sim/report/page/sections.hpp"

#include <fmt/format.h>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/escape.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::elements {
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
