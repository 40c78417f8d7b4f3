#include "firmware/boards/b_g431b_esc1/application.hpp"

#include <optional>
#include <span>

#include "lifemodel/extension/extended_block.hpp"

namespace boards::b_g431b_esc1 {

Room<Application> application_room;

namespace {

// Made by host_sim pack from model.toml.
#include "firmware/boards/b_g431b_esc1/parameter_block.inc"

/// The block that came with the firmware.
app::ConfiguredModels<kTendons> configured() {
  const auto model =
      lifemodel::decode_extended(std::as_bytes(std::span(tendonlife_parameter_block)));
  return {model ? std::optional(*model) : std::nullopt};
}

}  // namespace

App& make_application(Hardware& hardware, const app::Config& config) {
  return application_room.make(hardware, config, configured()).app();
}

}  // namespace boards::b_g431b_esc1
