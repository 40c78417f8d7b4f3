#pragma once

#include <array>
#include <cstddef>

#include "lifemodel/block/parameter_block.hpp"
#include "tests/target/model/block.hpp"

namespace target {

/// The paper's model for each of `kTendons` tendons, out of its parameter block.
template <std::size_t kTendons>
std::array<lifemodel::Parameters, kTendons> paper_parameters() {
  static constexpr auto kDecoded = lifemodel::decode(kPaperBlock);
  static_assert(static_cast<bool>(kDecoded), "model/block.hpp has to be made anew");
  std::array<lifemodel::Parameters, kTendons> result{};
  result.fill(*kDecoded);
  return result;
}

}  // namespace target
