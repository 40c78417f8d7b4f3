#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "host_sim/io/model.hpp"
#include "host_sim/io/output_file.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/verbs/verbs.hpp"
#include "lifemodel/block/parameter_block.hpp"

namespace host_sim {
namespace {

struct Arguments {
  std::string model;
  std::string out;
  std::string format = "bin";
};

std::string as_binary(const lifemodel::ParameterBlock& block) {
  return {reinterpret_cast<const char*>(block.data()), block.size()};
}

std::string as_c_array(const lifemodel::ParameterBlock& block, const std::string& digest) {
  std::string text = fmt::format(
      "/* Parameter block of the model {}, for lm_init() or lifemodel::decode(). */\n"
      "static const unsigned char tendonlife_parameter_block[{}] = {{",
      digest, block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    text +=
        fmt::format("{}0x{:02x},", i % 12 == 0 ? "\n    " : " ", static_cast<unsigned>(block[i]));
  }
  return text + "\n};\n";
}

void run(const Arguments& arguments) {
  const Model model = read_model(arguments.model);
  const lifemodel::ParameterBlock block = lifemodel::encode(parameters_of(model, arguments.model));
  const std::string digest = model_digest(model);
  OutputFile out(arguments.out);
  out.write(arguments.format == "c" ? as_c_array(block, digest) : as_binary(block));
  out.commit();
  std::cerr << arguments.out << ": " << block.size() << " bytes, model " << digest << '\n';
}

}  // namespace

void add_pack(CLI::App& app, int&) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("pack", "The parameter block that the firmware reads");
  verb->add_option("MODEL", arguments->model, "The model, a TOML file")->required();
  verb->add_option("--out", arguments->out, "Where to write it; - is standard output")->required();
  verb->add_option("--format", arguments->format, "bin, or c for an array to compile in")
      ->check(CLI::IsMember({"bin", "c"}))
      ->capture_default_str();
  verb->footer("Example: host_sim pack host_sim/examples/upper_arm.toml --out upper_arm.bin");
  verb->callback([arguments] { run(*arguments); });
}

}  // namespace host_sim
