#include "host_sim/report/page/template.hpp"

#include <ostream>
#include <stdexcept>

namespace host_sim {

void fill_template(std::ostream& out, std::string_view page, const Slots& slots) {
  constexpr std::string_view kOpen = "{{";
  constexpr std::string_view kClose = "}}";
  for (;;) {
    const std::size_t open = page.find(kOpen);
    out << page.substr(0, open);
    if (open == std::string_view::npos) {
      return;
    }
    page.remove_prefix(open + kOpen.size());
    const std::size_t close = page.find(kClose);
    if (close == std::string_view::npos) {
      throw std::logic_error("page template: a slot is not closed");
    }
    const auto slot = slots.find(page.substr(0, close));
    if (slot == slots.end()) {
      throw std::logic_error("page template: no text for slot " +
                             std::string(page.substr(0, close)));
    }
    out << slot->second;
    page.remove_prefix(close + kClose.size());
  }
}

}  // namespace host_sim
