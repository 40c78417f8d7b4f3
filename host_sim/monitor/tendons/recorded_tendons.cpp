#include "host_sim/monitor/tendons/recorded_tendons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <numeric>
#include <system_error>
#include <utility>

#include "firmware/protocol/codec.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "host_sim/io/natural_order.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/record/log_folder.hpp"

namespace host_sim::monitor {

using hal::files::InputError;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRecordsAccepted =
    "a folder of records, each a folder of monitor --record or a log (.log, .asc, .pcap, .pcapng)";

bool is_log(const fs::path& path) {
  const std::string end = path.extension().string();
  return end == ".log" || end == ".asc" || end == ".pcap" || end == ".pcapng";
}

std::string folder_name(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::canonical(folder, error);
  return (error ? folder : whole).filename().string();
}

}  // namespace

std::vector<Record> records_in(const fs::path& folder) {
  std::vector<fs::path> entries;
  try {
    for (const auto& entry : fs::directory_iterator(folder)) {
      entries.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(), 0, 0, error.code().message(), kRecordsAccepted);
  }
  std::sort(entries.begin(), entries.end(), naturally_before);
  std::vector<Record> records;
  const std::vector<fs::path> own = logs_in(folder);
  if (!own.empty()) {
    records.push_back({folder_name(folder), own, true});
  }
  for (const fs::path& entry : entries) {
    std::error_code error;
    if (fs::is_directory(entry, error)) {
      std::vector<fs::path> logs = logs_in(entry);
      if (!logs.empty()) {
        records.push_back({entry.filename().string(), std::move(logs), true});
      }
    } else if (fs::is_regular_file(entry, error) && is_log(entry) &&
               std::find(own.begin(), own.end(), entry) == own.end()) {
      records.push_back({entry.filename().string(), {entry}, false});
    }
  }
  if (records.empty()) {
    throw InputError(folder.string(), 0, 0, "no records in this folder", kRecordsAccepted);
  }
  return records;
}

namespace {

namespace detail = protocol::detail;

constexpr double kHour_ns = 3600e9;
constexpr double kPpb = 1e-9;

/// What a tendon did while it was heard.
class HeardTendon {
 public:
  void begin_session() { in_session_ = false; }

  void hear(std::int64_t time_ns, double damage) {
    const bool new_wire = damage < damage_;
    if (!in_session_ || new_wire || time_ns - last_ns_ > kSilence_ns) {
      sessions_.emplace_back();
      in_session_ = true;
    } else {
      const double hours = static_cast<double>(time_ns - last_ns_) / kHour_ns;
      sessions_.back().hours += hours;
      sessions_.back().damage += damage - damage_;
      of_wire_.hours += hours;
      of_wire_.damage += damage - damage_;
    }
    if (new_wire) {
      of_wire_ = {};
    }
    last_ns_ = time_ns;
    damage_ = damage;
  }

  /// All but its name and what befell its wire. @pre hours() > 0
  [[nodiscard]] RecordedTendon recorded() const {
    // Rounding, and what a power cut lost, are not what was done unheard.
    constexpr double kHeardShare = 0.99;
    const Stretch all = std::accumulate(
        sessions_.begin(), sessions_.end(), Stretch(), [](Stretch sum, const Stretch& each) {
          return Stretch{sum.hours + each.hours, sum.damage + each.damage};
        });
    RecordedTendon tendon;
    tendon.damage = damage_;
    tendon.damage_per_h = all.damage / all.hours;
    tendon.rate_log_sd = log_sd();
    if (of_wire_.hours > 0 && of_wire_.damage >= kHeardShare * damage_) {
      tendon.age_h = of_wire_.hours;
    }
    tendon.last_ns = last_ns_;
    return tendon;
  }
  [[nodiscard]] bool has_rate() const {
    return std::any_of(sessions_.begin(), sessions_.end(),
                       [](const Stretch& session) { return session.hours > 0; });
  }

 private:
  struct Stretch {
    double hours = 0;
    double damage = 0;
  };

