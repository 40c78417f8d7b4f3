#include "host_sim/monitor/specimens/specimen_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <system_error>

#include "firmware/app/models.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/replay/results.hpp"

namespace host_sim::monitor {
namespace {

/// Of a life, from when it ended: unique, and the same when a log is read again.
std::string specimen_name(protocol::Node node, const WireLife& life) {
  constexpr std::int64_t kMs = 1'000'000;
  constexpr std::int64_t kSecond_ms = 1000;
  const std::int64_t time_ms = life.time_ns / kMs;
  return fmt::format("node{}-tendon{}-{}.{:03}", node, life.tendon, time_ms / kSecond_ms,
                     time_ms % kSecond_ms);
}

constexpr std::string_view kAccepted = "a new file, or one that this option has written";

std::string text_of(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) {
    return {};
  }
  return hal::files::read_text_file(path, kAccepted, std::filesystem::file_size(path));
}

/// What nodes report all of whose tendons have this configuration, by how many they are.
std::set<std::uint32_t> reported_configurations(std::uint32_t configuration) {
  constexpr int kMostTendons = 32;
  std::set<std::uint32_t> reported;
  std::uint32_t combined = 0;
  for (int tendons = 1; tendons <= kMostTendons; ++tendons) {
    combined = app::combined_configuration(combined, configuration);
    reported.insert(combined);
  }
  return reported;
}

}  // namespace

SpecimenFile::SpecimenFile(const std::filesystem::path& path, const Model::Life& life,
                           std::uint32_t configuration)
    : path_(path),
      life_(life),
      text_(text_of(path)),
      configurations_(reported_configurations(configuration)) {
  if (path == "-") {
    throw hal::files::OutputError("-", "standard output has the table; accepted: a file");
  }
  const std::string head = specimens_head();
  if (text_.empty()) {
    text_ = head;
  }
  if (!text_.starts_with(head)) {
    throw hal::files::InputError(path.string(), 1, 0, "other columns than those of specimens",
                                 kAccepted);
  }
  if (text_.back() != '\n') {
    throw hal::files::InputError(path.string(), 0, 0, "the last line is cut",
                                 "a file that ends with a line feed");
  }
  for (std::size_t at = head.size(); at < text_.size(); at = text_.find('\n', at) + 1) {
    written_.insert(text_.substr(at, text_.find(',', at) - at));
  }
  const hal::files::OutputFile can_be_written(path_);
}

void SpecimenFile::update(const FleetView& view) {
  if (!begun_) {
    begun_ = true;
    save("the head", text_);
  }
  for (const auto& [number, node] : view.nodes) {
    const std::optional<bool> known = counts_with_model(node);
    const std::string node_name = fmt::format("node {}", number);
    if (known == false) {
      not_written_[node_name] = fmt::format(
          "{}: {} counts with other parameters than the model (configuration "
          "{:08x}): no rows of it",
          path_.string(), node_name, node.identity->value.configuration);
      continue;
    }
    not_written_.erase(node_name);
    for (const WireLife& life : node.wire_lives) {
      const std::string name = specimen_name(number, life);
      if (written_.contains(name)) {
        continue;
      }
      if (known) {
        write(name, life);
      } else {
        not_written_[name] = fmt::format(
            "{}: {} {}, and {} has not reported which parameters it counts with: no row",
            path_.string(), name, life.broken ? "broke" : "was replaced", node_name);
      }
    }
  }
}

std::optional<bool> SpecimenFile::counts_with_model(const NodeView& node) const {
  return node.identity ? std::optional(configurations_.contains(node.identity->value.configuration))
                       : std::nullopt;
}

void SpecimenFile::write(const std::string& name, const WireLife& life) {
  constexpr double kPpb = 1e9;
  if (!life.cycles || !(*life.cycles > 0) || life.damage_ppb == 0 ||
      is_at_least(kDamageSignal, life.damage_ppb)) {
    not_written_[name] = fmt::format("{}: {} {}, and its cycles or damage are not known: no row",
                                     path_.string(), name, life.broken ? "broke" : "was replaced");
    return;
  }
  const double tension_N =
      std::pow(life_.ipl_scale * (life.damage_ppb / kPpb) / *life.cycles, 1 / life_.ipl_exponent);
  const std::string row = specimen_row(
      name, {.cycles = *life.cycles, .effective_tension_N = tension_N, .failed = life.broken});
  if (save(name, text_ + row)) {
    text_ += row;
    written_.insert(name);
  }
}

bool SpecimenFile::save(const std::string& what, const std::string& text) {
  try {
    hal::files::write_file(path_, text);
    not_written_.erase(what);
    return true;
  } catch (const hal::files::OutputError& error) {
    not_written_[what] = error.what();
    return false;
  }
}

std::string SpecimenFile::trouble() const {
  if (not_written_.empty()) {
    return {};
  }
  const std::string& first = not_written_.begin()->second;
  return not_written_.size() == 1 ? first
                                  : fmt::format("{} (and {} more)", first, not_written_.size() - 1);
}

}  // namespace host_sim::monitor
