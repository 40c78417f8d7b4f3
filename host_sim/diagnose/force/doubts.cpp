#include "host_sim/diagnose/force/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "host_sim/diagnose/force/alone.hpp"
#include "host_sim/recording/fault_rules.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kDegPerRad = 180 / std::numbers::pi;

/// Of sessions: what so many show is told of all.
constexpr double kMostOfAll = 0.8;

/// A factor by which no effect and no wear changes a force or a length.
constexpr double kBeyondPhysics = 3;

/// What the rotor and the velocity say of the way from one sample to the next.
struct Move {
  double moved_m = 0;
  double expected_m = 0;
  double turned_rad = 0;
};

/// Without those over a gap of the log.
std::vector<Move> moves_of(const effects::ForceRecord& record) {
  std::vector<bool> behind_gap(record.samples());
  for (const recording::Stretch& gap : recording::gaps_in(record.time_s)) {
    behind_gap[gap.first] = true;
  }
  std::vector<Move> moves;
  for (std::size_t i = 1; i < record.samples(); ++i) {
    if (!behind_gap[i]) {
      moves.push_back(
          {record.position_m[i] - record.position_m[i - 1],
           (record.velocity_m_s[i] + record.velocity_m_s[i - 1]) / 2 *
               (record.time_s[i] - record.time_s[i - 1]),
           record.rotor_rad.empty() ? 0 : record.rotor_rad[i] - record.rotor_rad[i - 1]});
    }
  }
  return moves;
}

/// Whether an angle jumps by whole turns, which no rotor does from one sample to the next that else
/// turns far less.
bool starts_again(const Move& move, double usual_rad) {
  constexpr double kFar = 10;
  constexpr double kOfTurn = 0.1;
  const double turns = std::abs(move.turned_rad) / (2 * std::numbers::pi);
  return turns > 1 - kOfTurn && std::abs(turns - std::round(turns)) < kOfTurn &&
         std::abs(move.turned_rad) > kFar * usual_rad;
}

/// Adds how far the rotor moves beside what the velocity says.
void add_motion(const effects::ForceRecord& record, Alone& seen) {
  const std::vector<Move> moves = moves_of(record);
  double square_rad2 = 0;
  for (const Move& move : moves) {
    square_rad2 += std::min(std::pow(move.turned_rad, 2), 1.0);
  }
  const double usual_rad =
      std::sqrt(square_rad2 / static_cast<double>(std::max<std::size_t>(moves.size(), 1)));
  double products = 0;
  double moved_m2 = 0;
  double expected_m2 = 0;
  for (const Move& move : moves) {
    if (starts_again(move, usual_rad)) {
      seen.starts_again = true;
      continue;
    }
    products += move.moved_m * move.expected_m;
    moved_m2 += move.moved_m * move.moved_m;
    expected_m2 += move.expected_m * move.expected_m;
  }
  if (moved_m2 > 0 && expected_m2 > 0) {
    seen.scale = std::sqrt(moved_m2 / expected_m2);
    seen.along = products / std::sqrt(moved_m2 * expected_m2);
  }
}

/// Sessions by what suits each alone, and what is told of them.
class Sessions {
 public:
  Sessions(std::span<const effects::ForceRecord> records, const NominalModel& nominal)
      : nominal_(nominal) {
    for (const effects::ForceRecord& record : records) {
      std::optional<Alone> seen = alone(record);
      if (seen) {
        add_motion(record, *seen);
        seen_.push_back(*seen);
        of_.push_back(&record);
      }
    }
  }

  std::vector<Doubt> doubts() {
    if (!seen_.empty()) {
      of_sign();
      of_gain();
      of_friction();
      of_angles();
      of_motion();
      of_speed();
      of_holds();
    }
    return std::move(doubts_);
  }

 private:
  [[nodiscard]] double median(double Alone::*value) const {
    std::vector<double> values;
    for (const Alone& seen : seen_) {
      values.push_back(seen.*value);
    }
    return median_of(std::move(values));
  }

  template <typename Is>
  [[nodiscard]] std::vector<std::string> sessions_that(Is is) const {
    std::vector<std::string> sessions;
    for (std::size_t j = 0; j < seen_.size(); ++j) {
      if (is(seen_[j])) {
        sessions.push_back(of_[j]->session);
      }
    }
    return sessions;
  }

