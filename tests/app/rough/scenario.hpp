#pragma once

#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "hal/fake/random.hpp"
#include "tests/app/rig.hpp"

namespace app {

/// How rough a run is. Everything else follows from the seed.
struct Roughness {
  std::uint32_t seed = 1;
  std::uint32_t full_ppm = 0;      ///< of frames that find no room
  std::uint32_t passive_ppm = 0;   ///< of frames that leave a controller error passive
  std::uint32_t bus_offs = 0;      ///< within the first thousand frames
  std::uint32_t missing_ppm = 0;   ///< of samples, which then are missing 1 .. 40 times in a row
  std::uint32_t missed_ppm = 0;    ///< of periods, before which 1 .. 20 were left out
  std::uint32_t unsaved_ppm = 0;   ///< of saves that fail
  std::uint32_t stop_ppm = 0;      ///< of periods in which the emergency stop changes
  std::uint32_t commands_ppm = 0;  ///< of periods in which somebody sends a command
  std::uint32_t requests_ppm = 0;  ///< of periods in which somebody sends a frame of ISO-TP
  std::uint32_t babble = 0;        ///< frames of others in each period
  std::uint32_t highest_N = 60;    ///< of the tension, which starts at 5 N

  friend std::ostream& operator<<(std::ostream& out, const Roughness& r) {
    return out << "{seed " << r.seed << ", full " << r.full_ppm << ", passive " << r.passive_ppm
               << ", offs " << r.bus_offs << ", missing " << r.missing_ppm << ", missed "
               << r.missed_ppm << ", unsaved " << r.unsaved_ppm << ", stop " << r.stop_ppm
               << ", commands " << r.commands_ppm << ", requests " << r.requests_ppm << ", babble "
               << r.babble << ", highest " << r.highest_N << '}';
  }
};

/// A rough run of the application, with an estimator beside it that gets the same samples.
class Scenario {
 public:
  explicit Scenario(const Roughness& rough, double ipl_scale = 1.53e5)
      : rig(ipl_scale), rough_(rough), random_(rough.seed) {
    rig.config.key.fill(std::byte{0x5a});
    rig.can.faults = hal::fake::Faults<hal::fake::SendFault>(rough.seed);
    for (std::uint32_t i = 0; i < rough.bus_offs; ++i) {
      rig.can.faults.on_calls(random_.below(1'000), 1, hal::fake::SendFault::off);
    }
    rig.can.faults.at_random(rough.full_ppm, hal::fake::SendFault::full)
        .at_random(rough.passive_ppm, hal::fake::SendFault::passive);
    rig.store.faults = hal::fake::Faults<hal::Error>(rough.seed);
    rig.store.faults.at_random(rough.unsaved_ppm, hal::Error::failed);
    restart();
  }

  /// The application starts anew, as after a power cut.
  void restart() {
    rig.start();
    beside_.emplace(std::array{rig.models[0]->nominal});
    missing_left_ = 0;
  }

  void run(std::uint32_t milliseconds) {
    for (std::uint32_t i = 0; i < milliseconds; ++i) {
      step();
    }
  }

  /// From now on all is well: no faults, no load, nobody else on the bus, the stop released.
  void calm() {
    rig.can.faults.clear();
    rig.store.faults.clear();
    rig.stop.set(false);
    rough_ = {.seed = rough_.seed, .highest_N = 5};
    missing_left_ = 0;
  }

  /// Damage of the estimator that gets the same samples as the one of the application.
  [[nodiscard]] lifemodel::Damage damage_beside() { return beside_->reading(0).total; }

  /// When what began, as the world saw it.
  struct Event {
    hal::Time time;
    protocol::EmergencyCode code;
  };
  [[nodiscard]] const std::vector<Event>& events() const { return events_; }

  Rig<1> rig;

 private:
  using Code = protocol::EmergencyCode;

  bool chance(std::uint32_t ppm) { return random_.below(1'000'000) < ppm; }

  void note(bool& before, bool now, Code code) {
    if (now && !before) {
      events_.push_back({rig.clock.now(), code});
    }
    before = now;
  }

  void step() {
    rig.clock.advance(hal::milliseconds(1));
    others_speak();
    if (chance(rough_.stop_ppm)) {
      rig.stop.set(!pulled_);
    }
    note(pulled_, *rig.stop.asserted(), Code::emergency_stop);
    if (chance(rough_.missed_ppm)) {
      const std::uint32_t periods = 1 + random_.below(20);
      rig.app->isr_missed(periods);
      beside_->push_missing(0, periods);
    }
    sample();
    while (rig.app->settle()) {
    }
    while (beside_->settle()) {
    }
    rig.app->poll();
  }

  void sample() {
    if (missing_left_ == 0 && chance(rough_.missing_ppm)) {
      missing_left_ = 1 + random_.below(40);
    }
    missing_left_ -= missing_left_ != 0 ? 1 : 0;
    if (missing_left_ != 0) {
      beside_->push_missing(0);
      without_ = without_ < 16 ? without_ + 1 : without_;
    } else {
      const double span_N = rough_.highest_N - 5.0;
      const double tension_N = 5.0 + span_N * random_.below(1'001) / 1'000;
      const auto tension = lifemodel::pack::tension(tension_N, 177.4);
      rig.sensor.give(0, tension);
      beside_->push(0, tension);
      without_ = 0;
    }
    note(faulty_, without_ == 16, Code::sensor);
    rig.app->isr_sample();
  }

  void others_speak() {
    for (std::uint32_t i = 0; i < rough_.babble; ++i) {
      say({.id = random_.below(0x800), .length = 8});
    }
    if (chance(rough_.commands_ppm)) {
      hal::CanFrame frame = protocol::encode(
          kNode, protocol::Command{static_cast<protocol::CommandCode>(1 + random_.below(3)),
                                   static_cast<std::uint8_t>(random_.below(256))});
      commander_.protect(frame);
      say(frame);
    }
    if (chance(rough_.requests_ppm)) {
      say(request());
    }
  }
  void say(const hal::CanFrame& frame) { (void)rig.tester.send(frame); }

  /// Requests that are answered at length, refused, or no requests at all.
  hal::CanFrame request() {
    static constexpr std::array<std::array<std::uint8_t, 8>, 6> kRequests{{
        {0x03, 0x22, 0x02, 0x00},
        {0x03, 0x22, 0xf1, 0x8c},
        {0x02, 0x3e, 0x00},
        {0x30, 0x00, 0x00},
        {0x05, 0x31, 0x01, 0x02, 0x01, 0x00},
        {0x10, 0x14, 0x31, 0x01, 0x02, 0x01, 0x00, 0x01},
    }};
    hal::CanFrame frame{
        .id = 0x18da00f1u + (std::uint32_t{kNode} << 8), .extended = true, .length = 8};
    const auto& bytes = kRequests[random_.below(kRequests.size())];
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      frame.data[i] = std::byte{bytes[i]};
    }
    if (chance(200'000)) {
      frame.data[random_.below(8)] = static_cast<std::byte>(random_.below(256));
    }
    return frame;
  }

  Roughness rough_;
  hal::fake::Random random_;
  protocol::e2e::Protector commander_{protocol::e2e::stream_of<protocol::Command>(kNode)};
  std::optional<lifemodel::Estimator<1>> beside_;
  std::vector<Event> events_;
  std::uint32_t missing_left_ = 0;
  std::uint32_t without_ = 0;
  bool pulled_ = false;
  bool faulty_ = false;
};

}  // namespace app

namespace rc {

template <>
struct Arbitrary<app::Roughness> {
  static Gen<app::Roughness> arbitrary() {
    using app::Roughness;
    const auto up_to = [](std::uint32_t highest) {
      return gen::inRange<std::uint32_t>(0, highest + 1);
    };
    return gen::build<Roughness>(
        gen::set(&Roughness::seed, gen::inRange<std::uint32_t>(1, 1u << 30)),
        gen::set(&Roughness::full_ppm, up_to(500'000)),
        gen::set(&Roughness::passive_ppm, up_to(10'000)), gen::set(&Roughness::bus_offs, up_to(3)),
        gen::set(&Roughness::missing_ppm, up_to(2'000)),
        gen::set(&Roughness::missed_ppm, up_to(1'000)),
        gen::set(&Roughness::unsaved_ppm, up_to(300'000)),
        gen::set(&Roughness::stop_ppm, up_to(3'000)),
        gen::set(&Roughness::commands_ppm, up_to(100'000)),
        gen::set(&Roughness::requests_ppm, up_to(100'000)), gen::set(&Roughness::babble, up_to(10)),
        gen::set(&Roughness::highest_N, gen::inRange<std::uint32_t>(6, 200)));
  }
};

}  // namespace rc
