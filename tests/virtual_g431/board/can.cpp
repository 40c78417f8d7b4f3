#include "tests/virtual_g431/board/can.hpp"

#include <algorithm>

namespace virtual_g431 {
namespace {

// Places in the message RAM, RM0440 44.3.3.
constexpr std::uint32_t kStandardFilters = 0x000 / 4, kExtendedFilters = 0x070 / 4;
constexpr std::uint32_t kRxFifo0 = 0x0B0 / 4, kTxBuffers = 0x278 / 4, kElementWords = 18;
constexpr std::uint32_t kRxLost = bit(2), kBusOffSeen = bit(19);

/// Arbitration: the smaller goes first. Identifier, and of equal ones the standard frame.
std::uint64_t rank(const hal::CanFrame& frame) {
  return frame.extended ? (std::uint64_t{frame.id >> 18} << 19 | 1u << 18 | (frame.id & 0x3FFFF))
                        : std::uint64_t{frame.id} << 19;
}

}  // namespace

std::uint32_t bits_on_wire(const hal::CanFrame& frame) {
  std::vector<bool> bits;
  const auto add = [&bits](std::uint32_t value, unsigned count) {
    for (unsigned place = count; place-- > 0;) {
      bits.push_back((value >> place & 1) != 0);
    }
  };
  add(0, 1);
  if (frame.extended) {
    add(frame.id >> 18, 11);
    add(3, 2);  // SRR, IDE
    add(frame.id, 18);
    add(0, 3);  // RTR, r1, r0
  } else {
    add(frame.id, 11);
    add(0, 3);  // RTR, IDE, r0
  }
  add(frame.length, 4);
  for (const std::byte byte : frame.payload()) {
    add(std::to_integer<std::uint32_t>(byte), 8);
  }
  std::uint32_t crc = 0;
  for (const bool value : bits) {
    const bool next = value != ((crc >> 14 & 1) != 0);
    crc = (crc << 1 & 0x7FFF) ^ (next ? 0x4599u : 0u);
  }
  add(crc, 15);
  std::uint32_t count = 0;
  std::uint32_t run = 0;
  bool last = true;
  for (const bool value : bits) {
    run = value == last && count != 0 ? run + 1 : 1;
    last = value;
    ++count;
    if (run == 5) {
      ++count;
      last = !last;
      run = 1;
    }
  }
  constexpr std::uint32_t kDelimiterAckEnd = 1 + 2 + 7, kIntermission = 3;
  return count + kDelimiterAckEnd + kIntermission;
}

void CanController::reset() {
  ++life_;
  cccr_ = 1;
  nbtp_ = 0x06000A03;
  rxgfc_ = txbc_ = ckdiv_ = ir_ = ie_ = ils_ = ile_ = 0;
  transmit_errors_ = receive_errors_ = pending_ = done_ = 0;
  put_ = get_ = level_ = rx_put_ = rx_get_ = rx_level_ = 0;
  rx_lost_ = joined_ = bus_off_ = false;
  init_seen_at_ = 0;
}

Ticks CanController::bit_time() const {
  const Ticks quantum = clocks_.pclk1() * (field(nbtp_, 24, 16) + 1);
  return quantum * (1 + field(nbtp_, 15, 8) + 1 + field(nbtp_, 6, 0) + 1);
}

std::uint32_t CanController::read(std::uint32_t offset) {
  switch (offset) {
    case 0x18:
      return cccr_;
    case 0x1C:
      return nbtp_;
    case 0x40: {
      const std::uint32_t passive = receive_errors_ >= 128 ? bit(15) : 0;
      return std::min(transmit_errors_, 255u) | std::min(receive_errors_, 127u) << 8 | passive;
    }
    case 0x44: {
      const bool passive = transmit_errors_ >= 128 || receive_errors_ >= 128;
      const bool warning = transmit_errors_ >= 96 || receive_errors_ >= 96;
      return 0x700u | 7u | (passive ? bit(5) : 0) | (warning ? bit(6) : 0) |
             (bus_off_ ? bit(7) : 0);
    }
    case 0x50:
      return ir_;
    case 0x80:
      return rxgfc_;
    case 0x90:
      return rx_level_ | rx_get_ << 8 | rx_put_ << 16 | (rx_level_ == kFifo ? bit(24) : 0) |
             (rx_lost_ ? bit(25) : 0);
    case 0xC0:
      return txbc_;
    case 0xC4:
      return (kFifo - level_) | get_ << 8 | put_ << 16 | (level_ == kFifo ? bit(21) : 0);
    case 0xC8:
      return pending_;
    case 0xD4:
      return done_;
    case 0x100:
      return ckdiv_;
    default:
      rules_.broken("FDCAN: read of " + hex(offset));
      return 0;
  }
}

void CanController::write(std::uint32_t offset, std::uint32_t value) {
  const auto protect = [&](std::uint32_t& place) {
    rules_.require(configurable(), "FDCAN: " + hex(offset) + " written without INIT and CCE");
    if (configurable()) {
      place = value;
    }
  };
  switch (offset) {
    case 0x18:
      return write_cccr(value);
    case 0x1C:
      return protect(nbtp_);
    case 0x50:
      ir_ &= ~value;
      rx_lost_ = rx_lost_ && (value & kRxLost) == 0;
      return;
    case 0x80:
      return protect(rxgfc_);
    case 0x94:
      rules_.require(rx_level_ != 0 && value == rx_get_,
                     "FDCAN: acknowledges element " + std::to_string(value) + ", not the oldest");
      if (rx_level_ != 0) {
        --rx_level_;
        rx_get_ = (rx_get_ + 1) % kFifo;
      }
      return;
    case 0xC0:
      return protect(txbc_);
    case 0xCC:
      return request(value);
    case 0x100:
      return protect(ckdiv_);
    default:
      rules_.broken("FDCAN: write of " + hex(offset));
  }
}

/// RM0440 44.3.2 and 44.4.6.
void CanController::write_cccr(std::uint32_t value) {
  rules_.require((value & ~3u) == 0, "FDCAN: CCCR with " + hex(value));
  const bool was_init = init();
  if ((value & 2) != 0 && (cccr_ & 2) == 0) {
    rules_.require(was_init && agenda_.now() >= init_seen_at_,
                   "FDCAN: CCE set before INIT reads one");
  }
  if ((value & 1) == 0) {
    cccr_ = 0;
    if (was_init) {
      rules_.require(clocks_.can_from_bus(), "FDCAN: its kernel clock is not the bus");
      joined_ = false;
      // 11 recessive bits; after bus-off 129 times as many.
      const std::uint32_t bits = bus_off_ ? 129 * 11 : 11;
      agenda_.in(bits * kMicrosecond, [this, life = life_] {
        if (life == life_) {
          join();
        }
      });
    }
    return;
  }
  if (!was_init) {
    init_seen_at_ = agenda_.now();
    joined_ = false;
  }
  cccr_ = was_init ? value & 3 : 1;
}

void CanController::join() {
  if (init()) {
    return;
  }
  if (bus_ == Bus::shorted) {
    agenda_.in(kMillisecond, [this, life = life_] {
      if (life == life_) {
        join();
      }
    });
    return;
  }
  joined_ = true;
  if (bus_off_) {
    bus_off_ = false;
    transmit_errors_ = receive_errors_ = 0;
  }
  look();
}

void CanController::write_ram(std::uint32_t offset, std::uint32_t value) {
  const std::uint32_t word = offset / 4;
  if (word >= kWords) {
    rules_.broken("FDCAN: message RAM written at " + hex(offset));
    return;
  }
  if (word >= kTxBuffers) {
    const std::uint32_t index = (word - kTxBuffers) / kElementWords;
    rules_.require((pending_ >> index & 1) == 0,
                   "FDCAN: a buffer changed while it waits to be sent");
  } else if (word < kRxFifo0) {
    rules_.require(init(), "FDCAN: a filter changed on the bus");
  }
  ram_[word] = value;
}

void CanController::request(std::uint32_t mask) {
  rules_.require((cccr_ & 2) == 0, "FDCAN: a request while CCE is set");
  for (std::uint32_t index = 0; index < kFifo; ++index) {
    if ((mask >> index & 1) == 0) {
      continue;
    }
    rules_.require(index == put_ && level_ < kFifo,
                   "FDCAN: a request for another buffer than the next");
    if (index == put_ && level_ < kFifo) {
      pending_ |= bit(index);
      done_ &= ~bit(index);
      put_ = (put_ + 1) % kFifo;
      ++level_;
    }
  }
  look();
}

std::optional<hal::CanFrame> CanController::first_request() {
  if (level_ == 0 || !on_bus()) {
    return std::nullopt;
  }
  const std::uint32_t* element = &ram_[kTxBuffers + get_ * kElementWords];
  rules_.require((element[1] & (bit(20) | bit(21))) == 0,
                 "FDCAN: a frame of CAN FD on a classic bus");
  hal::CanFrame frame;
  frame.extended = (element[0] & bit(30)) != 0;
  frame.id = frame.extended ? element[0] & 0x1FFFFFFF : field(element[0], 28, 18);
  frame.length = static_cast<std::uint8_t>(std::min(field(element[1], 19, 16), 8u));
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::byte>(element[2 + i / 4] >> (8 * (i % 4)));
  }
  return frame;
}

