#include <array>
#include <nlohmann/json.hpp>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "host_sim/batch/wire.hpp"
#include "host_sim/extension/read.hpp"
#include "host_sim/replay/replay.hpp"
#include "host_sim/replay/results.hpp"
#include "host_sim/verbs/batch_outputs.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/replay_arguments.hpp"
#include "host_sim/verbs/replay_list.hpp"
#include "host_sim/verbs/replay_totals.hpp"

namespace host_sim {

using hal::files::input_kind_from;
using hal::files::InputError;
using hal::files::printable;
using hal::files::ProfileReader;

namespace {

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
  ProfileReader profile(listed.path, {input_kind_from(arguments.input)});
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
  return {
      replay_table_row(listed.name, listed.model_name, result), object.dump(), {}, result.flags};
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

}  // namespace

int replay_many(const ReplayArguments& arguments) {
  batch::Ranks ranks;
  BatchOutputs outputs;
  batch::Batch batch;
  batch.label = "replay";
  batch.threads = arguments.threads;
  batch.list = [&] {
    const std::vector<ListedProfile> profiles = profiles_with_models(arguments);
    outputs.open(arguments.table, arguments.json);
    return pieces_of(profiles);
  };
  batch.work = [&](const std::string& piece, const batch::Means& means) {
    return replayed(from_piece(piece), arguments, means);
  };
  batch.refuse = [](const std::string& piece, const std::exception& error) {
    const ListedProfile listed = from_piece(piece);
    return refused(listed, batch::error_line(error, listed.path.string()));
  };
  batch.tell = [&](const std::vector<batch::Answer>& answers) {
    outputs.write(replay_table_head(), "profiles", answers);
    tell_errors(answers);
    write_totals(summary_stream(arguments.outputs()), answers);
    return status_of(answers, arguments.fail_on);
  };
  return run_batch(ranks, batch);
}

}  // namespace host_sim
