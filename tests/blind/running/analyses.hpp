#pragma once

#include "tests/blind/running/run.hpp"

namespace blind {

/// The analysis under test, of recordings and of lives.
Analysis analysis_of_recordings();
Analysis analysis_of_lives();

}  // namespace blind
