#pragma once

#include <string>
#include <vector>

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

}  // namespace host_sim
