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

}  // namespace host_sim::page_text