  /// Sessions without damage are rest.
  [[nodiscard]] double log_sd() const {
    constexpr double kMost = 3;
    double hours = 0;
    double squares = 0;
    double mean = 0;
    double scatter = 0;
    for (const Stretch& session : sessions_) {
      if (session.hours >= kShortestSession_h && session.damage > 0) {
        const double log_rate = std::log(session.damage / session.hours);
        const double before = log_rate - mean;
        hours += session.hours;
        squares += session.hours * session.hours;
        mean += before * session.hours / hours;
        scatter += session.hours * before * (log_rate - mean);
      }
    }
    const double freedom = hours - squares / std::max(hours, 1e-300);
    constexpr double kRounding = 1e-9;
    return freedom > kRounding * hours ? std::min(std::sqrt(scatter / freedom), kMost) : 0;
  }

  std::vector<Stretch> sessions_;
  Stretch of_wire_;
  std::int64_t last_ns_ = 0;
  double damage_ = 0;
  bool in_session_ = false;
};

using HeardNode = std::map<std::uint8_t, HeardTendon>;

bool is_data(const SeenFrame& seen) {
  return !seen.error && !seen.flexible_data_rate && !seen.remote_request;
}

void follow(const SeenFrame& seen, const FleetView& view,
            std::map<protocol::Node, HeardNode>& heard) {
  if (const auto node = protocol::node_of<protocol::Heartbeat>(seen.frame)) {
    const auto heartbeat = protocol::decode<protocol::Heartbeat>(seen.frame);
    if (heartbeat && heartbeat->state == protocol::NmtState::boot_up) {
      for (auto& [tendon, of_tendon] : heard[*node]) {
        of_tendon.begin_session();
      }
    }
    return;
  }
  const auto page = protocol::decode<detail::TendonDamage>(seen.frame);
  if (!page) {
    return;
  }
  const protocol::Node node = *protocol::node_of<detail::TendonDamage>(seen.frame);
  const auto known = view.nodes.find(node);
  if (known == view.nodes.end()) {
    return;
  }
  // What the watch of the node made of the frame, where it trusts it.
  const auto shown = known->second.tendons.find(page->tendon);
  if (shown != known->second.tendons.end() && shown->second.time_ns == seen.time_ns) {
    heard[node][page->tendon].hear(seen.time_ns, kPpb * shown->second.value.damage_ppb);
  }
}

/// Whether its wire is broken; none where the node does not say which one is.
std::optional<bool> is_broken(const NodeView& node, std::uint8_t tendon) {
  const Timed<detail::WireHistory>* newest = nullptr;
  for (const auto& [key, page] : node.wires) {
    if (page.value.tendon == tendon && (newest == nullptr || page.time_ns >= newest->time_ns)) {
      newest = &page;
    }
  }
  if (newest != nullptr) {
    return newest->value.broken;
  }
  const bool one_is = node.status && node.status->value.broken;
  return one_is && node.tendons.size() > 1 ? std::nullopt : std::optional(one_is);
}

std::string node_name(std::string_view record, protocol::Node node) {
  return fmt::format("{}/{}", record, node);
}

}  // namespace

std::vector<RecordedTendon> recorded_tendons(const std::function<std::optional<SeenFrame>()>& next,
                                             std::string_view name) {
  Fleet nodes;
  std::map<protocol::Node, HeardNode> heard;
  std::int64_t latest_ns = 0;
  while (auto seen = next()) {
    seen->time_ns = latest_ns = std::max(latest_ns, seen->time_ns);
    nodes.see(*seen);
    if (is_data(*seen)) {
      follow(*seen, nodes.view(), heard);
    }
  }
  std::vector<RecordedTendon> tendons;
  for (const auto& [id, node] : nodes.view().nodes) {
    if (node.two_controllers) {
      throw InputError(name, 0, 0, fmt::format("two controllers have node id {}", id),
                       "a record of nodes that each have an id of their own");
    }
    for (const auto& [tendon, of_tendon] : heard[id]) {
      const std::string tendon_name = fmt::format("{}/{}", node_name(name, id), tendon);
      if (!of_tendon.has_rate()) {
        throw InputError(name, 0, 0,
                         fmt::format("the damage of {} was heard once only, and its rate never",
                                     hal::files::in_quotes(tendon_name)),
                         "a longer record");
      }
      tendons.push_back(of_tendon.recorded());
      if (const double rate = tendons.back().damage_per_h;
          !fleet::kDamagePerHourRange.contains(rate)) {
        throw InputError(
            name, 0, 0,
            fmt::format("the damage of {} rises by {:g} an hour",
                        hal::files::in_quotes(tendon_name), rate),
            fmt::format("{} an hour, and frames with the times at which they were sent",
                        hal::files::range_text(fleet::kDamagePerHourRange)));
      }
      tendons.back().name = tendon_name;
      tendons.back().broken = is_broken(node, tendon);
      tendons.back().past_lost = !node.status ||
                                 node.status->value.state == protocol::LifeState::unknown ||
                                 node.status->value.quality == protocol::Quality::untrusted;
    }
  }
  if (tendons.empty()) {
    throw InputError(name, 0, 0, "no damage of a tendon in this record",
                     "frames of a controller, of which LifeDetail page 3 has the damage");
  }
  return tendons;
}

