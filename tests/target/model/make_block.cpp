// Prints model/block.hpp: the parameter block of the paper's model.

#include <cstdio>

#include "lifemodel/block/parameter_block.hpp"
#include "tests/target/model/constants.hpp"

int main() {
  const auto parameters = lifemodel::pack::parameters(target::kPaperModel);
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
