#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "host_sim/diagnose/force/alone.hpp"
#include "host_sim/diagnose/force/doubts.hpp"
#include "host_sim/diagnose/force/structure.hpp"

namespace host_sim::diagnose {
namespace {

using hal::files::ProfileColumnId;

/// Whether a value is unlike all others, by their median and that of how far they are from it.
class Robust {
 public:
  explicit Robust(const std::vector<double>& values) : middle_(median_of(values)) {
    constexpr double kSdOfMedian = 1.4826;
    std::vector<double> off;
    off.reserve(values.size());
    for (const double value : values) {
      off.push_back(std::abs(value - middle_));
    }
    sd_ = kSdOfMedian * median_of(std::move(off));
  }

  [[nodiscard]] double middle() const { return middle_; }
  /// @param error standard error of the value
  [[nodiscard]] bool is_odd(double value, double least, double error) const {
    constexpr double kOdd = 8;
    return std::abs(value - middle_) > std::max({kOdd * sd_, kErrors * error, least});
  }
  [[nodiscard]] bool is_above(double value, double least) const {
    return value - middle_ > std::max(kErrors * sd_, least);
  }

 private:
  static constexpr double kErrors = 3;

  double middle_;
  double sd_ = 0;
};

/// A channel that would fit if it had come sooner, or later.
struct Shift {
  ProfileColumnId column{};
  double late_s = 0;
  double left = 1;  ///< of the squared error
};

/// The best of shifts of one channel against the others in all of these records; none where little
/// would be gained.
std::optional<Shift> shift_of(std::span<const effects::ForceRecord> records) {
  constexpr double kMost_s = 0.6;
  constexpr double kStep_s = 0.01;
  constexpr double kLeast_s = 0.02;
  constexpr double kGained = 0.5;
  std::vector<std::optional<Alone>> now;
  now.reserve(records.size());
  for (const effects::ForceRecord& record : records) {
    now.push_back(alone(record));
  }
  const auto left_by = [&](double input_s, double velocity_s) {
    double sum = 0;
    for (std::size_t j = 0; j < records.size(); ++j) {
      const auto samples = [&](double time_s) {
        return static_cast<std::ptrdiff_t>(std::lround(time_s / records[j].step_s()));
      };
      const auto then = alone(records[j], samples(input_s), samples(velocity_s));
      sum += now[j] && then && then->friction > 0 && now[j]->square_N2 > 0
                 ? then->square_N2 / now[j]->square_N2
                 : 1;
    }
    return sum / static_cast<double>(records.size());
  };
  Shift best;
  for (double late_s = -kMost_s; late_s <= kMost_s; late_s += kStep_s) {
    for (const Shift& shift :
         {Shift{hal::files::kInputTensionColumn, late_s, left_by(late_s, 0)},
          Shift{hal::files::kOutputTensionColumn, late_s, left_by(-late_s, -late_s)},
          Shift{hal::files::kTendonVelocity, late_s, left_by(0, late_s)}}) {
      best = shift.left < best.left ? shift : best;
    }
  }
  return best.left < kGained && std::abs(best.late_s) > kLeast_s ? std::optional(best)
                                                                 : std::nullopt;
}

std::string shift_prose(const Shift& shift) {
  constexpr double kPercent = 100;
  constexpr double kMilli = 1000;
  return fmt::format(
      "{:.0f} % of the squared error would go if it had come {:.0f} ms {}: is it shifted in time "
      "against the others?",
      kPercent * (1 - shift.left), kMilli * std::abs(shift.late_s),
      shift.late_s > 0 ? "sooner" : "later");
}

/// Sessions unlike the others beside a model.
class OddSessions {
 public:
  OddSessions(const ForceData& data, std::span<const effects::ForceRecord> records,
              const ForceFit& model)
      : data_(data), records_(records), model_(model) {
    const auto residuals_N = data.residuals_N(model);
    const std::vector<ForceCovariance::Refit> refits = refits_of(data, residuals_N);
    for (std::size_t j = 0; j < refits.size(); ++j) {
      gains_.push_back(refits[j].value(0));
      frictions_.push_back(refits[j].value(1));
      loads_N2_.push_back(vector_of(data.records()[j].output_N).squaredNorm() /
                          static_cast<double>(data.records()[j].samples()));
      gain_errors_.push_back(std::sqrt(refits[j].covariance(0, 0)));
      friction_errors_.push_back(std::sqrt(refits[j].covariance(1, 1)));
      const Eigen::VectorXd left_N = data.covariance().beside_refit(j, vector_of(residuals_N[j]));
      const double square_N2 = data.covariance().weighted_square(j, left_N);
      left_N2_.push_back(left_N.squaredNorm() / data.counts()[j]);
      log_errors_.push_back(std::log(std::max(square_N2 / data.counts()[j], 1e-300)) / 2);
    }
  }

