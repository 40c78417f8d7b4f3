#include <limits>

#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/replicates.hpp"
#include "host_sim/statistics/same_shape_samples.hpp"
#include "host_sim/statistics/shape_equation.hpp"

namespace host_sim::statistics {

double unbiased_shape(std::span<const Sample> samples, const CommonShapeFit& fit,
                      const BootstrapOptions& options) {
  const SameShapeSamples truth(samples, fit);
  std::vector<double> shapes(options.replicates);
  for_each_replicate(options, [&] {
    return [&, drawn = SameShapeSamples::Memory()](Random& random, std::size_t i) mutable {
      const auto logs = truth.draw(random, drawn);
      shapes[i] = shape_problem(logs) == FitProblem::none ? solve_shape(logs) : 0;
    };
  });
  double sum = 0;
  double fitted = 0;
  for (const double shape : shapes) {
    sum += shape;
    fitted += shape > 0 ? 1 : 0;
  }
  const double mean_ratio = sum / (fitted * fit.shape);
  return fitted == 0 ? std::numeric_limits<double>::quiet_NaN() : fit.shape / mean_ratio;
}

}  // namespace host_sim::statistics