namespace {

/// The frames of a record, one log after the other.
class RecordReader {
 public:
  explicit RecordReader(const Record& record) : record_(record) {}

  std::optional<SeenFrame> next() {
    constexpr unsigned kLookEach = 4096;
    if (++frames_ % kLookEach == 0) {
      hal::files::stop_if_interrupted();
    }
    while (true) {
      if (log_) {
        if (auto seen = log_->next()) {
          return seen;
        }
      }
      if (opened_ == record_.logs.size()) {
        return std::nullopt;
      }
      const fs::path& path = record_.logs[opened_++];
      log_ = record_.rotated
                 ? std::make_unique<CandumpLogReader>(open_whole_lines(path), path.string())
                 : open_log(path);
    }
  }

 private:
  const Record& record_;
  std::unique_ptr<LogReader> log_;
  std::size_t opened_ = 0;
  unsigned frames_ = 0;
};

/// The first of them, for a sentence.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 5;
  const std::vector<std::string> first(
      names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), kMost)));
  return fmt::format("{}{}", fmt::join(first, ", "),
                     names.size() > kMost ? fmt::format(" and {} more", names.size() - kMost) : "");
}

/// How long ago a record ended, in whole days; none where its clock is not that of the world.
std::optional<int> days_since(std::int64_t time_ns, fleet::Date today) {
  constexpr std::int64_t kFirstTrusted_s = 1'000'000'000;  // September 2001
  const std::chrono::sys_seconds time{std::chrono::seconds(time_ns / 1'000'000'000)};
  if (time.time_since_epoch().count() < kFirstTrusted_s) {
    return std::nullopt;
  }
  return (today - std::chrono::floor<std::chrono::days>(time)).count();
}

/// Names of tendons, and what is to be said of them.
struct Doubt {
  std::string_view what;
  std::vector<std::string> names = {};
};

}  // namespace

RecordedFleet read_records(const fs::path& folder, const std::vector<Record>& records,
                           double hours_per_day, fleet::Date today) {
  RecordedFleet read;
  Doubt unsure{"the controller reports a broken wire and not which, perhaps this one: "};
  Doubt lost{"the controller does not vouch for the damage so far, which may be higher: "};
  Doubt idle{"no damage was done in the record, so that none is expected: "};
  Doubt old{"the record ended days before today, and what was done since is not in it: "};
  for (const Record& record : records) {
    RecordReader reader(record);
    for (RecordedTendon& tendon : recorded_tendons([&] { return reader.next(); }, record.name)) {
      if (tendon.broken == true) {
        read.broken.push_back(tendon.name);
        continue;
      }
      if (!tendon.broken) {
        unsure.names.push_back(tendon.name);
      }
      if (tendon.past_lost) {
        lost.names.push_back(tendon.name);
      }
      if (tendon.damage_per_h == 0) {
        idle.names.push_back(tendon.name);
      }
      if (days_since(tendon.last_ns, today).value_or(0) > 1) {
        old.names.push_back(tendon.name);
      }
      fleet::TendonRow row;
      row.tendon.name = std::move(tendon.name);
      row.tendon.damage = tendon.damage;
      row.tendon.damage_per_h = tendon.damage_per_h;
      row.tendon.rate_log_sd = tendon.rate_log_sd;
      row.tendon.hours_per_day = hours_per_day;
      row.age_h = tendon.age_h;
      read.rows.push_back(std::move(row));
    }
  }
  if (read.rows.empty()) {
    throw InputError(folder.string(), 0, 0,
                     fmt::format("every tendon is broken: {}", some_of(read.broken)),
                     "records with a tendon that is whole");
  }
  for (const Doubt& doubt : {unsure, lost, idle, old}) {
    if (!doubt.names.empty()) {
      read.doubts.push_back(std::string(doubt.what) + some_of(doubt.names));
    }
  }
  return read;
}

}  // namespace host_sim::monitor
