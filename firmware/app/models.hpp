#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "firmware/storage/log_entry.hpp"
#include "firmware/storage/store.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/extension/needs.hpp"
#include "lifemodel/support/bytes.hpp"
#include "lifemodel/support/inlining.hpp"

namespace app {

/// What a board can evaluate of the extended model of a tendon.
struct Evaluates {
  bool extensions = false;
  lifemodel::extension::Input input = lifemodel::extension::Input::input_tension;
  lifemodel::extension::Measured measured{};
};

/// Why parameters of a tendon are not counted with. The numbers go over the bus.
enum class ParameterFault : std::uint8_t {
  none,
  torn,           ///< what was stored last is not whole
  block,          ///< the block does not hold, see lifemodel::BlockError
  extension,      ///< nor its extension, see lifemodel::ExtensionError
  no_extensions,  ///< this board evaluates none
  not_measured,   ///< an effect needs what this board does not measure
};

constexpr const char* to_string(ParameterFault fault) {
  switch (fault) {
    case ParameterFault::none:
      return "accepted";
    case ParameterFault::torn:
      return "the power was cut while they were written";
    case ParameterFault::block:
      return "the block does not hold";
    case ParameterFault::extension:
      return "the extension does not hold";
    case ParameterFault::no_extensions:
      return "no extensions are evaluated";
    case ParameterFault::not_measured:
      return "an effect needs what is not measured";
  }
  return "unknown";
}

/// Where the parameters of a tendon are from. The numbers go over the bus.
enum class ParameterSource : std::uint8_t { none, configured, loaded };

/// A block that was not taken, and why.
struct ParameterRefusal {
  ParameterFault fault = ParameterFault::none;
  std::uint8_t effect = 0;     ///< where not_measured, see lifemodel::extension::Unmet
  std::uint8_t covariate = 0;  ///< the same
  std::uint32_t crc = 0;       ///< of the block; 0 of one that is torn

  friend constexpr bool operator==(const ParameterRefusal&, const ParameterRefusal&) = default;
};

/// Whether a board can count with a model.
constexpr ParameterRefusal refusal_of(const lifemodel::ExtendedParameters& model,
                                      const Evaluates& evaluates, std::uint32_t crc) {
  if (model.extension.effects == 0) {
    return {};
  }
  if (!evaluates.extensions) {
    return {.fault = ParameterFault::no_extensions, .crc = crc};
  }
  const auto unmet =
      lifemodel::extension::unmet(model.extension, evaluates.input, evaluates.measured);
  return unmet ? ParameterRefusal{ParameterFault::not_measured, unmet->number,
                                  static_cast<std::uint8_t>(unmet->covariate), crc}
               : ParameterRefusal{};
}

/// What a tendon counts with, and what was refused beside it.
struct ParameterState {
  ParameterSource source = ParameterSource::none;
  ParameterRefusal refusal{};
  std::uint32_t configuration = 0;  ///< CRC-32 of the block that is counted with; 0 without one
  Evaluates evaluates{};
};

template <std::size_t kTendons>
using ExtendedModels = std::array<lifemodel::ExtendedParameters, kTendons>;

/// The blocks that came with the firmware or its configuration, if any.
template <std::size_t kTendons>
using ConfiguredModels = std::array<std::optional<lifemodel::ExtendedParameters>, kTendons>;

/// The models to start with.
template <std::size_t kTendons>
struct StartingModels {
  ExtendedModels<kTendons> models{};
  std::array<ParameterState, kTendons> states{};

  [[nodiscard]] bool has(std::size_t tendon) const {
    return states[tendon].source != ParameterSource::none;
  }
};

/// The same for an estimator with this type of model, with or without extensions of the life.
template <class Model, std::size_t kTendons>
std::array<Model, kTendons> estimated(const ExtendedModels<kTendons>& models) {
  std::array<Model, kTendons> result{};
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    if constexpr (std::is_same_v<Model, lifemodel::Parameters>) {
      result[tendon] = models[tendon].nominal;
    } else {
      result[tendon] =
          lifemodel::extension::life_parameters(models[tendon].nominal, models[tendon].extension);
    }
  }
  return result;
}

