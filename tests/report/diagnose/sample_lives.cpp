#include <fmt/format.h>

#include <cmath>

#include "host_sim/statistics/random.hpp"
#include "tests/report/diagnose/sample_pictures.hpp"

namespace host_sim::samples {

void add_points(diagnose::LifeDiagnosis& lives, double spread) {
  constexpr double kShape = 5.94;
  constexpr double kTensions_N[] = {42.5, 50.8, 60.1, 71.0};
  constexpr int kLots = 3;
  constexpr int kOfLot = 4;
  statistics::Random random(9, 1, 0);
  for (const double tension_N : kTensions_N) {
    for (int lot = 0; lot < kLots; ++lot) {
      for (int i = 0; i < kOfLot; ++i) {
        const double weibull = std::pow(-std::log1p(-random.uniform()), 1 / kShape);
        const double shift = std::exp(spread * (lot - 1));
        lives.picture.points.push_back({fmt::format("w{}", lives.picture.points.size() + 1),
                                        std::string(1, static_cast<char>('A' + lot)), tension_N,
                                        weibull * shift, weibull, true});
      }
    }
  }
  lives.picture.points.front().failed = false;
  lives.picture.shape_before = 3.9;
  lives.picture.shape_after = 5.8;
}

}  // namespace host_sim::samples
