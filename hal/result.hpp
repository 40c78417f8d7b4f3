#pragma once

#include "hal/error.hpp"
#include "lifemodel/support/result.hpp"

namespace hal {

/// A value, or the Error why there is none.
template <class T>
using Result = lifemodel::Result<T, Error>;

}  // namespace hal
