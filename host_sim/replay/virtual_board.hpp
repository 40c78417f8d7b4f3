#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <variant>

#include "firmware/app/intake.hpp"
#include "firmware/protocol/messages.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"
#include "hal/files/profile.hpp"
#include "lifemodel/damage/damage.hpp"
#include "lifemodel/extension/extended_block.hpp"
#include "lifemodel/extension/sample.hpp"
#include "lifemodel/quantity/flags.hpp"
#include "lifemodel/quantity/units.hpp"

namespace host_sim {

/// What the sensor of a board gives for one tendon; the kind follows InputKind and
/// whether the model is extended.
using BoardSample =
    std::variant<app::Moving<lifemodel::Tension>, app::Moving<lifemodel::MotorCurrent>,
                 app::OutputTension, lifemodel::extension::DriveSample,
                 lifemodel::extension::SheathSample>;

/// The firmware for one tendon on a board of fakes: virtual time from 0, blank storage, a bus on
/// which nobody else talks. The same input gives the same frames.
class VirtualBoard {
 public:
  /// Hears of each frame as it leaves.
  using Listener = std::function<void(hal::Time, const hal::CanFrame&)>;

  /// @param start_cycle that the sheath has seen before
  VirtualBoard(hal::files::InputKind kind, const lifemodel::ExtendedParameters& parameters,
               std::uint32_t start_cycle, protocol::Node node, Listener listener);
  VirtualBoard(VirtualBoard&&) noexcept;
  VirtualBoard& operator=(VirtualBoard&&) noexcept;
  ~VirtualBoard();

  /// Lets the time go by until `time`, then runs one period of the control loop with this sample.
  /// @param missing periods that the control loop left out before it
  /// @param flags what became of the sample on its way from the file
  /// @pre times do not fall; the sample is of the kind of the board.
  void take(hal::Time time, std::uint32_t missing, const BoardSample& sample,
            lifemodel::Flags flags);

  /// The control loop has ended. Continues until all that was sampled is reported on the bus, then
  /// stops the firmware. Gives the damage that it has counted.
  lifemodel::Damage finish();

 private:
  class Firmware;
  template <class SampleT, template <class, std::size_t> class SensingT>
  class FirmwareFor;
  std::unique_ptr<Firmware> firmware_;
};

}  // namespace host_sim
