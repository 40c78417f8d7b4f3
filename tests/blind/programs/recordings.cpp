#include "tests/blind/programs/suite.hpp"
#include "tests/blind/running/analyses.hpp"

int main(int argc, char** argv) {
  return blind::suite(argc, argv, blind::draw_recordings, blind::analysis_of_recordings());
}
