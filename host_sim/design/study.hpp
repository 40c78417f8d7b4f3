#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/design/design.hpp"
#include "host_sim/reference/life.hpp"

namespace host_sim::design {

/// What one input does to the life, all others kept.
struct Elasticity {
  std::string input;
  double value;            ///< d ln(life) / d ln(input): percent of life per percent
  double life_tenth_less;  ///< times the life with 10 % less of it
  double life_tenth_more;  ///< the same with 10 % more; 0 where that tears the wire at once
};

/// How far a design is from where it fails: factors of the life and of all of its tension at once.
struct Margin {
  double life;
  double tension;
};

struct Safety {
  double strength;  ///< ultimate tension over the highest input tension
  Margin at_risk;   ///< until the wanted life has the wanted risk; 1 where it was solved for
  Margin at_half;   ///< until half of the wires do not reach the wanted life
};

/// A shorter test of the same failure, section 3.1: life = factor * life in the test.
struct AcceleratedTest {
  Tendon tendon;
  double factor;
  double life_cycles;  ///< at the risk of the design
};

/// Life over output tension at one bend angle, up to the tension that tears the wire at once.
struct Curve {
  double bend_angle_deg;
  std::vector<double> output_max_N;
  std::vector<double> life_cycles;
};

/// What the life is with the confidence that the model gives for its law.
struct LifeInterval {
  double level;
  double low_cycles;
  double high_cycles;
};

/// A design and what there is to say of it.
struct Study {
  Design design;
  Stress stress;
  double life_cycles;  ///< at the risk of the design; of safety not the life that is wanted
  std::optional<LifeInterval> interval;  ///< of that life; none where the model has none
  reference::LifePoints lives_cycles;
  Safety safety;
  std::vector<Elasticity> elasticities;  ///< largest first; none where the life has no end
  std::optional<AcceleratedTest> test;
  std::vector<Curve> curves;  ///< by rising bend angle, that of the design among them
};

/// Of a test at another tension, in the same ratio of lowest to highest, or another bend angle.
struct TestRequest {
  std::optional<double> output_max_N;
  std::optional<double> bend_angle_deg;
};

/// @throws InputError where the test would tear the wire at once
[[nodiscard]] Study study(const Model& model, const Design& design, const TestRequest& test);

/// How the result is told.
struct Telling {
  std::string model_digest;
  std::optional<double> cycles_per_minute;  ///< for lives in hours
};

[[nodiscard]] std::string design_json(const Study& study, const Telling& telling);

/// CSV: a row for the design and one for each point of the curves.
[[nodiscard]] std::string design_table(const Model& model, const Study& study);

/// For people.
void write_design(std::ostream& out, const Study& study, const Telling& telling);

/// The wanted or found life and what it is for, in one sentence.
[[nodiscard]] std::string sentence_of(const Study& study);

}  // namespace host_sim::design
