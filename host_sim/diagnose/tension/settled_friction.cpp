#include "host_sim/diagnose/tension/settled_friction.hpp"

#include "host_sim/recording/covariates.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kMostFactor = 4;

}  // namespace

double settled_friction(std::span<const Session> sessions, double nominal) {
  double square = 0;
  double product = 0;
  for (const Session& session : sessions) {
    const recording::SettledSums sums(session.covariates);
    square += sums.square;
    product += sums.product;
  }
  const double found = square > 0 ? product / square : nominal;
  const bool likely = found > nominal / kMostFactor && found < nominal * kMostFactor;
  return likely ? found : nominal;
}

}  // namespace host_sim::diagnose
