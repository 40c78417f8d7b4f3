#include "firmware/boards/linux/surroundings.hpp"

#include <utility>
#include <variant>

#include "lifemodel/pack/samples.hpp"

namespace boards::linux_controller {
namespace {

using hal::linux_os::CanFilter;

bool is_slow(Covariate covariate) {
  return covariate == Covariate::sheath_temperature || covariate == Covariate::winding_temperature;
}

double& member_of(lifemodel::pack::Surroundings& at, Covariate covariate) {
  switch (covariate) {
    case Covariate::tendon_velocity:
      return at.tendon_velocity_m_s;
    case Covariate::motor_angle:
      return at.motor_angle_rad;
    case Covariate::sheath_temperature:
      return at.sheath_temperature_C;
    case Covariate::winding_temperature:
      break;
  }
  return at.winding_temperature_C;
}

}  // namespace

std::optional<double> value_in(const BusQuantity& quantity, const hal::CanFrame& frame) {
  if (frame.id != quantity.id || frame.extended != quantity.extended ||
      quantity.start_bit + quantity.bits > 8u * frame.length) {
    return std::nullopt;
  }
  std::uint64_t payload = 0;
  for (std::size_t i = frame.length; i-- > 0;) {
    payload = payload << 8 | std::to_integer<std::uint64_t>(frame.data[i]);
  }
  const unsigned above = 64 - quantity.bits;
  const std::uint64_t highest = payload >> quantity.start_bit << above;
  const double raw = quantity.is_signed
                         ? static_cast<double>(static_cast<std::int64_t>(highest) >> above)
                         : static_cast<double>(highest >> above);
  return raw * quantity.factor + quantity.zero;
}

Surroundings::Surroundings(const Config& config, const std::filesystem::path& sysfs) {
  for (const TendonConfig& tendon : config.tendons) {
    std::vector<Quantity>& quantities = tendons_.emplace_back();
    for (std::size_t i = 0; i < kCovariates; ++i) {
      if (!tendon.covariates[i]) {
        continue;
      }
      Quantity quantity{static_cast<Covariate>(i), {}, {}, {}};
      if (const auto* const bus = std::get_if<BusQuantity>(&*tendon.covariates[i])) {
        quantity.bus = *bus;
        quantity.held = std::make_unique<HeldValue>(hal::milliseconds(bus->timeout_ms));
      } else {
        const auto& iio = std::get<IioQuantity>(*tendon.covariates[i]);
        quantity.channel.emplace(hal::linux_os::find_iio_device(sysfs, iio.device),
                                 hal::linux_os::IioChannelSpec{iio.channel, iio.per_unit});
        if (is_slow(quantity.covariate)) {
          quantity.held = std::make_unique<HeldValue>(kSlowLongest);
        }
      }
      quantities.push_back(std::move(quantity));
    }
  }
}

hal::Result<double> Surroundings::Quantity::isr_value(hal::Time now) const {
  if (held) {
    return held->isr_get(now);
  }
  const auto raw = channel->isr_raw();
  return raw ? hal::Result<double>(channel->scale().value(*raw)) : raw.error();
}

hal::Result<lifemodel::extension::Covariates> Surroundings::isr_read(std::size_t tendon,
                                                                     hal::Time now) {
  lifemodel::pack::Surroundings at;
  for (const Quantity& quantity : tendons_.at(tendon)) {
    const auto value = quantity.isr_value(now);
    if (!value) {
      return value.error();
    }
    member_of(at, quantity.covariate) = *value;
  }
  lifemodel::Flags flags;
  const auto covariates = lifemodel::pack::covariates(at, flags);
  return flags.none() ? hal::Result<lifemodel::extension::Covariates>(covariates)
                      : hal::Error::out_of_range;
}

void Surroundings::poll(hal::Time now) {
  if (now < next_slow_) {
    return;
  }
  next_slow_ = now + kSlowPeriod;
  for (const auto& quantities : tendons_) {
    for (const Quantity& quantity : quantities) {
      if (quantity.channel && quantity.held) {
        if (const auto raw = quantity.channel->isr_raw()) {
          quantity.held->put(quantity.channel->scale().value(*raw), now);
        }
      }
    }
  }
}

void Surroundings::take(const hal::CanFrame& frame, hal::Time now) {
  for (const auto& quantities : tendons_) {
    for (const Quantity& quantity : quantities) {
      const auto value = quantity.bus ? value_in(*quantity.bus, frame) : std::nullopt;
      if (value) {
        quantity.held->put(*value, now);
      }
    }
  }
}

std::vector<CanFilter> filters_of(const Config& config) {
  std::vector<CanFilter> filters;
  for (const TendonConfig& tendon : config.tendons) {
    for (const auto& covariate : tendon.covariates) {
      if (const auto* const bus = covariate ? std::get_if<BusQuantity>(&*covariate) : nullptr) {
        filters.push_back({bus->id, bus->extended ? CAN_EFF_MASK : CAN_SFF_MASK, bus->extended});
      }
    }
  }
  return filters;
}

lifemodel::extension::Measured measured_by(const TendonConfig& tendon) {
  const auto has = [&](Covariate covariate) {
    return tendon.covariates[static_cast<std::size_t>(covariate)].has_value();
  };
  return {has(Covariate::tendon_velocity), has(Covariate::motor_angle),
          has(Covariate::sheath_temperature), has(Covariate::winding_temperature)};
}

}  // namespace boards::linux_controller
