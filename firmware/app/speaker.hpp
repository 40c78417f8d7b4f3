#pragma once

#include <cstdint>
#include <optional>

#include "firmware/app/bus.hpp"
#include "firmware/app/emergencies.hpp"
#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/messages.hpp"
#include "hal/can_port.hpp"
#include "lifemodel/support/saturating.hpp"

namespace app {

/// Decides what leaves when, within the bus budget: emergencies first, then the heartbeat, the
/// status, an answer, a detail page. What cannot leave now waits with its newest value; a detail
/// page whose turn is over before it could leave is dropped and counted.
template <hal::CanPort CanT>
class Speaker {
 public:
  static constexpr hal::Time kHeartbeatPeriod = hal::seconds(1);
  static constexpr hal::Time kStatusPeriod = hal::milliseconds(100);
  static constexpr hal::Time kDetailPeriod = hal::milliseconds(100);
  static constexpr hal::Time kEmergencyInhibit = hal::milliseconds(100);
  static constexpr hal::Time kInhibit = hal::milliseconds(10);

  Speaker(CanT& can, protocol::Node node)
      : can_(can),
        node_(node),
        status_protector_(protocol::e2e::stream_of<protocol::LifeStatus>(node)),
        detail_protector_(protocol::e2e::stream_of<protocol::detail::Identity>(node)),
        emergency_protector_(protocol::e2e::stream_of<protocol::Emergency>(node)) {}

  /// The boot-up message is the first to leave.
  void start(hal::Time now) {
    budget_.start(now);
    next_heartbeat_ = now;
    next_status_ = now;
    next_detail_ = now;
    next_emergency_ = now;
  }

  /// @pre page < protocol::detail::kPages
  void select_page(std::uint8_t page) {
    page_ = page;
    selected_ = true;
  }
  void burst(std::uint8_t pages) { burst_ = pages; }
  /// Detail pages that found no room; stops.
  [[nodiscard]] std::uint8_t dropped() const { return dropped_; }
  /// Sends what is due. `reporter` gives the messages, `link` the frames of answers.
  template <class Reporter, class Link>
  void speak(hal::Time now, Reporter& reporter, Emergencies& emergencies, Link& link) {
    budget_.advance(now);
    count_late_detail(now);
    speak_emergency(now, reporter, emergencies) && speak_heartbeat(now) &&
        speak_status(now, reporter) && speak_answer(now, link) && speak_detail(now, reporter);
  }

 private:
  // Each of these is true where the ones after it may speak.

  template <class Reporter>
  bool speak_emergency(hal::Time now, Reporter& reporter, Emergencies& emergencies) {
    if (!emergencies.waiting() || now < next_emergency_) {
      return true;
    }
    protocol::Emergency message = *emergencies.next();
    message.damage_ppm = reporter.damage_ppm();
    if (!send_protected(message, emergency_protector_, true)) {
      return false;
    }
    emergencies.reported();
    next_emergency_ = now + kEmergencyInhibit;
    return true;
  }

  bool speak_heartbeat(hal::Time now) {
    if (now < next_heartbeat_) {
      return true;
    }
    const auto state = booted_ ? protocol::NmtState::operational : protocol::NmtState::boot_up;
    if (!send(protocol::encode(node_, protocol::Heartbeat{state}), false)) {
      return false;
    }
    // The state follows the boot-up message at once.
    next_heartbeat_ = booted_ ? after(next_heartbeat_, kHeartbeatPeriod, now) : now;
    booted_ = true;
    return true;
  }

  template <class Reporter>
  bool speak_status(hal::Time now, Reporter& reporter) {
    const protocol::LifeStatus status = reporter.status();
    const bool changed = !same_but_for_damage(status, reported_status_);
    if (now < next_status_ && !(changed && now >= last_status_ + kInhibit)) {
      return true;
    }
    // Nobody sees a damage that is further ahead of the store than was published.
    if (reporter.unsaved_to_publish() && !send_page(protocol::detail::Storage::kPage, reporter)) {
      return false;
    }
    if (!send_protected(status, status_protector_, false)) {
      return false;
    }
    reported_status_ = status;
    last_status_ = now;
    next_status_ = changed ? now + kStatusPeriod : after(next_status_, kStatusPeriod, now);
    return true;
  }

  template <class Link>
  bool speak_answer(hal::Time now, Link& link) {
    if (!answer_) {
      answer_ = link.next_frame(now);
    }
    if (!answer_) {
      return true;
    }
    if (!send(*answer_, false)) {
      return false;
    }
    answer_.reset();
    return true;
  }

  template <class Reporter>
  bool speak_detail(hal::Time now, Reporter& reporter) {
    const bool due = now >= next_detail_ || (burst_ != 0 && now >= last_detail_ + kInhibit);
    if (!due) {
      return true;
    }
    if (!send_page(page_, reporter)) {
      return false;
    }
    page_ = next_page();
    selected_ = false;
    if (burst_ != 0) {
      --burst_;
    }
    last_detail_ = now;
    next_detail_ = after(next_detail_, kDetailPeriod, now);
    return true;
  }

  [[nodiscard]] std::uint8_t next_page() const {
    return static_cast<std::uint8_t>((page_ + 1) % protocol::detail::kPages);
  }

  void count_late_detail(hal::Time now) {
    if (now >= next_detail_ + kDetailPeriod) {
      dropped_ = lifemodel::saturating_add(dropped_, 1);
      // A page that was asked for is late rather than left out.
      page_ = selected_ ? page_ : next_page();
      next_detail_ = after(next_detail_, kDetailPeriod, now);
    }
  }

  template <class Reporter>
  bool send_page(std::uint8_t page, Reporter& reporter) {
    return reporter.with_page(page, [this](const auto& message) {
      return send_protected(message, detail_protector_, false);
    });
  }

  template <class Message>
  bool send_protected(const Message& message, protocol::e2e::Protector& protector, bool urgent) {
    hal::CanFrame frame = protocol::encode(node_, message);
    protector.protect(frame);
    if (!send(frame, urgent)) {
      protector.withdraw();
      return false;
    }
    return true;
  }

  bool send(const hal::CanFrame& frame, bool urgent) {
    const std::uint32_t bits = worst_bits(frame);
    const bool allowed = urgent ? budget_.allows_urgent(bits) : budget_.allows(bits);
    if (!allowed || can_.send(frame) != hal::Error::none) {
      return false;
    }
    budget_.spend(bits);
    return true;
  }

  static bool same_but_for_damage(protocol::LifeStatus a, const protocol::LifeStatus& b) {
    a.damage_ppb = b.damage_ppb;
    return a == b;
  }

  /// The next of a series, in step unless `now` is behind it by more than a period.
  static hal::Time after(hal::Time due, hal::Time period, hal::Time now) {
    const hal::Time next = due + period;
    return next + period <= now ? now + period : next;
  }

  CanT& can_;
  protocol::Node node_;
  BusBudget budget_;
  protocol::e2e::Protector status_protector_;
  protocol::e2e::Protector detail_protector_;
  protocol::e2e::Protector emergency_protector_;

  bool booted_ = false;
  hal::Time next_heartbeat_{};
  hal::Time next_status_{};
  hal::Time last_status_{};
  hal::Time next_detail_{};
  hal::Time last_detail_{};
  hal::Time next_emergency_{};
  protocol::LifeStatus reported_status_;
  std::optional<hal::CanFrame> answer_;
  std::uint8_t page_ = 0;
  bool selected_ = false;  ///< by a command, and not yet sent
  std::uint8_t burst_ = 0;
  std::uint8_t dropped_ = 0;
};

}  // namespace app
