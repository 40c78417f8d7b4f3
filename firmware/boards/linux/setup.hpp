#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "firmware/app/config.hpp"
#include "firmware/boards/linux/config.hpp"
#include "lifemodel/block/parameter_block.hpp"

namespace board {

/// Reads the key of a node: 32 hexadecimal digits in a regular file that only its owner may read or
/// write, as OpenSSH asks of private keys. Throws hal::files::InputError.
app::Key read_authority_key(const std::filesystem::path& path);

/// Reads a parameter block that `host_sim pack` made, for a loop of this period. Throws
/// hal::files::InputError.
lifemodel::Parameters read_parameters(const std::filesystem::path& path, std::uint32_t period_us);

/// All that a run needs, checked.
struct Setup {
  Config config;
  app::Config node;
  std::vector<lifemodel::Parameters> parameters;  ///< one a tendon
  bool virtual_clock = false;
};

/// Reads what a configuration names. Throws hal::files::InputError, also where the sensor needs a
/// drive that the parameters do not have.
Setup read_setup(const Config& config, bool virtual_clock);

}  // namespace board
