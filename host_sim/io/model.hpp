#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace host_sim {

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
  };
  struct Counting {
    double sample_rate_Hz;
    double hysteresis_N;
  };
  enum class MeanStress { kGerber };
  struct Life {
    MeanStress mean_stress;
    double ipl_scale;      ///< A of eq. (19)
    double ipl_exponent;   ///< gamma of eq. (19)
    double weibull_shape;  ///< beta of eq. (20)
  };

  Cable cable;
  Sheath sheath;
  std::optional<Drive> drive;
  Counting counting;
  Life life;
};

/// Reads and checks `model.toml`. Throws InputError with the position of the offending key for
/// anything unknown, missing, of the wrong type or out of range.
Model read_model(const std::filesystem::path& path);

/// The same for a text in memory; `name` stands for the file in errors.
Model parse_model(std::string_view text, std::string_view name);

/// Eight hexadecimal digits that identify the values of a model whatever the formatting of its
/// file: the CRC-32 (ISO-HDLC) of the lines `schema=1`, `table.key=value` for each number in the
/// order of model_keys() with 17 significant digits, and `life.mean_stress=gerber`.
std::string model_digest(const Model& model);

}  // namespace host_sim