void CanController::look() {
  if (busy_) {
    return;
  }
  const std::optional<hal::CanFrame> own = first_request();
  const bool tester_sends = !tester_.empty() && bus_ == Bus::sound;
  if (!own && !tester_sends) {
    return;
  }
  busy_ = true;
  const bool own_wins = own && (!tester_sends || rank(*own) < rank(tester_.front()));
  if (!own_wins) {
    agenda_.in(bits_on_wire(tester_.front()) * kMicrosecond, [this] {
      busy_ = false;
      const hal::CanFrame frame = tester_.front();
      tester_.pop_front();
      take(frame);
      look();
    });
    return;
  }
  const Ticks bit_span = bit_time();
  // Nobody understands another bit rate.
  const bool fits = bit_span * 200 >= kMicrosecond * 199 && bit_span * 200 <= kMicrosecond * 201;
  const bool good = bus_ == Bus::sound && fits && transceiver_on();
  constexpr std::uint32_t kUntilErrorIsOver = 20 + 14;
  const std::uint32_t bits = good ? bits_on_wire(*own) : kUntilErrorIsOver;
  agenda_.in(bits * kMicrosecond, [this, life = life_, good, frame = *own] {
    busy_ = false;
    if (life == life_ && on_bus()) {
      good ? sent(frame) : failed();
    }
    look();
  });
}

