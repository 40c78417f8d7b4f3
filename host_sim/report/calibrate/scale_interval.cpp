#include "host_sim/report/calibrate/scale_interval.hpp"

#include <cmath>

namespace host_sim::calibrate_page {
namespace {

/// Where a share stands on probability paper; 0 at the scale parameter.
double paper_place(double p) {
  return std::log(-std::log1p(-p));
}

}  // namespace

std::optional<statistics::Interval> scale_interval(const statistics::QuantileBand& band) {
  for (std::size_t i = 1; i < band.p.size(); ++i) {
    const double before = paper_place(band.p[i - 1]);
    const double after = paper_place(band.p[i]);
    if (before <= 0 && after >= 0 && before < after) {
      const double share = -before / (after - before);
      const auto between = [share](double from, double to) {
        return from * std::pow(to / from, share);
      };
      return statistics::Interval{between(band.low[i - 1], band.low[i]),
                                  between(band.high[i - 1], band.high[i])};
    }
  }
  return std::nullopt;
}

}  // namespace host_sim::calibrate_page
