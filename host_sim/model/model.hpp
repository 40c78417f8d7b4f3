#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/reference/equations.hpp"

namespace host_sim {

/// One effect of the catalogue added to a nominal model, the table [extension.<id>] of its file.
struct Extension {
  struct Value {
    std::string name;            ///< as effects::Parameter::name, with its unit as suffix
    std::vector<double> values;  ///< one; or of bend_angle one for each of `bend_angles_deg`
  };
  std::string id;  ///< of effects::TensionEffect or effects::LifeEffect
  std::vector<Value> values;
};

/// The life model of one tendon, as `model.toml` gives it. Ranges: model_keys().
struct Model {
  struct Cable {
    double diameter_mm;
    double ultimate_tension_N;  ///< T_u of eq. (11)
  };
  struct Sheath {
    double friction_coefficient;  ///< mu of eq. (14)
    double bend_angle_deg;        ///< phi of eq. (14)
  };
  struct Drive {
    double torque_constant_Nm_per_A;
    double gear_ratio;
    double gear_efficiency;
    double spool_radius_mm;
    double current_offset_A;

    [[nodiscard]] double spool_radius_m() const { return spool_radius_mm * 1e-3; }
    /// The same in the units of the equations.
    [[nodiscard]] reference::Drive reference() const {
      return {torque_constant_Nm_per_A, gear_ratio, gear_efficiency, spool_radius_m(),
              current_offset_A};
    }
  };
  struct Counting {
    double sample_rate_Hz;
    double hysteresis_N;
  };
  enum class MeanStress { kGerber };
  struct Life {
    /// How sure the fit is of the law: confidence intervals that hold the truth with probability
    /// `level`, each on its own. Scale and exponent lean on each other, the characteristic life at
    /// the pivot and the exponent do not (to first order): so the variance of ln alpha(T) is that
    /// of ln alpha at the pivot, plus (ln T - ln pivot)^2 times that of the exponent.
    struct Interval {
      struct Ends {
        double low;
        double high;
      };
      double level;  ///< above 0, below 1
      Ends ipl_scale;
      Ends ipl_exponent;
      Ends weibull_shape;
      double pivot_tension_N;  ///< effective tension
      Ends life_at_pivot;      ///< characteristic life in cycles
    };

    MeanStress mean_stress;
    double ipl_scale;      ///< A of eq. (19)
    double ipl_exponent;   ///< gamma of eq. (19)
    double weibull_shape;  ///< beta of eq. (20)
    /// [life.interval]; none where nobody has said how sure the numbers are.
    std::optional<Interval> interval = std::nullopt;
  };

  /// What a controller watches beside the damage, and what it advises; 0 is off. See read_watch().
  struct Watch {
    double minimum_tension_N = 0;  ///< input tension below which the wire counts as slack
    double broken_tension_N = 0;   ///< the most that friction alone makes, of a wire that broke
    double broken_travel_mm = 0;   ///< of the tendon at no more than that, after which it is broken
    double slack_travel_mm = 0;    ///< the same below the minimum, after which it is slack
    double horizon_h = 8;          ///< of operation, of the probability of a break
    double advice_risk = 0;        ///< of a break that is accepted
    double advice_until_h = 0;     ///< of operation that the wire shall last at that risk

    friend bool operator==(const Watch&, const Watch&) = default;
  };

  Cable cable;
  Sheath sheath;
  std::optional<Drive> drive;
  Counting counting;
  Life life;
  std::vector<Extension> extensions = {};  ///< by id, each once; see read_extended_model()
  std::optional<Watch> watch = {};
};

/// What is known of a model: tables that nobody needs may be missing.
struct NominalModel {
  std::optional<Model::Cable> cable;
  std::optional<Model::Sheath> sheath;
  std::optional<Model::Drive> drive;
  std::optional<Model::Counting> counting;
  std::optional<Model::Life> life;
  std::optional<Model::Watch> watch = {};
};

/// Reads and checks `model.toml`. Throws InputError with the position of the offending key for
/// anything unknown, missing, of the wrong type or out of range. Refuses extensions: whoever
/// evaluates them calls read_extended_model().
Model read_model(const std::filesystem::path& path);

/// The same for a text in memory; `name` stands for the file in errors.
Model parse_model(std::string_view text, std::string_view name);

/// Eight hexadecimal digits that identify the values of a model whatever the formatting of its
/// file: the CRC-32 (ISO-HDLC) of the lines `schema=1`, `table.key=value` for each number in the
/// order of model_keys() with 17 significant digits, `life.mean_stress=gerber`, the lines of
/// [life.interval] as `life.interval.key = value` where there is one, `extension.id.name=value` for
/// each number of each extension, and where there is a table [watch] its seven lines as
/// `watch.key = value`. What is not known of a law does not change the damage that it gives, but a
/// controller gets it in its block and shows it: so two models that differ in it are two. A model
/// without these tables has the digest that it always had.
std::string model_digest(const Model& model);

/// The extension of an effect; null where the model has none.
const Extension* extension_of(std::span<const Extension> extensions, std::string_view id);

/// The numbers of that name; empty where it has none.
std::span<const double> values_of(const Extension& extension, std::string_view name);

/// The number of that name; nothing where it has none.
std::optional<double> value_if(const Extension& extension, std::string_view name);

/// The number of that name. @pre it has one
double value_of(const Extension& extension, std::string_view name);

}  // namespace host_sim
