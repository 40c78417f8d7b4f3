#include "tests/report/page/page_text.hpp"

#include <utility>

namespace host_sim::page_text {

nlohmann::json data_in(const std::string& page) {
  const std::string open = "<script type=\"application/json\" id=\"page-data\">";
  const std::size_t start = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
}

std::size_t count_of(const std::string& page, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) {
    ++count;
  }
  return count;
}

std::string without_comments(std::string page) {
  for (const auto& [open, close] : {std::pair<std::string, std::string>{"<!--", "-->"},
                                    std::pair<std::string, std::string>{"/*", "*/"}}) {
    for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
      page.erase(at, page.find(close, at) + close.size() - at);
    }
  }
  return page;
}

std::string reference_out_of(const std::string& page) {
  const std::string plain = without_comments(page);
  for (const char* const reference :
       {"http://", "https://", "@import", "url(", "<link", "<iframe", "import(", "fetch(",
        "<script src", "<img", "<object", "<embed", "srcset"}) {
    if (plain.find(reference) != std::string::npos) {
      return reference;
    }
  }
  return {};
}

std::string misplaced_plot(const std::string& page, std::size_t plots) {
  const nlohmann::json charts = data_in(page)["charts"];
  if (charts.size() != plots) {
    return "data of " + std::to_string(charts.size()) + " plots";
  }
  const std::size_t places = count_of(page, " data-chart=\"");
  if (places != plots) {
    return std::to_string(places) + " places";
  }
  for (const auto& [id, chart] : charts.items()) {
    if (count_of(page, " data-chart=\"" + id + "\"") != 1) {
      return id + " has not one place";
    }
  }
  return {};
}

}  // namespace host_sim::page_text
