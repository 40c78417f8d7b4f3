#include "tests/blind/oracle/life_visibility.hpp"
#include "tests/blind/programs/suite.hpp"
#include "tests/blind/running/analyses.hpp"

int main(int argc, char** argv) {
  return blind::suite(argc, argv, blind::draw_visible_lives, blind::analysis_of_lives());
}
