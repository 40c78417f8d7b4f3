#include "lifemodel/block/parameter_block.hpp"
#include "tests/target/entry/entry.hpp"

bool decode_block(const std::byte* block, std::size_t size, lifemodel::Parameters* out) {
  const auto parameters = lifemodel::decode({block, size});
  if (parameters) {
    *out = *parameters;
  }
  return static_cast<bool>(parameters);
}
