#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "tests/campaign/support.hpp"

namespace host_sim {

using hal::files::InputError;

namespace {

/// Cells of a table by column.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

struct Tables {
  Table specimens;
  Table blocks;
};

template <typename T>
void shuffle(std::vector<T>& items) {
  for (std::size_t i = items.size(); i > 1; --i) {
    std::swap(items[i - 1], items[*rc::gen::inRange<std::size_t>(0, i)]);
  }
}

std::string field(const std::string& text) {
  if (*rc::gen::element(0, 1) == 0 && text.find_first_of(",\"#") == std::string::npos) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& order) {
  std::string text = *rc::gen::element("", "", "", "# comment, \"\n", "#\r\n");
  for (std::size_t i = 0; i < order.size(); ++i) {
    text += i == 0 ? "" : ",";
    text += field(cells[order[i]]);
  }
  return text + *rc::gen::element("\n", "\r\n");
}

/// The table as a CSV file, the columns in a random order.
std::string csv_of(const Table& table) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    order.push_back(i);
  }
  shuffle(order);
  std::string text = *rc::gen::element("", "\xEF\xBB\xBF") + line(table.columns, order);
  for (const std::vector<std::string>& row : table.rows) {
    text += line(row, order);
  }
  return text;
}

/// A load as five cells: by output or by input tension, or empty.
std::vector<std::string> load_cells(bool given) {
  std::vector<std::string> cells(5);
  if (!given) {
    return cells;
  }
  const double mean_N = *rc::gen::inRange(0, 300) / 7.0;
  const double amplitude_N = *rc::gen::inRange(1, 70) / 7.0;
  if (*rc::gen::element(0, 1) == 0) {
    cells[0] = fmt::format("{}", *rc::gen::inRange(0, 360) / 1.7);
    cells[1] = fmt::format("{}", mean_N);
    cells[2] = fmt::format("{}", amplitude_N);
  } else {
    cells[3] = fmt::format("{}", mean_N);
    cells[4] = fmt::format("{}", amplitude_N);
  }
  return cells;
}

void add_blocks(Table& blocks, const std::string& specimen, double& cycles) {
  const int count = *rc::gen::inRange(1, 5);
  cycles = 0;
  for (int order = 1; order <= count; ++order) {
    const double of_block = *rc::gen::inRange(1, 100'000) / 8.0;
    cycles += of_block;
    std::vector<std::string> row = load_cells(true);
    row.insert(row.end(), {specimen, fmt::format("{}", order), fmt::format("{}", of_block)});
    blocks.rows.push_back(std::move(row));
  }
}

Tables random_tables() {
  const std::vector<std::string> load{"bend_angle_deg", "output_tension_mean_N",
                                      "output_tension_amplitude_N", "input_tension_mean_N",
                                      "input_tension_amplitude_N"};
  Tables tables{{load, {}}, {load, {}}};
  tables.specimens.columns.insert(
      tables.specimens.columns.end(),
      {"specimen", "lot", "cycles", "status", "role", "days", "wire_to_bend_ratio", "group"});
  tables.blocks.columns.insert(tables.blocks.columns.end(), {"specimen", "order", "cycles"});
  const int count = *rc::gen::inRange(1, 12);
  for (int i = 0; i < count; ++i) {
    const std::string name = fmt::format("{}{}", *rc::gen::element("w ", "ä", "\"", "a,#"), i);
    double cycles = *rc::gen::inRange(1, 1'000'000) / 3.0;
    const bool in_blocks = *rc::gen::inRange(0, 3) == 0;
    if (in_blocks) {
      add_blocks(tables.blocks, name, cycles);
    }
    std::vector<std::string> row = load_cells(!in_blocks);
    row.insert(row.end(), {name, *rc::gen::element("", "7"), fmt::format("{}", cycles),
                           *rc::gen::element("failed", "suspended"),
                           *rc::gen::element("", "fit", "validation"), *rc::gen::element("", "0.5"),
                           *rc::gen::element("", "0.02"), *rc::gen::element("", "g")});
    tables.specimens.rows.push_back(std::move(row));
  }
  return tables;
}

Campaign read(const Tables& tables) {
  return test::campaign_of({std::string(test::kPaperCampaign), csv_of(tables.specimens),
                            tables.blocks.rows.empty() ? "" : csv_of(tables.blocks)});
}

std::string text_of(const Campaign::Load& load) {
  return fmt::format("{} {} {} {}", load.bend_angle_deg ? *load.bend_angle_deg : -1.0,
                     load.input_tension_mean_N, load.input_tension_amplitude_N,
                     load.effective_tension_N);
}

/// All of a campaign but the lines it stood in.
std::string text_of(const Campaign& campaign) {
  std::string text;
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    text += fmt::format("{}|{}|{}|{}|{}|{}|{}\n", specimen.name, specimen.lot, specimen.group,
                        static_cast<int>(specimen.status), static_cast<int>(specimen.role),
                        specimen.days ? *specimen.days : -1.0,
                        specimen.wire_to_bend_ratio ? *specimen.wire_to_bend_ratio : -1.0);
    for (const Campaign::Block& block : specimen.blocks) {
      text += fmt::format("  {} {}\n", text_of(block.load), block.cycles);
    }
  }
  for (const Level& level : levels_of(campaign)) {
    text += fmt::format("{} {}:", text_of(level.load), static_cast<int>(level.role));
    for (const Campaign::Specimen* const specimen : level.specimens) {
      text += " " + specimen->name;
    }
    text += "\n";
  }
  return text;
}