void CanController::sent(const hal::CanFrame& frame) {
  pending_ &= ~bit(get_);
  done_ |= bit(get_);
  get_ = (get_ + 1) % kFifo;
  --level_;
  transmit_errors_ -= transmit_errors_ != 0 ? 1 : 0;
  heard.push_back({agenda_.now(), frame});
  on_heard(heard.back());
}

/// RM0440 44.3.2, ISO 11898-1 fault confinement.
void CanController::failed() {
  if (bus_ == Bus::nobody_else && transmit_errors_ >= 128) {
    return;
  }
  transmit_errors_ += 8;
  if (transmit_errors_ > 255) {
    bus_off_ = true;
    joined_ = false;
    cccr_ |= 1;
    ir_ |= kBusOffSeen;
  }
}

/// RM0440 44.3.5, 44.3.9, 44.3.10: classic filters into FIFO 0.
bool CanController::accepts(const hal::CanFrame& frame) {
  const std::uint32_t count = frame.extended ? field(rxgfc_, 27, 24) : field(rxgfc_, 20, 16);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t* element =
        frame.extended ? &ram_[kExtendedFilters + 2 * i] : &ram_[kStandardFilters + i];
    const std::uint32_t id = frame.extended ? element[0] & 0x1FFFFFFF : field(element[0], 26, 16);
    const std::uint32_t mask = frame.extended ? element[1] & 0x1FFFFFFF : field(element[0], 10, 0);
    const std::uint32_t type = frame.extended ? element[1] >> 30 : element[0] >> 30;
    const std::uint32_t action = frame.extended ? element[0] >> 29 : field(element[0], 29, 27);
    rules_.require(type == 2 && action <= 1, "FDCAN: a filter that is not modelled");
    if (action == 1 && (frame.id & mask) == (id & mask)) {
      return true;
    }
  }
  const std::uint32_t others = frame.extended ? field(rxgfc_, 3, 2) : field(rxgfc_, 5, 4);
  return others == 0;
}

void CanController::take(const hal::CanFrame& frame) {
  if (!on_bus() || !transceiver_on()) {
    return;
  }
  receive_errors_ -= receive_errors_ != 0 ? 1 : 0;
  if (!accepts(frame)) {
    return;
  }
  if (rx_level_ == kFifo) {
    rx_lost_ = true;
    ir_ |= kRxLost;
    return;
  }
  std::uint32_t* element = &ram_[kRxFifo0 + rx_put_ * kElementWords];
  element[0] = frame.extended ? bit(30) | frame.id : frame.id << 18;
  element[1] = std::uint32_t{frame.length} << 16;
  for (std::size_t word = 0; word < 2; ++word) {
    element[2 + word] = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      element[2 + word] |= std::to_integer<std::uint32_t>(frame.data[4 * word + i]) << (8 * i);
    }
  }
  rx_put_ = (rx_put_ + 1) % kFifo;
  ++rx_level_;
  ir_ |= 1;
}

}  // namespace virtual_g431