  void add_to(std::vector<Doubt>& doubts) const {
    constexpr double kLeastGain = 0.05;
    constexpr double kLeastOfFriction = 0.2;
    constexpr double kLeastFriction = 0.02;
    constexpr double kLeastLogError = 1.2;
    constexpr double kPercent = 100;
    constexpr double kLoaded = 0.1;  // without a load there is neither
    const double usual_N2 = median_of(loads_N2_);
    const Robust gain(gains_);
    const Robust friction(frictions_);
    const Robust error(log_errors_);
    const double usual = model_.parameters[1] + friction.middle();
    std::vector<Doubt> odd;
    for (std::size_t j = 0; j < gains_.size(); ++j) {
      const effects::ForceRecord& record = data_.records()[j];
      const bool error_is_odd = error.is_above(log_errors_[j], kLeastLogError);
      const auto shift = error_is_odd ? shift_of_session(j) : std::nullopt;
      const bool loaded = loads_N2_[j] > kLoaded * usual_N2;
      std::string words;
      if (shift) {
        words = shift_prose(*shift);
      } else if (loaded && gain.is_odd(gains_[j], kLeastGain, gain_errors_[j])) {
        words = fmt::format(
            "the input force is {:.3g} times as large beside the output force as in other sessions",
            (1 + gains_[j]) / (1 + gain.middle()));
      } else if (error_is_odd) {
        words = fmt::format("its error is {:.2g} times that of other sessions",
                            std::exp(log_errors_[j] - error.middle()));
      } else if (loaded && usual > kLeastFriction &&
                 friction.is_odd(frictions_[j], kLeastOfFriction * usual, friction_errors_[j])) {
        words = fmt::format("its friction is {:.0f} % of that of other sessions",
                            kPercent * (model_.parameters[1] + frictions_[j]) / usual);
      }
      if (!words.empty()) {
        odd.push_back(
            {{record.session}, shift ? column(shift->column) : "", std::move(words), false});
      }
    }
    // What more sessions show is no oddity of one, but what the model does not have.
    constexpr std::size_t kOneIn = 20;
    if (odd.size() <= std::max<std::size_t>(gains_.size() / kOneIn, 1)) {
      std::ranges::move(odd, std::back_inserter(doubts));
    }
  }

 private:
  /// A shift that leaves no more than other sessions have beside the model: friction that builds up
  /// as the motion turns looks like one, and leaves more.
  [[nodiscard]] std::optional<Shift> shift_of_session(std::size_t session) const {
    constexpr double kTimesUsual = 2;
    const auto now = alone(records_[session]);
    const auto shift = shift_of(records_.subspan(session, 1));
    return now && shift &&
                   shift->left * now->square_N2 < std::pow(kTimesUsual, 2) * median_of(left_N2_)
               ? shift
               : std::nullopt;
  }

  const ForceData& data_;
  std::span<const effects::ForceRecord> records_;  ///< the same, with all samples
  const ForceFit& model_;
  /// Of sessions, beside the model; the gain as a share of that of the model.
  std::vector<double> gains_, frictions_, log_errors_;
  std::vector<double> left_N2_;   ///< mean squares of residuals beside gain and friction of each
  std::vector<double> loads_N2_;  ///< mean squares of the output force
  std::vector<double> gain_errors_, friction_errors_;  ///< standard errors
};

}  // namespace

std::vector<Doubt> doubts_beside(const ForceData& data,
                                 std::span<const effects::ForceRecord> records,
                                 const ForceFit& model, const NominalModel& nominal, bool much) {
  constexpr double kNearlyAll = 0.1;
  constexpr double kTimesNominal = 3;
  std::vector<Doubt> doubts;
  const double gain = model.parameters[0];
  const double friction = model.parameters[1];
  if (std::abs(std::log(gain)) > kDoubtfulLogGain) {
    doubts.push_back({{},
                      input_column(data.records().front()),
                      fmt::format("the input force is {:.3g} times what the model has{}: are its "
                                  "unit, the radius and the torque constant right?",
                                  gain, unit_prose(gain)),
                      false});
  }
  if (nominal.sheath && friction > kTimesNominal * nominal.sheath->friction_coefficient) {
    const double of_nominal = nominal.sheath->friction_coefficient;
    doubts.push_back(
        {{},
         "",
         of_nominal > 0
             ? fmt::format("friction is {:.3g} times the nominal one, {:.3g}: are that, the bend "
                           "angle and the units right?",
                           friction / of_nominal, of_nominal)
             : fmt::format("friction is {:.3g}, and the nominal one is 0", friction),
         false});
  }
  if (const double late_s = data.scales().forces_late_s;
      late_s > 0 && std::ranges::none_of(model.terms, effects::remembers_motion)) {
    constexpr double kMilli = 1000;
    doubts.push_back({{},
                      column(ProfileColumnId::kTendonVelocity),
                      fmt::format("friction turns over {:.2g} ms after it: both forces come that "
                                  "late, as through filters, which is taken into account",
                                  kMilli * late_s),
                      false});
  }
  if (data.records().size() >= kEnoughToCompare) {
    OddSessions(data, records, model).add_to(doubts);
  }
  if (much) {
    if (const auto shift = shift_of(records)) {
      doubts.push_back({{}, column(shift->column), shift_prose(*shift), shift->left < kNearlyAll});
    }
  }
  return doubts;
}

}  // namespace host_sim::diagnose