  [[nodiscard]] double share(const std::vector<std::string>& sessions) const {
    return static_cast<double>(sessions.size()) / static_cast<double>(seen_.size());
  }

  void add_of_all(std::string column, std::string words, bool spoils) {
    doubts_.push_back({{}, std::move(column), std::move(words), spoils});
  }

  /// Nothing where no session is one of these, or where they are too many to be unlike the others.
  void add_of_few(std::vector<std::string> sessions, std::string column, std::string words,
                  bool spoils) {
    if (!sessions.empty() && seen_.size() >= kEnoughToCompare && share(sessions) <= kFewOfAll) {
      doubts_.push_back({std::move(sessions), std::move(column), std::move(words), spoils});
    }
  }

  /// The same, each with words of its own.
  template <typename Is, typename Words>
  void add_each_of_few(Is is, const std::string& column, Words words_of, bool spoils) {
    if (seen_.size() < kEnoughToCompare || share(sessions_that(is)) > kFewOfAll) {
      return;
    }
    for (std::size_t j = 0; j < seen_.size(); ++j) {
      if (is(seen_[j])) {
        doubts_.push_back({{of_[j]->session}, column, words_of(seen_[j]), spoils});
      }
    }
  }

  /// A tendon only pulls, but for the zero of a sensor.
  void of_sign() {
    constexpr double kOfLargest = 0.2;
    if (!of_.front()->pulls_alone) {
      return;
    }
    for (const auto& [values_N, name] :
         {std::pair(&effects::ForceRecord::input_N, input_column(*of_.front())),
          std::pair(&effects::ForceRecord::output_N, column(hal::files::kOutputTensionColumn))}) {
      double least_N = HUGE_VAL;
      double most_N = -HUGE_VAL;
      for (const effects::ForceRecord* const record : of_) {
        const auto [least, most] = std::ranges::minmax(record->*values_N);
        least_N = std::min(least_N, least);
        most_N = std::max(most_N, most);
      }
      const auto below =
          std::ranges::count_if(of_, [&, of = values_N](const effects::ForceRecord* record) {
            return std::ranges::min(record->*of) < -kOfLargest * most_N;
          });
      if (static_cast<double>(below) > kFewOfAll * static_cast<double>(of_.size())) {
        add_of_all(
            name,
            fmt::format("the force lies between {:.3g} and {:.3g} N, and a tendon alone only "
                        "pulls: does the drive work in both directions ([campaign] two_sided "
                        "= true), or does it count the other way round?",
                        least_N, most_N),
            false);
      }
    }
  }

  /// Of a drive that runs nearly free it is little known, and between two bounds where friction is
  /// nearly as large as the load.
  void of_gain() {
    constexpr double kMostly = 0.5;
    constexpr double kOfUnits = 4;
    if (median(&Alone::by_output) < kMostly) {
      return;
    }
    const double gain = median(&Alone::gain);
    const std::string column_of_input = input_column(*of_.front());
    if (gain <= 0) {
      add_of_all(column_of_input,
                 "the forces at both ends have opposite signs: does one of them count the other "
                 "way round?",
                 true);
      return;
    }
    const double most_gain = median(&Alone::most_gain);
    if (std::abs(std::log(std::clamp(1.0, gain, most_gain))) > std::log(kBeyondPhysics)) {
      add_of_all(column_of_input,
                 fmt::format("the input force is {:.3g} times the output force{}: are the units of "
                             "both, the radius and the torque constant right?",
                             gain, unit_prose(gain)),
                 true);
    }
    const auto times_others = [&](const Alone& one) {
      const auto [least, most] = std::minmax({one.gain / gain, one.most_gain / most_gain});
      return one.gain <= 0 ? one.gain / gain : std::clamp(1.0, least, most);
    };
    add_each_of_few(
        [&](const Alone& one) {
          return one.by_output > kMostly &&
                 (one.gain <= 0 || std::abs(std::log(times_others(one))) > std::log(kOfUnits));
        },
        "",
        [&](const Alone& one) {
          const double times = times_others(one);
          return fmt::format(
              "the input force is {:.3g} times as large beside the output force as "
              "in other sessions{}: are units and signs those of the others?",
              times, unit_prose(times));
        },
        true);
  }

