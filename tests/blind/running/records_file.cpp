#include "tests/blind/running/records_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "host_sim/io/output_file.hpp"

namespace blind {

RecordsFile::RecordsFile(std::filesystem::path path) : path_(std::move(path)) {
  read();
  file_.open(path_, std::ios::app);
  if (!file_) {
    throw host_sim::OutputError(path_.string(), "it cannot be opened");
  }
}

void RecordsFile::read() {
  std::ifstream file(path_);
  std::string line;
  std::uintmax_t whole_bytes = 0;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (file.eof()) {
      std::filesystem::resize_file(path_, whole_bytes);
      return;
    }
    whole_bytes += line.size() + 1;
    try {
      records_.push_back(record_of(line));
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}:{}: not a record: {}", path_.string(), number, error.what()));
    }
  }
}

bool RecordsFile::has(std::uint64_t seed) const {
  return std::any_of(records_.begin(), records_.end(),
                     [&](const Record& record) { return record.truth.seed == seed; });
}

void RecordsFile::add(Record record) {
  file_ << line_of(record) << '\n' << std::flush;
  if (!file_) {
    throw host_sim::OutputError(path_.string(), "it cannot be written");
  }
  records_.push_back(std::move(record));
}

}  // namespace blind
