#include "host_sim/io/csv_line.hpp"

#include <algorithm>

namespace host_sim {

bool CsvLine::next() {
  if (at_end_) {
    return false;
  }
  offset_ = next_;
  broken_ = false;
  text_.clear();
  if (next_ < line_.size() && line_[next_] == '"') {
    read_quoted();
  }
  const std::size_t end = std::min(line_.find(delimiter_, next_), line_.size());
  const std::string_view rest = line_.substr(next_, end - next_);
  if (line_.substr(offset_).starts_with('"')) {
    broken_ = broken_ || !rest.empty();
  } else {
    text_ = rest;
  }
  at_end_ = end == line_.size();
  next_ = end + 1;
  return true;
}

void CsvLine::read_quoted() {
  std::size_t at = next_ + 1;
  for (;;) {
    const std::size_t quote = line_.find('"', at);
    if (quote == std::string_view::npos) {
      broken_ = true;
      next_ = line_.size();
      return;
    }
    text_ += line_.substr(at, quote - at);
    if (quote + 1 == line_.size() || line_[quote + 1] != '"') {
      next_ = quote + 1;
      return;
    }
    text_ += '"';
    at = quote + 2;
  }
}

}  // namespace host_sim
