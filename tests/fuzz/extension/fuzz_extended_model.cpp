// Whatever the bytes: a model whose extensions are written as they were read and that the target
// can represent, or an InputError.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/acting.hpp"
#include "host_sim/extension/fixed.hpp"
#include "host_sim/extension/model_file.hpp"
#include "tests/fuzz/io/require.hpp"

using host_sim::Extension;
using host_sim::fuzz::require;

namespace {

constexpr std::string_view kNominal =
    "schema=1\n[cable]\ndiameter_mm=0.4\nultimate_tension_N=177.4\n[sheath]\n"
    "friction_coefficient=0.1\nbend_angle_deg=270\n[drive]\ntorque_constant_Nm_per_A=0.03\n"
    "gear_ratio=9\ngear_efficiency=0.9\nspool_radius_mm=12\ncurrent_offset_A=0\n[counting]\n"
    "sample_rate_Hz=1000\nhysteresis_N=0.2\n[life]\nmean_stress=\"gerber\"\nipl_scale=1e5\n"
    "ipl_exponent=1.4\nweibull_shape=6\n";

bool same(const Extension& a, const Extension& b) {
  if (a.id != b.id || a.values.size() != b.values.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (a.values[i].name != b.values[i].name || a.values[i].values != b.values[i].values) {
      return false;
    }
  }
  return true;
}

void check_all(const host_sim::Model& model) {
  const std::string text = std::string(kNominal) + host_sim::toml_text(model.extensions);
  const host_sim::Model again = host_sim::parse_extended_model(text, "again");
  require(again.extensions.size() == model.extensions.size());
  for (std::size_t i = 0; i < again.extensions.size(); ++i) {
    require(same(again.extensions[i], model.extensions[i]));
  }
  for (const auto kind :
       {hal::files::InputKind::kInputTension, hal::files::InputKind::kMotorCurrent,
        hal::files::InputKind::kOutputTension}) {
    const auto acting =
        host_sim::acting_extensions(model, kind, hal::files::ProfileChannels{}.set());
    require(acting.extensions.size() + acting.others.size() == model.extensions.size());
  }
  auto fixed = host_sim::fixed_extension(model, model.extensions, "model");
  fixed.each([&](lifemodel::extension::Effect effect, auto& part) {
    require(!fixed.has(effect) || part.plausible());
  });
}

void check(std::string_view text) {
  try {
    check_all(host_sim::parse_extended_model(text, "fuzz"));
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check(text);
  check(std::string(kNominal) + std::string(text));
  return 0;
}
