// Prints model/block.hpp: the parameter block of the paper's model.

#include <cstdio>
#include <numbers>

#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/pack/pack.hpp"

namespace {

/// The model of the paper: 0.457 mm wire, 270 deg of bend; 1 kHz, hysteresis 0.2 N.
constexpr lifemodel::pack::Constants kPaperModel{
    .ultimate_tension_N = 177.4,
    .hysteresis_N = 0.2,
    .ipl_scale = 1.53e5,
    .ipl_exponent = 1.38,
    .weibull_shape = 5.94,
    .friction_coefficient = 0.128,
    .bend_angle_rad = 1.5 * std::numbers::pi,
    .tension_per_current_N_A = 0.0325 * 9.0 * 0.88 / 0.0125,
    .current_offset_A = 0.0,
    .sample_period_s = 1e-3,
    .model_digest = 0x54455354,
};

}  // namespace

int main() {
  const auto parameters = lifemodel::pack::parameters(kPaperModel);
  if (!parameters) {
    std::fprintf(stderr, "%s\n", lifemodel::to_string(parameters.error()));
    return 1;
  }
  std::puts(
      "// Made by make_block.cpp.\n"
      "#pragma once\n\n"
      "#include <array>\n"
      "#include <cstddef>\n\n"
      "namespace target {\n\n"
      "// clang-format off\n"
      "/// The parameter block of kPaperModel.\n"
      "inline constexpr auto kPaperBlock = [](auto... bytes) {\n"
      "  return std::array{static_cast<std::byte>(bytes)...};\n"
      "}(");
  const auto block = lifemodel::encode(*parameters);
  for (std::size_t i = 0; i < block.size(); ++i) {
    std::printf("%s0x%02x%s", i % 16 == 0 ? "    " : " ", static_cast<unsigned>(block[i]),
                i + 1 == block.size() ? ");\n"
                : i % 16 == 15        ? ",\n"
                                      : ",");
  }
  std::puts("// clang-format on\n\n}  // namespace target");
}
