#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/app/app.hpp"
#include "firmware/app/sensing.hpp"
#include "firmware/boards/qemu_mps2/image/machine.hpp"
#include "firmware/boards/qemu_mps2/image/options.hpp"
#include "firmware/boards/qemu_mps2/image/recording.hpp"
#include "firmware/boards/qemu_mps2/image/run_files.hpp"
#include "firmware/boards/qemu_mps2/image/virtual_run.hpp"
#include "hal/error.hpp"
#include "hal/qemu_mps2/virtual_devices.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/numeric/sine.hpp"

namespace firmware::qemu_mps2 {

/// Played motor currents in surroundings that follow a rule: the rotor swings by 1.5 turns either
/// way, a period in 1,000 samples, and the winding warms from 20 degrees by 1 a second at 1 kHz.
template <std::size_t kTendons>
class SwingingDrive {
 public:
  using Sample = lifemodel::extension::DriveSample;

  void put(std::span<const std::int32_t, kTendons> raw) {
    currents_.put(raw);
    ++samples_;
  }
  void set_failed(bool failed) { currents_.set_failed(failed); }

  hal::Result<Sample> isr_read(std::size_t tendon) {
    const auto current = currents_.isr_read(tendon);
    if (!current) {
      return current.error();
    }
    return Sample{*current, covariates()};
  }

 private:
  [[nodiscard]] lifemodel::extension::Covariates covariates() const {
    constexpr std::uint32_t kThousandth = 4'294'967;
    constexpr std::int32_t kRoom = 20 << lifemodel::extension::Temperature::kFractionBits;
    const lifemodel::numeric::Phase phase = samples_ * kThousandth;
    lifemodel::extension::Covariates at;
    // 82 mm/s at most.
    at.velocity = lifemodel::extension::Velocity::from_raw(
        static_cast<std::int32_t>((std::int64_t{lifemodel::numeric::sine(phase)} * 82) >> 16));
    at.rotor.raw = std::int64_t{lifemodel::numeric::cosine(phase)} * -6;
    at.sheath = lifemodel::extension::Temperature::from_raw(kRoom);
    at.winding = lifemodel::extension::Temperature::from_raw(
        kRoom + static_cast<std::int32_t>(samples_ * 66));
    return at;
  }

  hal::qemu_mps2::PlayedSensor<kTendons> currents_;
  std::uint32_t samples_ = 0;
};

/// As Machine, with an extended model and a drive that gives what it is evaluated at.
template <hal::ByteStream Stream, hal::Clock Clock, hal::qemu_mps2::Backing Backing>
class ExtendedMachine : public MachineDevices<Stream, Backing, SwingingDrive<kTendons>> {
  using Base = MachineDevices<Stream, Backing, SwingingDrive<kTendons>>;

 public:
  using Sensing = app::ExtendedSensing<typename Base::Sensor, kTendons>;
  using App =
      app::App<kTendons,
               typename Base::template Devices<typename Sensing::Sensor, Clock, hal::NoHold>,
               typename Sensing::Layout>;

  ExtendedMachine(Stream& stream, const Clock& clock, Backing& backing, const Settings& settings,
                  const lifemodel::ExtendedParameters& configured)
      : Base(stream, backing, settings),
        parameters_(app::stored_parameters<kTendons>(this->store, settings.parameters)),
        models_(app::extended_models<kTendons>(parameters_, for_all(configured))),
        sensing_(this->sensor, models_),
        app(this->devices(sensing_.sensor(), clock, hold_), settings.config, parameters_,
            sensing_.models()) {}

 private:
  using Models = app::ExtendedModels<kTendons>;

  static Models for_all(const lifemodel::ExtendedParameters& model) {
    Models models;
    models.fill(model);
    return models;
  }

  app::ParameterSet<kTendons> parameters_;
  Models models_;
  Sensing sensing_;
  hal::NoHold hold_;

 public:
  App app;
};

/// The block of the options, with or without an extension, for all tendons.
template <class File>
Failure read_extended_block(const Options& options, lifemodel::ExtendedParameters& model) {
  if (options.block == nullptr) {
    return {"block", "missing; accepted: block=FILE"};
  }
  File file(options.block, File::Mode::read);
  if (!file.is_open()) {
    return {"block", "cannot be opened"};
  }
  std::array<std::byte, lifemodel::kMostExtendedBytes + 1> bytes{};
  const auto decoded = lifemodel::decode_extended(std::span(bytes).first(file.read(bytes)));
  if (!decoded) {
    return {"block", to_string(decoded.error())};
  }
  model = *decoded;
  return {};
}

/// Plays the profile of the options in virtual time to an ExtendedMachine; every frame goes to
/// `line` as SLCAN, the channel open from the start.
template <class File, hal::ByteStream Line>
Failure run_extended(const Options& options, Line& line) {
  using Clock = hal::qemu_mps2::VirtualClock;
  using Host = ScriptedLine<Line>;

  File file(options.profile, File::Mode::read);
  auto& profile = make_once<Profile<File>>(file);
  if (const char* wrong = file.is_open() ? profile.open() : "cannot be opened") {
    return {"profile", wrong};
  }
  lifemodel::ExtendedParameters model{};
  if (const Failure failure = read_extended_block<File>(options, model)) {
    return failure;
  }
  Settings settings;
  settings.channel = hal::slcan::Channel::open;
  settings.config = options.config;
  settings.seed = options.seed;
  settings.parameters.fill(model.nominal);
  FileBacking<File> backing;
  if (options.flash != nullptr) {
    if (const char* wrong = backing.open(options.flash, kFlashBytes)) {
      return {"flash", wrong};
    }
  }
  Clock clock;
  Host host(line);
  auto& machine = make_once<ExtendedMachine<Host, Clock, FileBacking<File>>>(host, clock, backing,
                                                                             settings, model);
  Script<File> nothing(nullptr);
  if (const char* wrong = Player(machine, clock, host, profile, nothing).play()) {
    return {nullptr, wrong};
  }
  return write_summary<File>(options, machine);
}

}  // namespace firmware::qemu_mps2