  /// Against the motion it takes energy; nothing that a tendon has gives any.
  void of_friction() {
    constexpr double kShown = 0.2;
    constexpr double kShownAlone = 0.5;
    constexpr double kNotLess = 0.3;
    const double friction = median(&Alone::friction);
    const auto drives = [](double shown) {
      return [shown](const Alone& one) { return one.friction < 0 && one.shown > shown; };
    };
    if (share(sessions_that(drives(kShown))) > kMostOfAll) {
      const bool agrees = of_.front()->rotor_known && median(&Alone::along) < 0;
      add_of_all(column(hal::files::kTendonVelocity),
                 fmt::format("friction would drive the motion and not brake it: {}",
                             agrees ? "the velocity counts the other way round, as the motor "
                                      "angle shows, too"
                                    : "does the velocity count the other way round, or both "
                                      "forces, or are the two ends exchanged?"),
                 true);
      return;
    }
    const auto brakes = [](const Alone& one) {
      return one.friction > 0 && one.shown > kShownAlone;
    };
    if (share(sessions_that(brakes)) >= 1 - kFewOfAll) {
      add_of_few(sessions_that([&](const Alone& one) {
                   return drives(kShownAlone)(one) && -one.friction > kNotLess * friction;
                 }),
                 column(hal::files::kTendonVelocity),
                 "friction would drive the motion and not brake it, unlike in other sessions: does "
                 "the velocity count the other way round?",
                 true);
    }
  }

  /// In degrees a sheath that turns by less than 12 is straight, and has no friction to speak of.
  void of_angles() {
    constexpr double kTwoTurns_rad = 4 * std::numbers::pi / kDegPerRad;
    constexpr double kFarMore = 10;
    const auto in_radians = [](const Alone& one) {
      return one.mean_angle_rad > 0 && one.mean_angle_rad < kTwoTurns_rad;
    };
    const auto coefficient = [](const Alone& one) { return one.friction / one.mean_angle_rad; };
    const std::string words =
        "the sheath turns by less than 13 degrees and has the friction of one "
        "that turns by {:.0f}: is the angle in radians?";
    if (nominal_.sheath && share(sessions_that(in_radians)) > kMostOfAll) {
      const double angle_rad = median(&Alone::mean_angle_rad);
      const double nominal = nominal_.sheath->friction_coefficient;
      if (nominal > 0 && median(&Alone::friction) > kFarMore * nominal * angle_rad) {
        add_of_all(
            column(hal::files::kBendAngle),
            fmt::format(fmt::runtime(words), median(&Alone::friction) / nominal * kDegPerRad),
            true);
      }
      return;
    }
    std::vector<double> coefficients;
    for (const Alone& one : seen_) {
      if (!in_radians(one) && one.mean_angle_rad > 0) {
        coefficients.push_back(coefficient(one));
      }
    }
    if (coefficients.empty()) {
      return;
    }
    const double usual = median_of(std::move(coefficients));
    add_each_of_few(
        [&](const Alone& one) {
          return usual > 0 && in_radians(one) && coefficient(one) > kFarMore * usual;
        },
        column(hal::files::kBendAngle),
        [&](const Alone& one) {
          return fmt::format(fmt::runtime(words), one.friction / usual * kDegPerRad);
        },
        true);
  }

  /// What the rotor and the velocity say of the same motion.
  void of_motion() {
    constexpr double kOpposite = -0.5;
    constexpr double kScale = 1.3;
    if (!of_.front()->rotor_known) {
      return;
    }
    const std::string angle = column(hal::files::kMotorAngle);
    if (const std::vector<std::string> wrapped =
            sessions_that([](const Alone& one) { return one.starts_again; });
        !wrapped.empty()) {
      doubts_.push_back({share(wrapped) > kMostOfAll ? std::vector<std::string>() : wrapped, angle,
                         "the angle jumps by whole turns from one sample to the next: does it "
                         "start again after a turn? It has to count on",
                         true});
    }
    const auto opposite = [](const Alone& one) { return one.along < kOpposite; };
    const std::vector<std::string> against = sessions_that(opposite);
    const bool told = std::ranges::any_of(doubts_, [](const Doubt& doubt) {
      return doubt.column == column(hal::files::kTendonVelocity);
    });
    if (share(against) > kMostOfAll && !told) {
      add_of_all(angle,
                 "the position runs against the velocity: does the angle count the other way "
                 "round?",
                 false);
    } else if (share(against) <= kMostOfAll && !told) {
      add_of_few(against, angle,
                 "the position runs against the velocity, unlike in other sessions: does one of "
                 "the two count the other way round?",
                 true);
    }
    const double scale = median(&Alone::scale);
    const std::string words =
        "the position moves {:.3g} times as far as the velocity says{}{}: are "
        "the units of both, the radius and the ratio of the gear right?";
    if (std::abs(std::log(scale)) > std::log(kScale)) {
      add_of_all(angle, fmt::format(fmt::runtime(words), scale, "", motion_unit_prose(scale)),
                 std::abs(std::log(scale)) > std::log(kBeyondPhysics));
    }
    for (const bool beyond : {false, true}) {
      add_each_of_few(
          [&](const Alone& one) {
            const double off = std::abs(std::log(one.scale / scale));
            return off > std::log(kScale) && (off > std::log(kBeyondPhysics)) == beyond;
          },
          angle,
          [&](const Alone& one) {
            const double times = one.scale / scale;
            return fmt::format(fmt::runtime(words), times, " beside other sessions",
                               motion_unit_prose(times));
          },
          beyond);
    }
  }

