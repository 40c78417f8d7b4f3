#include "host_sim/replay/replay.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/fixed.hpp"
#include "host_sim/extension/life.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/replay/plots.hpp"
#include "host_sim/replay/profile_input.hpp"
#include "host_sim/replay/until_date.hpp"
#include "host_sim/report/replay/flags.hpp"
#include "host_sim/report/replay/report_data.hpp"
#include "lifemodel/block/parameter_block.hpp"
#include "lifemodel/bulk/replay.hpp"
#include "lifemodel/estimator.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/pack/pack.hpp"
#include "lifemodel/tendon.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::InputKind;
using hal::files::ProfileReader;
using hal::files::ProfileRow;

namespace {

using lifemodel::Reading;
using lifemodel::Tension;
using lifemodel::pack::to_double;

/// A CSV file of readings over time: the life used, as the firmware would report it.
class TrajectoryFile {
 public:
  /// Writes the header. `ultimate_tension_N` turns tensions back into newtons.
  TrajectoryFile(std::ostream& out, double ultimate_tension_N);

  void write(double time_s, lifemodel::Tension tension, const lifemodel::Reading& reading);

 private:
  std::ostream& out_;
  double ultimate_tension_N_;
};

TrajectoryFile::TrajectoryFile(std::ostream& out, double ultimate_tension_N)
    : out_(out), ultimate_tension_N_(ultimate_tension_N) {
  out_ << "time_s,input_tension_N,damage_closed,damage_open,damage_total,closed_cycles,"
          "open_half_cycles\n";
}

void TrajectoryFile::write(double time_s, lifemodel::Tension tension,
                           const lifemodel::Reading& reading) {
  using lifemodel::pack::to_double;
  fmt::print(out_, "{},{:.6f},{},{},{},{},{}\n", time_s, to_double(tension) * ultimate_tension_N_,
             to_double(reading.closed), to_double(reading.open), to_double(reading.total),
             reading.closed_cycles.raw(), reading.open_half_cycles.raw());
}

Model with(Model model, const std::vector<Extension>& extensions) {
  model.extensions = extensions;
  return model;
}

/// Narrowest classes of cycles in the ultimate tension.
constexpr double kClasses = 1024;

/// One pass of a profile.
class Pass {
 public:
  Pass(const ProfileReader& profile, const Model& model, const std::string& model_name,
       const ReplayOptions& options)
      : model_(model),
        options_(options),
        acting_(acting_extensions(model, profile.kind(), profile.channels())),
        acting_model_(with(model, acting_.extensions)),
        parameters_{parameters_of(model, model_name),
                    fixed_extension(acting_model_, acting_.extensions, model_name)},
        estimator_(
            {lifemodel::extension::life_parameters(parameters_.nominal, parameters_.extension)}),
        exact_(reference_constants_of(model), extended_effective_tension(acting_model_)),
        input_(profile, acting_model_, parameters_, options.start_cycle),
        wire_(model, parameters_.nominal, input_.has_motion()),
        clock_(1 / model.counting.sample_rate_Hz),
        has_output_(profile.kind() == InputKind::kOutputTension) {
    if (options.report != nullptr) {
      plots_.emplace(
          model, parameters_.nominal,
          options.class_N > 0 ? options.class_N : model.cable.ultimate_tension_N / kClasses);
    }
    if (options.trajectory != nullptr) {
      trajectory_.emplace(*options.trajectory, model.cable.ultimate_tension_N);
    }
    if (options.can) {
      board_.emplace(profile.kind(), parameters_, options.start_cycle, options.node,
                     [this](hal::Time time, const hal::CanFrame& frame) {
                       ++can_frames_;
                       options_.can(time, frame);
                     });
    }
  }
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  void take(std::span<const ProfileRow> rows) {
    tensions_N_.clear();
    for (const ProfileRow& row : rows) {
      take_row(row);
    }
    for (const double tension_N : tensions_N_) {
      exact_.push(tension_N);
    }
  }

