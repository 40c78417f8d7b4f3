#include "tests/blind/scoring/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "hal/files/output_file.hpp"
#include "tests/blind/making/make.hpp"

namespace blind {
namespace {

using host_sim::diagnose::Verdict;

constexpr std::array<std::pair<Verdict, std::string_view>, 4> kVerdicts{
    {{Verdict::none, "none"},
     {Verdict::named, "named"},
     {Verdict::ambiguous, "ambiguous"},
     {Verdict::unknown, "unknown"}}};

using Json = nlohmann::ordered_json;
using host_sim::diagnose::Candidate;
using host_sim::diagnose::Estimate;
using host_sim::diagnose::Findings;
using host_sim::diagnose::FoundEffect;
using host_sim::diagnose::Metric;

Json json_of(const FoundEffect& effect) {
  Json parameters = Json::array();
  for (const Estimate& estimate : effect.parameters) {
    parameters.push_back({{"name", estimate.name},
                          {"value", estimate.value},
                          {"low", estimate.low},
                          {"high", estimate.high}});
  }
  return {{"id", effect.id},
          {"probability", effect.probability},
          {"parameters", std::move(parameters)}};
}

FoundEffect effect_of(const Json& json) {
  FoundEffect effect;
  effect.id = json.at("id").get<std::string>();
  effect.probability = json.at("probability").get<double>();
  for (const Json& parameter : json.at("parameters")) {
    Estimate estimate;
    estimate.name = parameter.at("name").get<std::string>();
    estimate.value = parameter.at("value").get<double>();
    estimate.low = parameter.at("low").get<double>();
    estimate.high = parameter.at("high").get<double>();
    effect.parameters.push_back(std::move(estimate));
  }
  return effect;
}

Json json_of(const Findings& findings) {
  Json effects = Json::array();
  for (const FoundEffect& effect : findings.effects) {
    effects.push_back(json_of(effect));
  }
  Json candidates = Json::array();
  for (const Candidate& candidate : findings.candidates) {
    candidates.push_back({{"id", candidate.id}, {"probability", candidate.probability}});
  }
  Json gain = Json::array();
  for (const Metric& metric : findings.gain.metrics) {
    gain.push_back({{"name", metric.name}, {"before", metric.before}, {"after", metric.after}});
  }
  return {{"verdict", verdict_name(findings.verdict)},
          {"effects", std::move(effects)},
          {"candidates", std::move(candidates)},
          {"credible_set", findings.credible_set},
          {"equivalent_sets", findings.equivalent_sets},
          {"held_out_by", findings.gain.held_out_by},
          {"gain", std::move(gain)}};
}

Findings findings_of(const Json& json) {
  Findings findings;
  findings.verdict = verdict_named(json.at("verdict").get<std::string>());
  for (const Json& effect : json.at("effects")) {
    findings.effects.push_back(effect_of(effect));
  }
  for (const Json& candidate : json.at("candidates")) {
    findings.candidates.push_back(
        {candidate.at("id").get<std::string>(), candidate.at("probability").get<double>()});
  }
  findings.credible_set = json.at("credible_set").get<std::vector<std::string>>();
  findings.equivalent_sets =
      json.at("equivalent_sets").get<std::vector<std::vector<std::string>>>();
  findings.gain.held_out_by = json.at("held_out_by").get<std::string>();
  for (const Json& metric : json.at("gain")) {
    findings.gain.metrics.push_back({metric.at("name").get<std::string>(),
                                     metric.at("before").get<double>(),
                                     metric.at("after").get<double>()});
  }
  return findings;
}

std::vector<std::string> sorted_ids(const Scenario& truth) {
  std::vector<std::string> ids;
  for (const HiddenEffect& effect : truth.hidden) {
    ids.push_back(effect.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  for (const auto& [one, word] : kVerdicts) {
    if (one == verdict) {
      return word;
    }
  }
  return "";
}

Verdict verdict_named(const std::string& word) {
  for (const auto& [verdict, text] : kVerdicts) {
    if (text == word) {
      return verdict;
    }
  }
  throw std::runtime_error("a record with the unknown verdict " + word);
}

std::string line_of(const Record& record) {
  const Json json{{"truth", Json::parse(truth_text(record.truth, ""))},
                  {"truth_sha256", record.truth_sha256},
                  {"visibility", record.visibility},
                  {"rmse_floor_N", record.rmse_floor_N},
                  {"findings", json_of(record.findings)},
                  {"error", record.error},
                  {"seconds", record.seconds}};
  return json.dump();
}

Record record_of(const std::string& line) {
  const Json json = Json::parse(line);
  Record record;
  record.truth = scenario_of(json.at("truth").dump());
  record.truth_sha256 = json.at("truth_sha256").get<std::string>();
  record.visibility = json.at("visibility").get<std::vector<double>>();
  record.rmse_floor_N = json.value("rmse_floor_N", 0.0);
  record.findings = findings_of(json.at("findings"));
  record.error = json.at("error").get<std::string>();
  record.seconds = json.at("seconds").get<double>();
  return record;
}

std::string answer_of(const Scenario& truth) {
  switch (truth.kind) {
    case CampaignKind::none:
      return "none";
    case CampaignKind::outside:
      return "unknown";
    case CampaignKind::one:
    case CampaignKind::two:
    case CampaignKind::three:
      break;
  }
  return fmt::format("{}", fmt::join(sorted_ids(truth), "+"));
}

std::string short_line_of(const Record& record) {
  constexpr std::size_t kShown = 3;
  const auto& findings = record.findings;
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < std::min(kShown, findings.candidates.size()); ++i) {
    shown.push_back(
        fmt::format("{} {:.3f}", findings.candidates[i].id, findings.candidates[i].probability));
  }
  const bool outside = record.truth.kind == CampaignKind::outside;
  const std::string truth =
      outside ? "outside:" + record.truth.hidden.front().id : answer_of(record.truth);
  const std::string design =
      record.truth.data == Data::lives
          ? fmt::format("lives {}", record.truth.specimens)
          : fmt::format("{} {}", name_of(record.truth.design), name_of(record.truth.input));
  return fmt::format("{} {} z=[{:.1f}] {} -> {} | {} | {:.1f} s{}", record.truth.seed, design,
                     fmt::join(record.visibility, ", "), truth, verdict_name(findings.verdict),
                     fmt::join(shown, ", "), record.seconds,
                     record.error.empty() ? "" : " | " + record.error);
}

RecordsFile::RecordsFile(std::filesystem::path path) : path_(std::move(path)) {
  read();
  file_.open(path_, std::ios::app);
  if (!file_) {
    throw hal::files::OutputError(path_.string(), "it cannot be opened");
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
    throw hal::files::OutputError(path_.string(), "it cannot be written");
  }
  records_.push_back(std::move(record));
}

}  // namespace blind
