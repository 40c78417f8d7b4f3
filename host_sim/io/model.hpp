#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/extension/extension.hpp"

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
  std::vector<Extension> extensions = {};  ///< by id, each once; see read_extended_model()
};

/// Reads and checks `model.toml`. Throws InputError with the position of the offending key for
/// anything unknown, missing, of the wrong type or out of range. Refuses extensions: whoever
/// evaluates them calls read_extended_model().
Model read_model(const std::filesystem::path& path);

/// The same for a text in memory; `name` stands for the file in errors.
Model parse_model(std::string_view text, std::string_view name);

/// Eight hexadecimal digits that identify the values of a model whatever the formatting of its
/// file: the CRC-32 (ISO-HDLC) of the lines `schema=1`, `table.key=value` for each number in the
/// order of model_keys() with 17 significant digits, `life.mean_stress=gerber`, and
/// `extension.id.name=value` for each number of each extension.
std::string model_digest(const Model& model);

}  // namespace host_sim
