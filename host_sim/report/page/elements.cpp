#include "host_sim/report/page/elements.hpp"

#include <fmt/format.h>

#include "host_sim/report/page/escape.hpp"

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
      "aria-describedby=\"{0}-hint\" data-summary=\"{1}. {2}\"></div>\n"
      "<p class=\"hint\" id=\"{0}-hint\">Drag to zoom, double-click to see all. By keyboard: "
      "arrows move, + and \u2212 zoom, 0 shows all.</p>\n",
      id, html_escape(name), html_escape(summary));
}

}  // namespace host_sim::elements
