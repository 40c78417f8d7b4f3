#pragma once

#include "tests/blind/generator/scenario.hpp"

namespace blind {

/// The error that the true model would leave: RMSE of the output tension of the same campaign with
/// nothing hidden, with gain and friction coefficient fitted by least squares of the logarithm. 0
/// for lives.
double rmse_floor_N(const Scenario& scenario);

/// Share of the true model's gain that an analysis reached: how far it brought an error down, over
/// how far the floor lies below it. All in one unit.
double relative_gain(double before, double after, double floor);

}  // namespace blind
