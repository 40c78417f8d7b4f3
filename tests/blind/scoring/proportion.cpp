#include "tests/blind/scoring/proportion.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/binomial.hpp>
#include <limits>

namespace blind {
namespace {

using Binomial = boost::math::binomial_distribution<double>;

constexpr double kTail = 0.025;

}  // namespace

double Proportion::value() const {
  return of == 0 ? std::numeric_limits<double>::quiet_NaN()
                 : static_cast<double>(holds) / static_cast<double>(of);
}

double Proportion::lower() const {
  return of == 0 ? 0
                 : Binomial::find_lower_bound_on_p(static_cast<double>(of),
                                                   static_cast<double>(holds), kTail);
}

double Proportion::upper() const {
  return of == 0 || holds == of ? 1
                                : Binomial::find_upper_bound_on_p(
                                      static_cast<double>(of), static_cast<double>(holds), kTail);
}

std::size_t Proportion::least_of(std::size_t some) const {
  constexpr double kFewer = 0.1;
  const Binomial draws(static_cast<double>(some), value());
  std::size_t least = 0;
  while (least < some && boost::math::cdf(draws, static_cast<double>(least)) <= kFewer) {
    ++least;
  }
  return least;
}

std::string text_of(const Proportion& proportion) {
  return proportion.of == 0
             ? "-"
             : fmt::format("{:.1f} % ({:.1f} .. {:.1f}, {} of {})", 100 * proportion.value(),
                           100 * proportion.lower(), 100 * proportion.upper(), proportion.holds,
                           proportion.of);
}

}  // namespace blind
