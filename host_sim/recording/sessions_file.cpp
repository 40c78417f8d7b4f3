#include "host_sim/recording/sessions_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "host_sim/campaign/columns.hpp"
#include "host_sim/campaign/csv_table.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim::recording {
namespace {

enum Column : unsigned { kSession, kSpecimen, kFile, kStartCycle, kColumnCount };

constexpr std::array<CsvColumn, kColumnCount> kColumns{{
    {.name = "session", .required = true},
    {.name = "specimen", .required = true},
    {.name = "file", .required = true},
    {.name = "start_cycle", .required = true},
}};

bool leaves_the_folder(const std::filesystem::path& file) {
  if (file.is_absolute()) {
    return true;
  }
  const std::filesystem::path normal = file.lexically_normal();
  return *normal.begin() == "..";
}

std::string file_in_row(const CsvTable& table) {
  const std::string& file = table.text(kFile);
  if (file.empty()) {
    table.place(kFile).fail("file is empty", "the path of a recording in the campaign folder");
  }
  if (leaves_the_folder(file)) {
    table.place(kFile).fail(fmt::format("file {} leaves the campaign folder", in_quotes(file)),
                            "a path within the campaign folder");
  }
  return file;
}

SessionRow row_in(const CsvTable& table) {
  SessionRow row;
  row.session = name_in_row(table, kSession);
  row.specimen = name_in_row(table, kSpecimen);
  row.file = file_in_row(table);
  row.start_cycle = table.number(kStartCycle, {0.0, 1e18});
  row.specimen_place = table.place(kSpecimen);
  row.file_place = table.place(kFile);
  return row;
}

}  // namespace

std::vector<SessionRow> parse_sessions(std::unique_ptr<ByteSource> source, std::string_view name) {
  CsvTable table(std::move(source), name, kColumns);
  std::vector<SessionRow> rows;
  std::unordered_map<std::string, std::uint64_t> lines;
  while (table.next()) {
    SessionRow row = row_in(table);
    const auto [first, is_new] = lines.try_emplace(row.session, table.line());
    if (!is_new) {
      table.place(kSession).fail(fmt::format("session {} a second time, first in line {}",
                                             in_quotes(row.session), first->second),
                                 "one row for each session");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace host_sim::recording