double number(const std::string& cell) {
  return cell.empty() ? 0.0 : std::stod(cell);
}

RC_GTEST_PROP(CampaignProperty, GivesBackWhatWasWritten, ()) {
  const Tables tables = random_tables();
  const Campaign campaign = read(tables);
  RC_ASSERT(campaign.specimens.size() == tables.specimens.rows.size());
  for (const std::vector<std::string>& row : tables.specimens.rows) {
    const auto found = std::find_if(campaign.specimens.begin(), campaign.specimens.end(),
                                    [&](const auto& one) { return one.name == row[5]; });
    RC_ASSERT(found != campaign.specimens.end());
    RC_ASSERT(found->lot == row[6]);
    RC_ASSERT(std::abs(found->cycles() - number(row[7])) <= 1e-9 * number(row[7]));
    RC_ASSERT((found->status == Campaign::Status::failed) == (row[8] == "failed"));
    RC_ASSERT((found->role == Campaign::Role::validation) == (row[9] == "validation"));
    RC_ASSERT(found->days.has_value() == !row[10].empty());
    RC_ASSERT(found->wire_to_bend_ratio.has_value() == !row[11].empty());
    RC_ASSERT(found->group == row[12]);
    const Campaign::Load& load = found->blocks.front().load;
    if (!row[3].empty()) {
      RC_ASSERT(load.input_tension_mean_N == number(row[3]));
      RC_ASSERT(load.input_tension_amplitude_N == number(row[4]));
    }
    if (!row[0].empty()) {
      RC_ASSERT(load.bend_angle_deg.has_value());
      RC_ASSERT(*load.bend_angle_deg == number(row[0]));
    }
  }
}

RC_GTEST_PROP(CampaignProperty, DoesNotDependOnOrderCommentsQuotesAndLineEnds, ()) {
  Tables tables = random_tables();
  const std::string before = text_of(read(tables));
  shuffle(tables.specimens.rows);
  shuffle(tables.blocks.rows);
  RC_ASSERT(text_of(read(tables)) == before);
}

bool can_be_trusted(const Campaign::Load& load) {
  return load.effective_tension_N >= 1e-3 &&
         load.input_tension_mean_N + load.input_tension_amplitude_N < 177.4;
}

// Any damage to a good campaign is refused, or what comes out can be calculated with.
RC_GTEST_PROP(CampaignProperty, NeverGivesACampaignThatCannotBeTrusted, ()) {
  const Tables tables = random_tables();
  test::CampaignTexts texts{std::string(test::kPaperCampaign), csv_of(tables.specimens),
                            tables.blocks.rows.empty() ? "" : csv_of(tables.blocks)};
  const auto changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    std::string& text = *rc::gen::element(0, 1) == 0 ? texts.specimens : texts.blocks;
    const auto at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
    const std::string other(1, *rc::gen::oneOf(rc::gen::arbitrary<char>(),
                                               rc::gen::element(',', '\n', '"', '-', '0', 'e')));
    text.replace(at, *rc::gen::inRange<std::size_t>(0, 3), other);
  }
  try {
    for (const Campaign::Specimen& specimen : test::campaign_of(texts).specimens) {
      RC_ASSERT(!specimen.name.empty());
      RC_ASSERT(!specimen.blocks.empty());
      for (const Campaign::Block& block : specimen.blocks) {
        RC_ASSERT(block.cycles > 0);
        RC_ASSERT(std::isfinite(block.cycles));
        RC_ASSERT(can_be_trusted(block.load));
      }
    }
  } catch (const InputError& error) {
    const std::string_view line = error.what();
    RC_ASSERT(line.find('\n') == std::string_view::npos);
    RC_ASSERT(line.find("; accepted: ") != std::string_view::npos);
  }
}

}  // namespace
}  // namespace host_sim
