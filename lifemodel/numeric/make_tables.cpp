// Prints numeric/tables.hpp: cubic segments of log2(1 + f) and 2^f that meet their neighbours
// exactly (interpolation at 0, 1/3, 2/3 and 1 of each segment), which keeps both functions
// monotone.

#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace {

constexpr int kSegments = 16;

using Cubic = std::array<long double, 4>;

Cubic interpolate(long double (*f)(long double), int segment) {
  std::array<long double, 4> y{};
  for (int i = 0; i < 4; ++i) {
    y[static_cast<std::size_t>(i)] = f((segment + i / 3.0L) / kSegments);
  }
  const long double d1 = y[1] - y[0];
  const long double d2 = y[2] - 2 * y[1] + y[0];
  const long double d3 = y[3] - 3 * y[2] + 3 * y[1] - y[0];
  // Newton's forward form in u = 3t, expanded to powers of t.
  return {y[0], 3 * (d1 - d2 / 2 + d3 / 3), 9 * (d2 / 2 - d3 / 2), 27 * (d3 / 6)};
}

void print_table(const char* name, long double (*f)(long double)) {
  std::printf("inline constexpr std::array<Segment, %d> %s = {{\n", kSegments, name);
  for (int segment = 0; segment < kSegments; ++segment) {
    const Cubic c = interpolate(f, segment);
    const long double q31 = 2147483648.0L;
    std::printf("    {%lluu, %lld, %lld, %lld},\n",
                static_cast<unsigned long long>(std::llroundl(c[0] * q31)),
                std::llroundl(c[1] * 2 * q31), std::llroundl(c[2] * 4 * q31),
                std::llroundl(c[3] * 8 * q31));
  }
  std::printf("}};\n\n");
}

}  // namespace

int main() {
  std::puts(
      "// Made by make_tables.cpp.\n"
      "#pragma once\n\n"
      "#include <array>\n"
      "#include <cstdint>\n\n"
      "namespace lifemodel::numeric {\n\n"
      "/// One of 16 cubic segments c0 + t*(c1 + t*(c2 + t*c3)), 0 <= t < 1. Coefficients in Q31, "
      "c1, c2\n"
      "/// and c3 scaled by 2, 4 and 8 because a product of Q31 numbers keeps only its upper "
      "word.\n"
      "struct Segment {\n"
      "  std::uint32_t c0;\n"
      "  std::int32_t c1;\n"
      "  std::int32_t c2;\n"
      "  std::int32_t c3;\n"
      "};\n\n"
      "// clang-format off");
  print_table("kLog2Segments", [](long double f) { return std::log2(1 + f); });
  print_table("kExp2Segments", [](long double f) { return std::exp2(f); });
  std::puts("// clang-format on\n\n}  // namespace lifemodel::numeric");
}
