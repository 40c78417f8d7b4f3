#include "firmware/boards/linux/setup.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <string>

#include "firmware/boards/linux/sensors.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/extension/needs.hpp"

namespace boards::linux_controller {
namespace {

namespace fs = std::filesystem;
using hal::files::InputError;

constexpr std::string_view kKey =
    "32 hexadecimal digits in a file with mode 0600 (head -c 16 /dev/urandom | xxd -p)";

void check_mode(const fs::path& path) {
  struct ::stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    return;  // Reading it says why.
  }
  if (!S_ISREG(status.st_mode)) {
    throw InputError(path.string(), 0, 0, "not a regular file", kKey);
  }
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw InputError(path.string(), 0, 0,
                     fmt::format("its mode is {:04o}: others may use it", status.st_mode & 07777U),
                     kKey);
  }
}

}  // namespace

app::Key read_authority_key(const fs::path& path) {
  check_mode(path);
  std::string text = hal::files::read_text_file(path, kKey, 64);
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  app::Key key{};
  bool right = text.size() == 2 * key.size();
  for (std::size_t i = 0; right && i < key.size(); ++i) {
    unsigned byte = 0;
    const char* const at = text.data() + 2 * i;
    const auto [end, error] = std::from_chars(at, at + 2, byte, 16);
    right = error == std::errc() && end == at + 2;
    key[i] = static_cast<std::byte>(byte);
  }
  if (!right) {
    // Not even a wrong key is shown.
    throw InputError(path.string(), 1, 0, "not 32 hexadecimal digits", kKey);
  }
  if (key == app::Key{}) {
    throw InputError(path.string(), 1, 0, "a key of zeros",
                     "a random key; leave out authority_key to refuse all that needs one");
  }
  return key;
}

lifemodel::ExtendedParameters read_model(const fs::path& path, std::uint32_t period_us) {
  constexpr std::string_view kBlock = "a parameter block, made by `host_sim pack`";
  const std::string bytes = hal::files::read_text_file(path, kBlock, lifemodel::kMostExtendedBytes);
  const auto model = lifemodel::decode_extended(std::as_bytes(std::span(bytes)));
  if (!model) {
    throw InputError(path.string(), 0, 0, lifemodel::to_string(model.error()), kBlock);
  }
  if (model->nominal.sample_period_us != period_us) {
    throw InputError(path.string(), 0, 0,
                     fmt::format("made for a sample every {} us, and the loop has {} us",
                                 model->nominal.sample_period_us, period_us),
                     "sample_rate_Hz of the model and rate_Hz of the loop that are the same");
  }
  return *model;
}

namespace {

app::Config node_of(const Config& config) {
  app::Config node;
  node.node = config.node;
  if (config.authority_key) {
    node.key = read_authority_key(*config.authority_key);
  }
  std::transform(config.serial.begin(), config.serial.end(), node.serial.begin(),
                 [](char c) { return static_cast<std::byte>(c); });
  return node;
}

// With a virtual clock nothing else may take its time.
void check_virtual(const Config& config) {
  const bool alone = config.can.interface == kNoBus && !config.gpio &&
                     config.sensor.kind == SensorKind::profile &&
                     config.sensor.at_end == AtEnd::stop;
  if (!alone) {
    throw InputError("--virtual-clock", 0, 0, "the configuration has devices that run in real time",
                     "[can] interface \"none\", [gpio] chip \"none\", and a [sensor] of kind "
                     "\"profile\" with at_end \"stop\"");
  }
}

void check_drive(const Setup& setup) {
  if (!measures_current(setup.config)) {
    return;
  }
  for (std::size_t i = 0; i < setup.models.size(); ++i) {
    if (!setup.models[i].nominal.has_drive()) {
      throw InputError(setup.config.tendons[i].parameters.string(), 0, 0,
                       "made of a model without [drive], and the sensor measures motor current",
                       "a parameter block of a model with [drive]");
    }
  }
}

/// An output tension keeps the Capstan law of one tendon where no model is extended, so nothing is
/// extended later.
void find_evaluated(Setup& setup) {
  using lifemodel::extension::Input;
  const Input input = input_of(setup.config);
  for (const TendonConfig& tendon : setup.config.tendons) {
    setup.evaluates.push_back({input != Input::output_tension || setup.extended(), input,
                               measured_by(setup.config, tendon)});
  }
}

void check_extensions(const Setup& setup) {
  if (!setup.extended()) {
    return;
  }
  for (std::size_t i = 0; i < setup.models.size(); ++i) {
    const TendonConfig& tendon = setup.config.tendons[i];
    const app::Evaluates& evaluates = setup.evaluates[i];
    const auto unmet =
        lifemodel::extension::unmet(setup.models[i].extension, evaluates.input, evaluates.measured);
    if (unmet) {
      throw InputError(
          tendon.parameters.string(), 0, 0,
          fmt::format("{} needs {}, which is not measured", unmet->effect,
                      to_string(unmet->covariate)),
          setup.config.sensor.kind == SensorKind::profile
              ? std::string(
                    "a profile with its column, or a block made with `host_sim pack --without`")
              : fmt::format("{} in [[tendon]], or a block made with `host_sim pack --without`",
                            fmt::join(kCovariateNames, ", ")));
    }
  }
}

}  // namespace

bool Setup::extended() const {
  return std::any_of(models.begin(), models.end(),
                     [](const auto& model) { return model.extension.effects != 0; });
}

Setup read_setup(const Config& config, bool virtual_clock) {
  if (virtual_clock) {
    check_virtual(config);
  }
  Setup setup{config, node_of(config), {}, {}, virtual_clock};
  for (const TendonConfig& tendon : config.tendons) {
    setup.models.push_back(read_model(tendon.parameters, config.loop.period_us));
  }
  check_drive(setup);
  find_evaluated(setup);
  check_extensions(setup);
  return setup;
}

}  // namespace boards::linux_controller
