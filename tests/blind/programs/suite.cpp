#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <sstream>

#include "hal/files/output_file.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "tests/blind/oracle/visibility.hpp"
#include "tests/blind/running/analyses.hpp"
#include "tests/blind/scoring/markdown.hpp"
#include "tests/blind/scoring/record.hpp"

namespace blind {
namespace {

/// What campaigns are drawn with, and what answers for them.
struct Suite {
  Scenario (*draw)(std::uint64_t seed);
  Analysis analysis;
};

Suite suite_of(std::string_view subject) {
  return subject == "recordings"  ? Suite{draw_recordings, analysis_of_recordings()}
         : subject == "two_sided" ? Suite{draw_two_sided, analysis_of_recordings()}
                                  : Suite{draw_visible_lives, analysis_of_lives()};
}

struct Arguments {
  std::string subject;
  std::uint64_t first_seed = 0;
  std::size_t campaigns = 0;
  bool tuning = false;
  std::string records, readme, only, design;
  std::filesystem::path folder;
  std::vector<std::string> without;
  bool keep = false;
  bool no_oracle = false;
  unsigned threads = 0;
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("subject", arguments.subject, "What campaigns are of")
      ->required()
      ->check(CLI::IsMember({"recordings", "two_sided", "lives"}));
  app.add_option("--first-seed", arguments.first_seed,
                 "From 100000 on to score (the standard), 1..9999 with --tuning");
  app.add_option("--campaigns", arguments.campaigns, "How many; none scores the records");
  app.add_flag("--tuning", arguments.tuning, "Seeds to tune with; they are never scored with");
  app.add_option("--records", arguments.records, "Add to this file, and leave out what it has")
      ->required();
  app.add_option("--readme", arguments.readme, "Write the tables between its marks");
  app.add_option("--only", arguments.only, "Only campaigns that hide this id, or `none`");
  app.add_option("--design", arguments.design, "Only recordings of this design")
      ->check(CLI::IsMember(
          {std::string(name_of(Design::crossed)), std::string(name_of(Design::one_pose))}));
  app.add_option("--folder", arguments.folder, "Where campaigns are made");
  app.add_option("--without", arguments.without, "Take effects out of the catalogue");
  app.add_flag("--keep", arguments.keep, "Keep campaigns and truths");
  app.add_flag("--no-oracle", arguments.no_oracle, "Do not work out how visible effects are");
  app.add_option("--threads", arguments.threads, "0 is one for each core");
}

void check_seeds(Arguments& arguments) {
  if (arguments.first_seed == 0) {
    arguments.first_seed = arguments.tuning ? kFirstTuningSeed : kFirstScoringSeed;
  }
  const std::uint64_t last = arguments.first_seed + arguments.campaigns;
  if (arguments.tuning ? last > kLastTuningSeed + 1 : arguments.first_seed < kFirstScoringSeed) {
    throw std::runtime_error("seeds 1..9999 are to tune with, those from 100000 on to score with");
  }
}

bool wanted(const Scenario& scenario, const Arguments& arguments) {
  const std::string& only = arguments.only;
  if (!arguments.design.empty() && name_of(scenario.design) != arguments.design) {
    return false;
  }
  return only.empty() || (only == "none" && scenario.hidden.empty()) ||
         std::any_of(scenario.hidden.begin(), scenario.hidden.end(),
                     [&](const HiddenEffect& effect) { return effect.id == only; });
}

std::vector<Scenario> scenarios(const Arguments& arguments, Scenario (*draw)(std::uint64_t seed),
                                const RecordsFile& records) {
  std::vector<Scenario> todo;
  for (std::size_t i = 0; i < arguments.campaigns; ++i) {
    Scenario scenario = draw(arguments.first_seed + i);
    if (!records.has(scenario.seed) && wanted(scenario, arguments)) {
      todo.push_back(std::move(scenario));
    }
  }
  return todo;
}

void run_all(const Arguments& arguments, const std::vector<Scenario>& todo,
             const Analysis& analysis, RecordsFile& records) {
  std::mutex mutex;
  RunOptions options;
  options.folder = arguments.folder.empty()
                       ? std::filesystem::temp_directory_path() / fmt::format("blind-{}", getpid())
                       : arguments.folder;
  options.keep = arguments.keep;
  options.oracle = !arguments.no_oracle;
  options.without = arguments.without;
  options.sealed = [&](std::uint64_t seed, const std::string& sha256) {
    const std::lock_guard lock(mutex);
    std::cout << fmt::format("{} sealed {}\n", seed, sha256) << std::flush;
  };
  const auto run = [&](std::size_t i) {
    Record record = run_campaign(todo[i], analysis, options);
    const std::lock_guard lock(mutex);
    std::cout << short_line_of(record) << std::endl;
    records.add(std::move(record));
  };
  host_sim::statistics::parallel_for(todo.size(), run, arguments.threads);
  if (arguments.folder.empty() && !arguments.keep) {
    std::filesystem::remove_all(options.folder);
  }
}

/// Campaigns that are scored together: recordings by design, lives by how many they are.
std::string group_of(const Record& record) {
  return record.truth.data == Data::recordings
             ? std::string(name_of(record.truth.design))
             : fmt::format("{} specimens each", record.truth.specimens);
}

/// Lives show an effect by how many specimens there are.
double first_goal_of(const Record& record) {
  if (record.truth.data == Data::recordings) {
    return kFirstGoal;
  }
  constexpr std::size_t kManySpecimens = 96;
  return record.truth.specimens < kManySpecimens ? 0.90 : 0.97;
}

std::map<std::string, std::vector<Record>> groups_of(const std::vector<Record>& records) {
  std::map<std::string, std::vector<Record>> groups;
  for (const Record& record : records) {
    groups[group_of(record)].push_back(record);
  }
  return groups;
}

/// In order of their seeds, whatever the order in which they were done.
std::vector<Record> in_order(std::vector<Record> records) {
  std::sort(records.begin(), records.end(), [](const Record& one, const Record& other) {
    return one.truth.seed < other.truth.seed;
  });
  return records;
}

void report(const Arguments& arguments, const std::vector<Record>& records) {
  std::string tables;
  for (const auto& [group, some] : groups_of(records)) {
    const std::string title =
        fmt::format("{} campaigns of {}, {}", some.size(), name_of(some.front().truth.data), group);
    const Scores scores = scores_of(some);
    const double first_goal = first_goal_of(some.front());
    std::cout << '\n' << title << '\n' << summary_of(scores, first_goal);
    tables += markdown_of(scores, title, first_goal);
  }
  if (!arguments.readme.empty() && !records.empty()) {
    std::ifstream old(arguments.readme);
    std::stringstream text;
    text << old.rdbuf();
    hal::files::OutputFile file(arguments.readme);
    file.write(with_tables(text.str(), arguments.subject, tables));
    file.commit();
  }
}

int suite(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Makes campaigns that hide something, has them analysed, and scores the answers.");
  add_options(app, arguments);
  CLI11_PARSE(app, argc, argv);
  try {
    check_seeds(arguments);
    RecordsFile records(arguments.records);
    const Suite suite = suite_of(arguments.subject);
    run_all(arguments, scenarios(arguments, suite.draw, records), suite.analysis, records);
    report(arguments, in_order(records.records()));
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace blind

int main(int argc, char** argv) {
  return blind::suite(argc, argv);
}
