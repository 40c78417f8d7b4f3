#pragma once

#include "tests/blind/running/run.hpp"

namespace blind {

/// The main function of a program that runs campaigns of one kind of data and scores the answers.
int suite(int argc, char** argv, Scenario (*draw)(std::uint64_t seed), const Analysis& analysis);

}  // namespace blind