  ReplayResult finish(const ProfileReader& profile) {
    report(true);
    count_waiting();
    const Reading reading = estimator_.reading(0, cycles_to_plots());
    const reference::Reading exact = exact_.reading();

    ReplayResult result;
    result.input = profile.kind();
    std::ranges::transform(profile.nearly(), std::back_inserter(result.warnings),
                           &hal::files::NearlyColumn::words);
    result.samples = clock_.samples();
    result.duration_s = clock_.duration_s();
    result.cycles = {reading.closed_cycles.raw(), reading.open_half_cycles.raw()};
    result.damage = {to_double(reading.closed), to_double(reading.open), to_double(reading.total)};
    result.reference_damage = {exact.damage.closed, exact.damage.open, exact.damage.total};
    result.relative_error = result.damage.total == exact.damage.total
                                ? 0
                                : result.damage.total / exact.damage.total - 1;
    const reference::Reading ours{
        .damage = {result.damage.closed, result.damage.open, result.damage.total},
        .closed_cycles = result.cycles.closed,
        .open_half_cycles = result.cycles.open_half,
        .peak_tension_N = exact.peak_tension_N,
        .overload_cycles = exact.overload_cycles,
        .overload_half_cycles = exact.overload_half_cycles};
    result.equivalent_effective_tension_N =
        reference::equivalent_effective_tension(ours, reference_constants_of(model_));
    result.survival_probability =
        reference::weibull_survival(result.damage.total, model_.life.weibull_shape);
    result.repeats_to = reference::repeats_to(result.damage.total, model_.life.weibull_shape);
    if (options_.survivor) {
      result.given_survival =
          given_survival(*options_.survivor, result.damage.total, result.duration_s,
                         result.equivalent_effective_tension_N, model_.life);
    }
    result.flags = flag_names(reading.flags);
    result.overloads = reading.overloads.raw();
    result.gaps = clock_.gaps();
    result.missing_samples = reading.missing_samples.raw();
    result.peak_tension_N = exact.peak_tension_N;
    result.watched = wire_.result();
    if (options_.until) {
      result.until_date =
          until_date(*options_.until, options_.survivor ? options_.survivor->used : 0, reading,
                     lifemodel::pack::from_double<Tension>(result.watched.peak_ratio),
                     result.duration_s, parameters_.nominal, model_.cable.ultimate_tension_N,
                     result.watched.limits.minimum_tension_N);
    }
    result.seen_life = result.watched.broken ? seen_life_ : seen_life(reading, false);
    add_findings(result);
    result.model_digest = model_digest(model_);
    result.not_evaluated = acting_.others;
    for (const Extension& extension : acting_.extensions) {
      result.extensions.push_back(extension.id);
    }
    if (clock_.other_rate()) {
      result.warnings.push_back(fmt::format(
          "the profile was recorded at about {:.4g} Hz, the model says {:.4g} Hz; every interval "
          "counts as a gap",
          clock_.rate_Hz(), model_.counting.sample_rate_Hz));
    }
    if (plots_) {
      plots_->finish(*options_.report);
      if (clock_.other_rate()) {
        options_.report->tension.gaps.clear();
      }
    }
    if (board_) {
      finish_board(reading.total);
      result.can_frames = can_frames_;
    }
    return result;
  }

 private:
  using Layout = lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>;

  void take_row(const ProfileRow& row) {
    const std::uint32_t missing = clock_.missing_before(row.time_s);
    if (missing != 0) {
      estimator_.push_missing(0, missing);
      input_.gap();
      wire_.miss(missing);
      if (plots_) {
        plots_->gap();
      }
    }
    input_.take(row, estimator_.input_flags(0));
    waiting_.push_back(input_.tension());
    if (waiting_.size() == lifemodel::bulk::Reducer::kMostSamples) {
      count_waiting();
    }
    wire_.take(row.time_s, row.line, input_.tension(), input_.velocity());
    if (wire_.just_broken()) {
      count_waiting();
      seen_life_ =
          seen_life(estimator_.reading(0, cycles_to_plots(), lifemodel::NoObserver{}), true);
    }
    tensions_N_.push_back(input_.tension_N());
    if (board_) {
      board_->take(since_start(clock_.duration_s()), missing, input_.sample(),
                   input_.sample_flags());
    }
    if (plots_) {
      plots_->sample(row.time_s, input_.tension());
      if (has_output_) {
        plots_->loop(row.time_s, input_.tension_N(), row.value);
      }
    }
    time_s_ = row.time_s;
    report(row.time_s >= next_report_s_);
  }

  /// In bulk, unless somebody hears of the cycles: one by one, in their order.
  void count_waiting() {
    if (plots_) {
      estimator_.replay(0, waiting_, cycles_to_plots());
    } else {
      bulk_.take(estimator_, 0, waiting_);
    }
    waiting_.clear();
  }

