// Whatever the bytes: a model with every value in its range or an InputError.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hal/files/input_error.hpp"
#include "host_sim/model/life_interval.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/model/model_tables.hpp"
#include "tests/fuzz/io/require.hpp"

using host_sim::fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    host_sim::Model model = host_sim::parse_model(text, "fuzz");
    for (const host_sim::ModelKey& key : host_sim::model_keys()) {
      if (key.table != "drive" || model.drive) {
        require(key.range.contains(key.value(model)));
      }
    }
    require(model.counting.hysteresis_N < model.cable.ultimate_tension_N);
    if (const auto& interval = model.life.interval) {
      require(host_sim::can_be_written(*interval, model.life));
      require(interval->level > 0 && interval->level < 1);
    }
    require(host_sim::model_digest(model).size() == 8);
  } catch (const hal::files::InputError& error) {
    host_sim::fuzz::require_one_line(error.what());
  }
  return 0;
}
