#include <fmt/ostream.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>

#include "host_sim/batch/deal.hpp"
#include "host_sim/calibrate/output/findings.hpp"
#include "host_sim/calibrate/output/json.hpp"
#include "host_sim/calibrate/output/table_row.hpp"
#include "host_sim/campaign/list_campaigns.hpp"
#include "host_sim/io/input_error.hpp"
#include "host_sim/io/interruption.hpp"
#include "host_sim/io/printable.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/verbs/calibrate_arguments.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kSomeRefused = 1;

/// What a rank says of one campaign, as it goes over the wire.
struct Answer {
  std::string row;
  std::string json;   ///< one line
  std::string error;  ///< one line; empty where there is none
  std::vector<std::string> findings;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Answer, row, json, error, findings)

std::string json_line(const std::string& name, const char* key, const json& value) {
  return nlohmann::ordered_json{{"folder", printable(name)}, {key, value}}.dump();
}

Answer refused(const std::string& name, const std::string& error) {
  return {calibrate::refused_row(name, error), json_line(name, "error", error), error, {}};
}

Answer calibrated(const fs::path& folder, const calibrate::CalibrateOptions& options) {
  const std::string name = folder.filename().string();
  const calibrate::CalibrateResult result = calibrate::calibrate(read_campaign(folder), options);
  std::string object = calibrate::calibrate_json(result, -1);
  object.pop_back();
  return {calibrate::table_row(name, result),
          fmt::format("{{\"folder\":{},\"result\":{}}}", json(printable(name)).dump(), object),
          {},
          calibrate::found_in(result)};
}

/// One campaign that cannot be calibrated does not stop the others.
Answer answer_for(const fs::path& folder, const calibrate::CalibrateOptions& options) {
  try {
    return calibrated(folder, options);
  } catch (const InputError& error) {
    return refused(folder.filename().string(), error.what());
  } catch (const Interruption&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return refused(folder.filename().string(), printable(folder.string() + ": " + error.what()));
  }
}

constexpr char kSeparator = '\0';

std::string joined(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) {
    text += folder.string() + kSeparator;
  }
  return text;
}

std::vector<fs::path> separated(std::string_view text) {
  std::vector<fs::path> folders;
  while (!text.empty()) {
    const std::size_t end = text.find(kSeparator);
    folders.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return folders;
}

/// The outputs, on rank 0 alone.
struct Files {
  std::optional<OutputFile> table;
  std::optional<OutputFile> json;
};

std::vector<fs::path> open_files_and_list(const CalibrateArguments& arguments, Files& files) {
  std::vector<fs::path> folders = list_campaigns(arguments.folder);
  if (folders.empty()) {
    throw InputError(arguments.folder, 0, 0, "no campaign in it",
                     "a folder of folders that hold a campaign.toml");
  }
  files.table = open_if_asked(arguments.table);
  files.json = open_if_asked(arguments.json);
  return folders;
}

/// What to do, found out by rank 0, on every rank. Nothing where rank 0 cannot go on; the error is
/// thrown there.
std::vector<fs::path> folders_for_all(batch::Ranks& ranks, const CalibrateArguments& arguments,
                                      Files& files) {
  if (ranks.rank() != 0) {
    return separated(ranks.broadcast({}));
  }
  try {
    std::vector<fs::path> folders = open_files_and_list(arguments, files);
    ranks.broadcast(joined(folders));
    return folders;
  } catch (const InputError&) {
    ranks.broadcast({});
    ranks.leave();
    throw;
  } catch (const OutputError&) {
    ranks.broadcast({});
    ranks.leave();
    throw;
  }
}

std::vector<std::string> deal_campaigns(batch::Ranks& ranks, const CalibrateArguments& arguments,
                                        const std::vector<fs::path>& folders) {
  const unsigned threads = batch::threads_of(ranks, arguments.threads);
  const std::size_t own = std::max<std::size_t>(1, folders.size() / ranks.count());
  calibrate::CalibrateOptions options = arguments.options();
  options.threads =
      std::max(1U, static_cast<unsigned>(threads / std::min<std::size_t>(own, threads)));
  options.progress = [](double) { stop_if_interrupted(); };
  std::optional<Progress> progress;
  if (ranks.rank() == 0) {
    progress.emplace("calibrate");
  }
  std::mutex mutex;
  std::size_t done = 0;
  return batch::deal(ranks, folders.size(), threads, [&](std::size_t i) {
    const Answer answer = answer_for(folders[i], options);
    const std::lock_guard lock(mutex);
    ++done;
    if (progress) {
      progress->update_share(static_cast<double>(done) / static_cast<double>(own));
    }
    return json(answer).dump();
  });
}

std::vector<Answer> decoded(const std::vector<std::string>& texts) {
  std::vector<Answer> answers;
  answers.reserve(texts.size());
  for (const std::string& text : texts) {
    answers.push_back(json::parse(text).get<Answer>());
  }
  return answers;
}

void write_table(OutputFile& file, const std::vector<Answer>& answers) {
  file.write(calibrate::table_head());
  for (const Answer& answer : answers) {
    file.write(answer.row);
  }
}

void write_json(OutputFile& file, const std::vector<Answer>& answers) {
  file.write("{\"campaigns\":[");
  const char* before = "\n";
  for (const Answer& answer : answers) {
    file.write(before);
    file.write(answer.json);
    before = ",\n";
  }
  file.write("\n]}\n");
}

int tell(const CalibrateArguments& arguments, const std::vector<Answer>& answers) {
  std::size_t refused = 0;
  std::size_t found = 0;
  for (const Answer& answer : answers) {
    if (!answer.error.empty()) {
      ++refused;
      fmt::print(std::cerr, "{}\n", answer.error);
    }
    found += arguments.fails_on(answer.findings) ? 1U : 0U;
  }
  fmt::print(summary_stream(arguments.outputs()), "{}: {} campaigns calibrated, {} refused\n",
             printable(arguments.folder), answers.size() - refused, refused);
  if (refused > 0) {
    return kSomeRefused;
  }
  return found > 0 ? kFoundInData : 0;
}

int run(batch::Ranks& ranks, const CalibrateArguments& arguments) {
  Files files;
  const std::vector<fs::path> folders = folders_for_all(ranks, arguments, files);
  if (folders.empty()) {
    return 0;
  }
  const std::vector<Answer> answers = decoded(deal_campaigns(ranks, arguments, folders));
  if (ranks.rank() != 0) {
    return 0;
  }
  write_table(*files.table, answers);
  if (files.json) {
    write_json(*files.json, answers);
  }
  commit_all({&files.table, &files.json});
  return tell(arguments, answers);
}

}  // namespace

int calibrate_batch(const CalibrateArguments& arguments) {
  batch::Ranks ranks;
  try {
    return run(ranks, arguments);
  } catch (const std::exception& error) {
    // The other ranks are ended with this one, before anybody else can tell why.
    if (ranks.count() > 1 && !ranks.has_left()) {
      std::cerr << "host_sim: " << error.what() << std::endl;
    }
    throw;
  }
}

}  // namespace host_sim
