#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/batch/deal.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/io/compressed.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/replay/list_profiles.hpp"
#include "host_sim/replay/replay.hpp"
#include "host_sim/replay/results.hpp"
#include "host_sim/report/replay/flags.hpp"
#include "host_sim/verbs/outcome.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/replay_arguments.hpp"

namespace host_sim {

using hal::files::input_kind_from;
using hal::files::InputError;
using hal::files::printable;
using hal::files::ProfileReader;

namespace {

namespace fs = std::filesystem;

/// Whether an earlier run wrote `path`.
bool is_table(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    return false;
  }
  const std::string head = replay_table_head();
  std::string front(head.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(front.data(), static_cast<std::streamsize>(front.size()));
  return front == head;
}

void leave_out_tables(std::vector<ListedProfile>& profiles, const std::string& place) {
  std::erase_if(profiles, [](const ListedProfile& profile) { return is_table(profile.path); });
  if (profiles.empty()) {
    throw InputError(place, 0, 0, "no profile but tables of earlier runs",
                     "files or a folder with profiles");
  }
}

/// Profiles, and models beside them.
void refuse_overwriting(const std::vector<ListedProfile>& profiles,
                        const ReplayArguments& arguments) {
  VerbFiles files = arguments.files();
  for (const ListedProfile& profile : profiles) {
    files.reads.push_back({"PROFILE", profile.path});
    files.reads.push_back({"PROFILE", profile.model});
  }
  check_files("replay", files);
}

/// One model for all of them, that everybody can use.
void take_given_model(std::vector<ListedProfile>& profiles, const std::string& path) {
  parameters_of(read_extended_model(path), path);
  for (ListedProfile& profile : profiles) {
    profile.model = path;
    profile.model_name = path;
  }
}

/// Says so once where `--model` was forgotten.
void require_some_model(const std::vector<ListedProfile>& profiles, const std::string& place) {
  const auto is_alone = [](const ListedProfile& profile) {
    std::error_code ignored;
    return profile.model.empty() && fs::exists(profile.path, ignored);
  };
  const auto has_model = [](const ListedProfile& profile) { return !profile.model.empty(); };
  if (std::any_of(profiles.begin(), profiles.end(), is_alone) &&
      std::none_of(profiles.begin(), profiles.end(), has_model)) {
    throw InputError(place, 0, 0, "no model goes with the profiles",
                     "--model FILE, or a model.toml in the folder of a profile or above it");
  }
}

/// The profiles of a table, each with its model where there is one. Tables that earlier runs left
/// beside them are not among them.
/// @throws InputError where no profile has a model, where that of `--model` cannot be used, where
/// an output would overwrite a profile, and as list_profiles() does
std::vector<ListedProfile> profiles_with_models(const ReplayArguments& arguments) {
  const std::string& place = arguments.profiles.front();
  std::vector<ListedProfile> profiles = list_profiles(arguments.profiles);
  leave_out_tables(profiles, place);
  refuse_overwriting(profiles, arguments);
  if (!arguments.model.empty()) {
    take_given_model(profiles, arguments.model);
  } else {
    require_some_model(profiles, place);
  }
  return profiles;
}

double life_used(const nlohmann::json& profile) {
  return profile["result"]["damage"]["total"].get<double>();
}

/// The first of those with the most damage; null where all were refused.
nlohmann::json most_damaged(const std::vector<batch::Answer>& answers) {
  nlohmann::json most;
  for (const batch::Answer& answer : answers) {
    if (!answer.error.empty()) {
      continue;
    }
    nlohmann::json profile = nlohmann::json::parse(answer.json);
    if (most.is_null() || life_used(profile) > life_used(most)) {
      most = std::move(profile);
    }
  }
  return most;
}

std::ptrdiff_t profiles_with(const std::string& flag, const std::vector<batch::Answer>& answers) {
  return std::count_if(answers.begin(), answers.end(), [&](const batch::Answer& answer) {
    return std::find(answer.found.begin(), answer.found.end(), flag) != answer.found.end();
  });
}

using nlohmann::ordered_json;

std::string to_piece(const ListedProfile& profile) {
  const std::array<std::string, 4> fields{profile.path.string(), profile.name,
                                          profile.model.string(), profile.model_name};
  return batch::packed(fields);
}

ListedProfile from_piece(const std::string& piece) {
  const std::vector<std::string> fields = batch::unpacked(piece);
  return {fields[0], fields[1], fields[2], fields[3]};
}

ordered_json named(const ListedProfile& profile) {
  ordered_json object{{"profile", printable(profile.name)}};
  if (!profile.model_name.empty()) {
    object["model"] = printable(profile.model_name);
  }
  return object;
}

ReplayResult result_of(const ListedProfile& listed, const ReplayArguments& arguments,
                       const batch::Means& means) {
  ProfileReader profile(open_input(listed.path, hal::files::kAcceptedProfile), listed.path.string(),
                        {input_kind_from(arguments.input), means.threads, arguments.columns});
  if (listed.model.empty()) {
    throw InputError(listed.path.string(), 0, 0, "no model goes with it",
                     "--model FILE, or a model.toml in its folder or above it");
  }
  const Model model = read_extended_model(listed.model);
  ReplayOptions options;
  options.progress = [&](std::uint64_t bytes) {
    const auto total = static_cast<double>(profile.bytes_total());
    means.progress(total > 0 ? static_cast<double>(bytes) / total : 0);
  };
  return replay(profile, model, listed.model.string(), options);
}

batch::Answer replayed(const ListedProfile& listed, const ReplayArguments& arguments,
                       const batch::Means& means) {
  const ReplayResult result = result_of(listed, arguments, means);
  ordered_json object = named(listed);
  object["result"] = ordered_json::parse(replay_json(result));
  return {replay_table_row(listed.name, listed.model_name, result),
          object.dump(),
          {},
          found_in(result)};
}

batch::Answer refused(const ListedProfile& listed, const std::string& error) {
  ordered_json object = named(listed);
  object["error"] = error;
  return {refused_replay_row(listed.name, listed.model_name, error), object.dump(), error, {}};
}

std::vector<std::string> pieces_of(const std::vector<ListedProfile>& profiles) {
  std::vector<std::string> pieces;
  pieces.reserve(profiles.size());
  for (const ListedProfile& profile : profiles) {
    pieces.push_back(to_piece(profile));
  }
  return pieces;
}

/// A row for each profile with a cycle.
std::string specimens_of(const std::vector<batch::Answer>& answers) {
  std::string rows = specimens_head();
  for (const batch::Answer& answer : answers) {
    if (!answer.error.empty()) {
      continue;
    }
    const nlohmann::json profile = nlohmann::json::parse(answer.json);
    const nlohmann::json& life = profile["result"]["seen_life"];
    if (!life.is_null()) {
      rows += specimen_row(profile["profile"].get<std::string>(),
                           {life["cycles"].get<double>(), life["effective_tension_N"].get<double>(),
                            life["status"] == "failed"});
    }
  }
  return rows;
}

/// What a table of profiles shows, in a few lines for people. Lives of different cables are not
/// added up.
void write_totals(std::ostream& out, const std::vector<batch::Answer>& answers) {
  const auto refused =
      std::count_if(answers.begin(), answers.end(),
                    [](const batch::Answer& answer) { return !answer.error.empty(); });
  fmt::print(out, "{} profiles replayed, {} refused\n", std::ssize(answers) - refused, refused);
  if (const nlohmann::json most = most_damaged(answers); !most.is_null()) {
    fmt::print(out, "  most damage   {:.6g} in {}\n", life_used(most),
               most["profile"].get<std::string>());
  }
  for (const std::string& flag : all_findings()) {
    if (const auto count = profiles_with(flag, answers); count > 0) {
      fmt::print(out, "  flag          {} in {} of them\n", flag, count);
    }
  }
}

}  // namespace

int replay_many(const ReplayArguments& arguments) {
  batch::Ranks ranks;
  BatchOutputs outputs;
  std::optional<hal::files::OutputFile> specimens;
  batch::Batch batch;
  batch.label = "replay";
  batch.threads = arguments.threads;
  batch.list = [&] {
    const std::vector<ListedProfile> profiles = profiles_with_models(arguments);
    outputs.open(arguments.table, arguments.json);
    specimens = open_if_asked(arguments.specimens);
    return pieces_of(profiles);
  };
  batch.work = [&](const std::string& piece, const batch::Means& means) {
    return replayed(from_piece(piece), arguments, means);
  };
  batch.refuse = [](const std::string& piece, const std::exception& error) {
    const ListedProfile listed = from_piece(piece);
    return refused(listed, batch::error_line(error, listed.path.string()));
  };
  batch.report = [&](const std::vector<batch::Answer>& answers) {
    if (specimens) {
      specimens->write(specimens_of(answers));
      specimens->commit();
    }
    outputs.write(replay_table_head(), "profiles", answers);
    report_errors(answers);
    std::ostream& summary = summary_stream(arguments.outputs());
    write_totals(summary, answers);
    write_next(summary, "--report draws one of them, replayed alone");
    return status_of(answers, arguments.fail_on);
  };
  return run_batch(ranks, batch);
}

}  // namespace host_sim