/// CRC-32 at the end of the block that these make.
inline std::uint32_t configuration_of(const lifemodel::ExtendedParameters& model) {
  return lifemodel::ExtendedBlock(model).crc();
}

/// What a node reports of the configurations of its tendons: 0, with each of them in turn.
inline std::uint32_t combined_configuration(std::uint32_t before, std::uint32_t configuration) {
  std::array<std::byte, 8> bytes{};
  lifemodel::ByteWriter out(bytes);
  out.u32(before);
  out.u32(configuration);
  return lifemodel::crc32(bytes);
}

/// The fault of a block that is refused.
constexpr ParameterFault fault_of(const lifemodel::ExtendedBlockError& error) {
  return error.extension != lifemodel::ExtensionError::none ? ParameterFault::extension
                                                            : ParameterFault::block;
}

namespace detail {

/// Takes up the model that was read, unless the board cannot evaluate it.
inline void take(const lifemodel::ExtendedParameters& model, std::uint32_t crc,
                 ParameterSource source, ParameterState& state) {
  const ParameterRefusal refusal = refusal_of(model, state.evaluates, crc);
  if (refusal.fault != ParameterFault::none) {
    state.refusal = refusal;
    return;
  }
  state.source = source;
  state.configuration = crc;
}

/// The same of the block that the store has of a tendon.
template <storage::Store StoreT>
LIFEMODEL_ONE_COPY void take_stored(StoreT& store, std::size_t tendon,
                                    lifemodel::ExtendedParameters& model, ParameterState& state) {
  const auto block = store.load_parameters(tendon);
  if (!block) {
    return;
  }
  const auto error = lifemodel::read_extended(block->bytes(), model);
  if (error.refuses()) {
    state.refusal = {.fault = fault_of(error), .crc = block->crc()};
  } else {
    take(model, block->crc(), ParameterSource::loaded, state);
  }
}

}  // namespace detail

/// The models to start with: of each tendon the one that was loaded under authority last, else the
/// one that came with the configuration. A block that is not whole or that the board cannot
/// evaluate is left for the one before it, and the state of the tendon says so.
template <std::size_t kTendons, storage::Store StoreT>
StartingModels<kTendons> starting_models(StoreT& store,
                                         const ConfiguredModels<kTendons>& configured,
                                         const std::array<Evaluates, kTendons>& evaluates = {}) {
  StartingModels<kTendons> result;
  for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
    ParameterState& state = result.states[tendon];
    lifemodel::ExtendedParameters& model = result.models[tendon];
    state.evaluates = evaluates[tendon];
    if (store.parameters_torn(tendon)) {
      state.refusal.fault = ParameterFault::torn;
    }
    detail::take_stored(store, tendon, model, state);
    if (state.source == ParameterSource::none && configured[tendon]) {
      model = *configured[tendon];
      detail::take(model, configuration_of(model), ParameterSource::configured, state);
    }
  }
  return result;
}

/// A line in the log for what was refused at the start, once for each block.
template <storage::Store StoreT>
void log_refusal(StoreT& store, std::size_t tendon, const ParameterState& state,
                 std::uint16_t epoch) {
  if (state.refusal.fault == ParameterFault::none) {
    return;
  }
  const storage::LogEntry line{.sequence = store.sequence(),
                               .event = storage::Event::parameters_refused,
                               .tendon = static_cast<std::uint8_t>(tendon),
                               .epoch = epoch,
                               .detail = state.refusal.crc};
  bool known = false;
  for (std::uint32_t i = 0; const auto entry = store.log(i); ++i) {
    if (entry->tendon == line.tendon) {
      known = (known && entry->event != storage::Event::parameters_loaded) ||
              (entry->event == line.event && entry->detail == line.detail);
    }
  }
  if (!known) {
    (void)store.append(line);
  }
}

}  // namespace app
