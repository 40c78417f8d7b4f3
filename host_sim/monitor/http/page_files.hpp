#pragma once

#include <string_view>

namespace host_sim::monitor {

struct PageFile {
  std::string_view name;  ///< "/", "/assets/live.css", ..
  std::string_view type;
  std::string_view text;
};

/// A file of the page, or null.
const PageFile* find_page_file(std::string_view name);

}  // namespace host_sim::monitor