  /// By the damage of the estimator; overloads, which are whole lives, have no tension of their
  /// own.
  [[nodiscard]] std::optional<SeenLife> seen_life(const Reading& reading, bool failed) const {
    const double cycles = static_cast<double>(reading.closed_cycles.raw()) +
                          static_cast<double>(reading.open_half_cycles.raw()) / 2;
    const reference::Reading counted{
        .damage = {to_double(reading.closed), to_double(reading.open), to_double(reading.total)},
        .closed_cycles = reading.closed_cycles.raw(),
        .open_half_cycles = reading.open_half_cycles.raw(),
        .peak_tension_N = 0,
        .overload_cycles = 0,
        .overload_half_cycles = 0};
    if (cycles == 0) {
      return std::nullopt;
    }
    return SeenLife{
        cycles, reference::equivalent_effective_tension(counted, reference_constants_of(model_)),
        failed};
  }

  static void add_findings(ReplayResult& result) {
    const Model::Watch& limits = result.watched.limits;
    for (const FoundInWire& found : result.watched.found) {
      if (found.event == WireEvent::broken) {
        result.warnings.push_back(fmt::format(
            "the wire is broken, found at {:.6g} s, line {}: pulled over {:.4g} mm at "
            "no more than {:.4g} N",
            found.time_s, found.line, limits.broken_travel_mm, limits.broken_tension_N));
      }
    }
    if (result.watched.slack_events > 0) {
      const FoundInWire& first = result.watched.found.front();
      result.warnings.push_back(fmt::format(
          "the wire hangs loose {} times, first found at {:.6g} s, line {}: moved over {:.4g} mm "
          "below {:.4g} N",
          result.watched.slack_events, first.time_s, first.line, limits.slack_travel_mm,
          limits.minimum_tension_N));
    }
  }

  static hal::Time since_start(double time_s) {
    return hal::microseconds(static_cast<std::uint64_t>(std::llround(time_s * 1e6)));
  }

  /// Both took the same samples through the same estimator.
  void finish_board(const lifemodel::Damage& damage) {
    if (board_->finish() != damage) {
      throw std::logic_error("the firmware has counted another damage than the replay");
    }
  }

  [[nodiscard]] CyclesToPlots cycles_to_plots() { return {plots_ ? &*plots_ : nullptr}; }

  /// Reads and reports the trajectory, unless the last sample has been reported.
  void report(bool wanted) {
    if (!wanted || time_s_ == reported_s_ || (!trajectory_ && !plots_)) {
      return;
    }
    count_waiting();
    const Reading now = estimator_.reading(0);
    if (trajectory_) {
      trajectory_->write(time_s_, input_.tension(), now);
    }
    if (plots_) {
      plots_->damage(time_s_, to_double(now.total));
    }
    reported_s_ = time_s_;
    next_report_s_ = time_s_ + options_.trajectory_step_s;
  }

  const Model& model_;
  const ReplayOptions& options_;
  Acting acting_;
  Model acting_model_;
  lifemodel::ExtendedParameters parameters_;
  lifemodel::Estimator<1, Layout> estimator_;
  lifemodel::bulk::Replay bulk_;
  std::vector<Tension> waiting_;  ///< that the estimator has not counted yet
  reference::Reference exact_;
  std::vector<double> tensions_N_;  ///< of a batch of rows, exactly
  ProfileInput input_;
  WireFollower wire_;
  SampleClock clock_;
  bool has_output_;
  std::optional<SeenLife> seen_life_;
  std::optional<Plots> plots_;
  std::optional<TrajectoryFile> trajectory_;
  std::optional<VirtualBoard> board_;
  std::uint64_t can_frames_ = 0;
  double time_s_ = 0;
  double reported_s_ = std::numeric_limits<double>::quiet_NaN();
  double next_report_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

ReplayResult replay(ProfileReader& profile, const Model& model, const std::string& model_name,
                    const ReplayOptions& options) {
  if (profile.kind() == InputKind::kMotorCurrent && !model.drive) {
    throw InputError(model_name, 0, 0, "no [drive], and the profile holds motor_current_A",
                     "a [drive] table, or a profile with input_tension_N or output_tension_N");
  }
  Pass pass(profile, model, model_name, options);
  for (auto rows = profile.read_block(); !rows.empty(); rows = profile.read_block()) {
    pass.take(rows);
    if (options.progress) {
      options.progress(profile.bytes_read());
    }
  }
  return pass.finish(profile);
}

}  // namespace host_sim