  /// No tendon of an actuator moves so fast or so far.
  void of_speed() {
    constexpr double kFast_m_s = 20;
    constexpr double kFar_m = 5;
    double fastest_m_s = 0;
    double farthest_m = 0;
    for (const effects::ForceRecord* const record : of_) {
      for (const double velocity_m_s : record->velocity_m_s) {
        fastest_m_s = std::max(fastest_m_s, std::abs(velocity_m_s));
      }
      const auto [least_m, most_m] = std::ranges::minmax(record->position_m);
      farthest_m = std::max(farthest_m, record->rotor_known ? 0 : most_m - least_m);
    }
    if (fastest_m_s > kFast_m_s || farthest_m > kFar_m) {
      add_of_all(column(hal::files::kTendonVelocity),
                 fmt::format("the tendon would move at up to {:.3g} m/s{}: is the velocity in "
                             "mm/s?",
                             fastest_m_s,
                             farthest_m > 0 ? fmt::format(" and over {:.3g} m", farthest_m) : ""),
                 true);
    }
  }

  /// As the first session of these has it.
  void of_holds() {
    for (const auto& [hold, name] :
         {std::pair(&effects::ForceRecord::input_hold, input_column(*of_.front())),
          std::pair(&effects::ForceRecord::output_hold,
                    column(hal::files::kOutputTensionColumn))}) {
      std::vector<std::string> sessions;
      const effects::ForceRecord* first = nullptr;
      for (const effects::ForceRecord* const record : of_) {
        if (record->*hold > 1) {
          first = first == nullptr ? record : first;
          sessions.push_back(record->session);
        }
      }
      if (first != nullptr) {
        doubts_.push_back(
            {share(sessions) > kMostOfAll ? std::vector<std::string>() : sessions, name,
             fmt::format("each value stays for {} samples of the log, {:.3g} s: the sensor is read "
                         "less often than it is logged. Only samples at which it is new count",
                         first->*hold, first->step_s()),
             false});
      }
    }
  }

  const NominalModel& nominal_;
  std::vector<Alone> seen_;
  std::vector<const effects::ForceRecord*> of_;  ///< of each that is seen
  std::vector<Doubt> doubts_;
};

}  // namespace

std::vector<Doubt> doubts_of(std::span<const effects::ForceRecord> records,
                             const NominalModel& nominal) {
  return Sessions(records, nominal).doubts();
}

std::vector<effects::ForceRecord> sound_of(const std::vector<effects::ForceRecord>& records,
                                           std::vector<Doubt>& doubts) {
  const auto is_spoilt = [&](const effects::ForceRecord& record) {
    return std::ranges::any_of(doubts, [&](const Doubt& doubt) {
      return doubt.spoils &&
             std::ranges::find(doubt.sessions, record.session) != doubt.sessions.end();
    });
  };
  std::vector<effects::ForceRecord> sound;
  std::ranges::copy_if(records, std::back_inserter(sound), std::not_fn(is_spoilt));
  if (sound.size() >= kLeastSessions && 2 * sound.size() > records.size()) {
    return sound;
  }
  for (Doubt& doubt : doubts) {
    doubt.spoils = doubt.spoils && doubt.sessions.empty();
  }
  return records;
}

}  // namespace host_sim::diagnose
