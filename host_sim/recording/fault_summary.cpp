#include "host_sim/recording/fault_summary.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

namespace host_sim::recording {

std::vector<FaultSummary> summary_of(const std::vector<Fault>& faults) {
  std::map<std::pair<ProfileColumnId, Fault::Kind>, FaultSummary> summaries;
  std::map<std::pair<ProfileColumnId, Fault::Kind>, std::set<std::string>> sessions;
  for (const Fault& fault : faults) {
    const auto key = std::pair(fault.channel, fault.kind);
    FaultSummary& summary = summaries[key];
    if (summary.faults == 0) {
      summary.channel = fault.channel;
      summary.kind = fault.kind;
      summary.words = fault.words;
    }
    sessions[key].insert(fault.session);
    ++summary.faults;
    summary.samples += fault.count;
  }
  std::vector<FaultSummary> all;
  for (auto& [key, summary] : summaries) {
    summary.sessions = sessions[key].size();
    if (summary.faults > 1) {
      summary.words +=
          fmt::format("; {} times like this, in {} session{} and {} samples", summary.faults,
                      summary.sessions, summary.sessions == 1 ? "" : "s", summary.samples);
    }
    all.push_back(std::move(summary));
  }
  return all;
}

}  // namespace host_sim::recording
