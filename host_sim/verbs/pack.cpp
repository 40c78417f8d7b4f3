#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "hal/files/output_file.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/extension/acting.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace host_sim {

using hal::files::InputKind;
using hal::files::OutputFile;
using hal::files::ProfileChannels;

namespace {

struct PackArguments {
  std::string model;
  std::string out;
  std::string format = "bin";
  std::vector<std::string> without;
};

using Block = std::vector<std::byte>;

Block block_of(const Model& model, const std::string& name) {
  Block block(lifemodel::kMostExtendedBytes);
  block.resize(lifemodel::encode(extended_parameters_of(model, name), block).size());
  return block;
}

std::string as_binary(const Block& block) {
  return {reinterpret_cast<const char*>(block.data()), block.size()};
}

/// Without the effects that the controller has no inputs for.
Model without(Model model, const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    if (extension_of(model.extensions, id) == nullptr) {
      std::cerr << "  " << id << ": not in the model, nothing to leave out\n";
    }
  }
  std::erase_if(model.extensions, [&](const Extension& extension) {
    return std::ranges::find(ids, extension.id) != ids.end();
  });
  return model;
}

/// Of each extension, for which input the firmware evaluates it, or why it does not.
void tell_extensions(const Model& model) {
  const ProfileChannels all = ProfileChannels{}.set();
  const Acting current = acting_extensions(model, InputKind::kMotorCurrent, all);
  const Acting output = acting_extensions(model, InputKind::kOutputTension, all);
  for (const Extension& extension : current.extensions) {
    std::cerr << "  " << extension.id
              << (extension_of(output.extensions, extension.id) == nullptr
                      ? ": evaluated where motor current is sampled\n"
                      : ": evaluated for every input\n");
  }
  for (const Extension& extension : output.extensions) {
    if (extension_of(current.extensions, extension.id) != nullptr) {
      continue;
    }
    std::cerr << "  " << extension.id << ": "
              << (extension.id == kEmpirical ? "a correction, " : "")
              << "evaluated where output tension is sampled\n";
  }
  for (const NotEvaluated& effect : current.others) {
    if (extension_of(output.extensions, effect.id) == nullptr) {
      std::cerr << "  " << effect.id << ": not in the block; " << effect.why << '\n';
    }
  }
}

std::string as_c_array(const Block& block, const std::string& digest) {
  std::string text = fmt::format(
      "/* Parameter block of the model {}, for {}. */\n"
      "static const unsigned char tendonlife_parameter_block[{}] = {{",
      digest,
      lifemodel::block_bytes(block) == block.size() ? "lm_init() or lifemodel::decode()"
                                                    : "lifemodel::decode_extended()",
      block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    text +=
        fmt::format("{}0x{:02x},", i % 12 == 0 ? "\n    " : " ", static_cast<unsigned>(block[i]));
  }
  return text + "\n};\n";
}

std::vector<std::string> extension_ids() {
  std::vector<std::string> ids;
  for (const ExtensionKeys& keys : extension_keys()) {
    ids.emplace_back(keys.id);
  }
  return ids;
}

void run(const PackArguments& arguments) {
  check_files(
      "pack",
      {.reads = {{"MODEL", arguments.model}}, .writes = {{"--out", arguments.out}}, .fills = {}});
  const Model model = without(read_extended_model(arguments.model), arguments.without);
  const Block block = block_of(model, arguments.model);
  const std::string digest = model_digest(model);
  OutputFile out(arguments.out);
  out.write(arguments.format == "c" ? as_c_array(block, digest) : as_binary(block));
  out.commit();
  std::cerr << arguments.out << ": " << block.size() << " bytes, model " << digest << '\n';
  tell_extensions(model);
  write_next(std::cerr, "host_sim init controller, whose [[tendon]] names this block");
}

}  // namespace

void add_pack(CLI::App& app, int&) {
  auto arguments = std::make_shared<PackArguments>();
  CLI::App* verb = app.add_subcommand("pack", "The parameter block that the firmware reads");
  verb->add_option("MODEL", arguments->model, "The model, a TOML file")->required();
  verb->add_option("--out", arguments->out, "Where to write it; - is standard output")->required();
  verb->add_option("--format", arguments->format, "bin, or c for an array to compile in")
      ->check(CLI::IsMember({"bin", "c"}))
      ->capture_default_str();
  command_line::one_at_a_time(
      verb->add_option(
          "--without", arguments->without,
          "Extensions to leave out because the controller does not measure what they need"))
      ->delimiter(',')
      ->check(CLI::IsMember(extension_ids()));
  verb->footer("Example: host_sim pack host_sim/examples/upper_arm.toml --out upper_arm.bin");
  verb->callback([arguments] { run(*arguments); });
}

}  // namespace host_sim
