#include "host_sim/diagnose/probe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host_sim/effects/tension/columns.hpp"

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kBins = 6;
constexpr std::size_t kSortedSamples = 20'000;

constexpr std::array kAll{Probe::Of::cycle,
                          Probe::Of::bend_angle,
                          Probe::Of::sheath_temperature,
                          Probe::Of::winding_temperature,
                          Probe::Of::speed,
                          Probe::Of::log_tension,
                          Probe::Of::position,
                          Probe::Of::motor_angle,
                          Probe::Of::travel,
                          Probe::Of::log_tension_rate,
                          Probe::Of::elapsed};

template <typename Value>
std::vector<double> mapped(const std::vector<double>& from, Value value) {
  std::vector<double> to;
  to.reserve(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    to.push_back(value(i));
  }
  return to;
}

double within_turn(double angle_rad) {
  const double turn = 2 * std::numbers::pi;
  return angle_rad - turn * std::floor(angle_rad / turn);
}

/// Every n-th value of all sessions, so that no more than kSortedSamples are sorted.
std::vector<double> sorted_sample(std::span<const Session> sessions, Probe::Of of) {
  std::size_t samples = 0;
  for (const Session& session : sessions) {
    samples += session.covariates.samples();
  }
  const std::size_t stride = samples / kSortedSamples + 1;
  std::vector<double> sample;
  for (const Session& session : sessions) {
    const std::vector<double> values = values_of(of, session.covariates);
    if (values.empty()) {
      return {};
    }
    for (std::size_t i = 0; i < values.size(); i += stride) {
      sample.push_back(values[i]);
    }
  }
  std::ranges::sort(sample);
  return sample;
}

/// Edges at the quantiles; where a covariate takes few values, halfway between those.
std::vector<double> edges_of(const std::vector<double>& sorted) {
  std::vector<double> edges;
  for (std::size_t bin = 1; bin < kBins; ++bin) {
    const std::size_t place = bin * sorted.size() / kBins;
    const auto next = std::upper_bound(sorted.begin(), sorted.end(), sorted[place]);
    if (next == sorted.end()) {
      break;
    }
    const double edge = (sorted[place] + *next) / 2;
    if (edges.empty() || edge > edges.back()) {
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace

std::vector<double> values_of(Probe::Of of, const recording::Covariates& c) {
  switch (of) {
    case Probe::Of::cycle:
      return c.cycle;
    case Probe::Of::bend_angle:
      return c.bend_angle_rad;
    case Probe::Of::sheath_temperature:
      return c.sheath_temperature_C;
    case Probe::Of::winding_temperature:
      return c.winding_temperature_C;
    case Probe::Of::speed:
      return mapped(c.velocity_m_s, [&](std::size_t i) { return std::abs(c.velocity_m_s[i]); });
    case Probe::Of::log_tension:
      return mapped(c.output_tension_N, [&](std::size_t i) {
        const double input_share = effects::input_noise_share(c, i);
        return input_share * std::log(c.output_tension_N[i]) +
               (1 - input_share) * std::log(c.tension_in_N()[i]);
      });
    case Probe::Of::position:
      return c.position_m;
    case Probe::Of::motor_angle:
      return mapped(c.motor_angle_rad,
                    [&](std::size_t i) { return within_turn(c.motor_angle_rad[i]); });
    case Probe::Of::travel:
      return c.travel_m;
    case Probe::Of::log_tension_rate:
      return c.log_tension_rate_1_s;
    case Probe::Of::elapsed:
      return mapped(c.time_s, [&](std::size_t i) { return c.time_s[i] - c.time_s.front(); });
  }
  return {};
}

std::string_view name_of(Probe::Of of) {
  switch (of) {
    case Probe::Of::cycle:
      return "cycle number";
    case Probe::Of::bend_angle:
      return "bend angle";
    case Probe::Of::sheath_temperature:
      return "sheath temperature";
    case Probe::Of::winding_temperature:
      return "winding temperature";
    case Probe::Of::speed:
      return "speed";
    case Probe::Of::log_tension:
      return "logarithm of tension";
    case Probe::Of::position:
      return "tendon position";
    case Probe::Of::motor_angle:
      return "rotor angle";
    case Probe::Of::travel:
      return "travel since reversal";
    case Probe::Of::log_tension_rate:
      return "rate of log tension";
    case Probe::Of::elapsed:
      return "time in the recording";
  }
  return "";
}

std::string_view unit_of(Probe::Of of) {
  switch (of) {
    case Probe::Of::cycle:
      return "cycles";
    case Probe::Of::bend_angle:
    case Probe::Of::motor_angle:
      return "rad";
    case Probe::Of::sheath_temperature:
    case Probe::Of::winding_temperature:
      return "C";
    case Probe::Of::speed:
      return "m/s";
    case Probe::Of::log_tension:
      return "ln N";
    case Probe::Of::position:
    case Probe::Of::travel:
      return "m";
    case Probe::Of::log_tension_rate:
      return "1/s";
    case Probe::Of::elapsed:
      return "s";
  }
  return "";
}

std::vector<std::size_t> Probe::column_of(const recording::Covariates& covariates) const {
  std::vector<std::size_t> columns;
  const std::vector<double> values = values_of(of, covariates);
  columns.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto bin =
        static_cast<std::size_t>(std::ranges::upper_bound(edges, values[i]) - edges.begin());
    columns.push_back(covariates.direction[i] > 0 ? bins() + bin : bin);
  }
  return columns;
}

std::vector<Probe> probes_of(std::span<const Session> sessions) {
  std::vector<Probe> probes;
  for (const Probe::Of of : kAll) {
    const std::vector<double> sorted = sorted_sample(sessions, of);
    if (sorted.empty() || sorted.front() == sorted.back()) {
      continue;
    }
    if (std::vector<double> edges = edges_of(sorted); !edges.empty()) {
      probes.push_back({.of = of, .edges = std::move(edges)});
    }
  }
  return probes;
}

}  // namespace host_sim::diagnose
