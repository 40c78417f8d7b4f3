#include "host_sim/campaign/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "host_sim/campaign/load_model.hpp"
#include "host_sim/io/printable.hpp"

namespace host_sim {
namespace {

using Rows = std::vector<const BlockRow*>;
using RowsBySpecimen = std::unordered_map<std::string_view, Rows>;

constexpr double kCyclesTolerance = 1e-9;

RowsBySpecimen rows_by_specimen(const std::vector<SpecimenRow>& specimens,
                                const std::vector<BlockRow>& blocks) {
  RowsBySpecimen rows;
  for (const SpecimenRow& row : specimens) {
    rows.try_emplace(row.specimen.name);
  }
  for (const BlockRow& block : blocks) {
    const auto found = rows.find(block.specimen);
    if (found == rows.end()) {
      block.specimen_place.fail(
          fmt::format("a block of {}, which is no specimen", in_quotes(block.specimen)),
          "specimens of specimens.csv");
    }
    found->second.push_back(&block);
  }
  for (auto& [name, of_one] : rows) {
    std::stable_sort(of_one.begin(), of_one.end(),
                     [](const BlockRow* a, const BlockRow* b) { return a->order < b->order; });
  }
  return rows;
}

void check_order(const Rows& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BlockRow& row = *rows[i];
    if (row.order == i + 1) {
      continue;
    }
    const std::string specimen = in_quotes(row.specimen);
    row.order_place.fail(
        row.order <= i
            ? fmt::format("order {} of specimen {} a second time, first in line {}", row.order,
                          specimen, rows[i - 1]->order_place.line)
            : fmt::format("order {} of specimen {}, but no order {}", row.order, specimen, i + 1),
        "each order once: 1, 2, 3 and so on");
  }
}

void check_cycles(const SpecimenRow& row) {
  const double sum = row.specimen.cycles();
  if (!(std::abs(sum - row.cycles) <= kCyclesTolerance * row.cycles)) {
    row.cycles_place.fail(fmt::format("specimen {} has {} cycles, but its blocks sum to {}",
                                      in_quotes(row.specimen.name), row.cycles, sum),
                          "the sum of its blocks in blocks.csv");
  }
}

void take_blocks(SpecimenRow& row, const Rows& rows, const LoadModel& model) {
  if (row.load.kind() != LoadKind::none) {
    row.load.place().fail(fmt::format("a load of specimen {}, which has blocks from line {} on",
                                      in_quotes(row.specimen.name), rows.front()->order_place.line),
                          "the load here or in blocks.csv, not both");
  }
  check_order(rows);
  for (const BlockRow* const block : rows) {
    row.specimen.blocks.push_back(
        {model.load(block->load), block->cycles, block->order_place.line});
  }
  check_cycles(row);
}

void take_load(SpecimenRow& row, const LoadModel& model) {
  if (row.load.kind() == LoadKind::none) {
    row.name_place.fail(fmt::format("specimen {} has no load", in_quotes(row.specimen.name)),
                        fmt::format("{}, or rows in blocks.csv", row.load.accepted));
  }
  row.specimen.blocks.push_back({model.load(row.load), row.cycles, row.specimen.line});
}

}  // namespace

Campaign assemble(CampaignFile file, std::vector<SpecimenRow> specimens,
                  const std::vector<BlockRow>& blocks) {
  const LoadModel model(file.nominal, file.model);
  const RowsBySpecimen rows = rows_by_specimen(specimens, blocks);
  Campaign campaign;
  for (SpecimenRow& row : specimens) {
    const Rows& of_this = rows.at(row.specimen.name);
    if (of_this.empty()) {
      take_load(row, model);
    } else {
      take_blocks(row, of_this, model);
    }
    campaign.specimens.push_back(row.specimen);
  }
  std::sort(campaign.specimens.begin(), campaign.specimens.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  campaign.name = std::move(file.name);
  campaign.nominal = file.nominal;
  campaign.uses = std::move(file.uses);
  return campaign;
}

}  // namespace host_sim
