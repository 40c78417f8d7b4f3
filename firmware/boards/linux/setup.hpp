#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "firmware/app/config.hpp"
#include "firmware/app/models.hpp"
#include "firmware/boards/linux/config.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace boards::linux_controller {

/// Reads the key of a node: 32 hexadecimal digits in a regular file that only its owner may read or
/// write, as OpenSSH asks of private keys. Throws hal::files::InputError.
app::Key read_authority_key(const std::filesystem::path& path);

/// Reads a parameter block that `host_sim pack` made, with its extension if it has one, for a loop
/// of this period. Throws hal::files::InputError.
lifemodel::ExtendedParameters read_model(const std::filesystem::path& path,
                                         std::uint32_t period_us);

/// All that a run needs, checked.
struct Setup {
  Config config;
  app::Config node;
  std::vector<lifemodel::ExtendedParameters> models;  ///< one a tendon
  std::vector<app::Evaluates> evaluates;              ///< of each tendon
  bool virtual_clock = false;

  /// Whether a model is extended; then those of all tendons are evaluated as extended ones.
  [[nodiscard]] bool extended() const;
};

/// Reads what a configuration names. Throws hal::files::InputError, also where the sensor needs a
/// drive that the parameters do not have, or an extension what is not measured.
Setup read_setup(const Config& config, bool virtual_clock);

}  // namespace boards::linux_controller
