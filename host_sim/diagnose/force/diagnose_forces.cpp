#include "host_sim/diagnose/force/diagnose_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "host_sim/diagnose/force/force_fit.hpp"
#include "host_sim/diagnose/force/written_term.hpp"
#include "host_sim/diagnose/sessions.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::diagnose {
namespace {

constexpr double kWorthTrying = 0.02;  ///< of ln rmse, for the search to go on
constexpr double kSeen = 3;            ///< standard errors
constexpr double kStandsIn = 0.05;     ///< of ln rmse, for another in the place of an effect
constexpr double kPrior = 0.05;        ///< of an effect of the catalogue

/// A term in the model, by what the model does without it.
struct Judged {
  ForceTerm term{};
  PairedGain gain;
  ForceFit without;
  std::vector<ForceTerm> others;  ///< that could stand in its place

  [[nodiscard]] bool stays() const { return gain.mean >= kMaterialGain && gain.z >= kCertainGain; }
};

/// Growing and pruning on sessions that the fit never saw.
class Search {
 public:
  Search(const ForceData& data, double friction, const DiagnoseOptions& options)
      : data_(data),
        threads_(options.threads),
        without_(options.without),
        nominal_(data.fit({}, {1, friction}, kIterations)),
        nominal_N2_(data.held_out_N2(nominal_)),
        model_(nominal_),
        model_N2_(nominal_N2_) {}

  void run() {
    while (model_.terms.size() < kMostForceTerms && grow()) {
    }
    for (int round = 0; round < kRounds; ++round) {
      while (prune()) {
      }
      if (!exchange(round + 1 < kRounds)) {
        break;
      }
    }
  }

  [[nodiscard]] const ForceFit& nominal() const { return nominal_; }
  [[nodiscard]] const ForceFit& model() const { return model_; }
  [[nodiscard]] double nominal_rmse_N() const { return data_.rmse_N(nominal_N2_); }
  [[nodiscard]] double rmse_N() const { return data_.rmse_N(model_N2_); }
  [[nodiscard]] const std::vector<Judged>& judged() const { return judged_; }

  struct Candidate {
    ForceFit fit;
    std::vector<double> held_N2;
  };

  /// From the nominal model on, one term more each: those that stay in the order in which they
  /// came, or where none stays all that came.
  [[nodiscard]] std::vector<Candidate> stairs() const {
    std::vector<Candidate> stairs{{nominal_, nominal_N2_}};
    for (const ForceTerm term : grown_) {
      if (judged_.empty() || std::ranges::find(judged_, term, &Judged::term) != judged_.end()) {
        Candidate next{data_.with(stairs.back().fit, term), {}};
        next.held_N2 = data_.held_out_N2(next.fit);
        stairs.push_back(std::move(next));
      }
    }
    return stairs;
  }

 private:
  static constexpr int kIterations = 15;
  static constexpr int kRounds = 3;  ///< of terms that take the place of others

  [[nodiscard]] std::vector<ForceTerm> outside() const {
    std::vector<ForceTerm> terms;
    for (unsigned i = 0; i < kForceTermCount; ++i) {
      const auto term = static_cast<ForceTerm>(i);
      const bool wanted = std::ranges::find(without_, definition_of(term).id) == without_.end();
      if (wanted && is_shown(term, data_.records()) &&
          std::ranges::find(model_.terms, term) == model_.terms.end()) {
        terms.push_back(term);
      }
    }
    return terms;
  }

  /// The model with each of these more, the least squares first.
  [[nodiscard]] std::vector<Candidate> with_each(const ForceFit& from,
                                                 const std::vector<ForceTerm>& terms) const {
    std::vector<Candidate> all(terms.size());
    statistics::parallel_for(
        terms.size(), [&](std::size_t i) { all[i].fit = data_.with(from, terms[i]); }, threads_);
    std::ranges::sort(all, {}, [](const Candidate& one) { return one.fit.square_N2; });
    return all;
  }

  void hold_out(std::vector<Candidate>& all) const {
    statistics::parallel_for(
        all.size(), [&](std::size_t i) { all[i].held_N2 = data_.held_out_N2(all[i].fit); },
        threads_);
  }

  /// Adds the term of the least error on sessions that the fit never saw, if it is worth it.
  bool grow() {
    constexpr std::size_t kTried = 3;
    std::vector<Candidate> all = with_each(model_, outside());
    all.resize(std::min(all.size(), kTried));
    hold_out(all);
    const auto best = std::ranges::min_element(
        all, {}, [&](const Candidate& one) { return data_.rmse_N(one.held_N2); });
    if (best == all.end() || paired_gain(model_N2_, best->held_N2).z < kSeen ||
        std::log(data_.rmse_N(model_N2_) / data_.rmse_N(best->held_N2)) < kWorthTrying) {
      return false;
    }
    model_ = best->fit;
    model_N2_ = best->held_N2;
    grown_.push_back(model_.terms.back());
    return true;
  }

  /// Judges each term, and takes out the one that matters least if it does not stay.
  bool prune() {
    judged_.assign(model_.terms.size(), {});
    std::vector<Candidate> all(model_.terms.size());
    statistics::parallel_for(
        all.size(), [&](std::size_t i) { all[i].fit = data_.without(model_, i); }, threads_);
    hold_out(all);
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < all.size(); ++i) {
      judged_[i] = {.term = model_.terms[i],
                    .gain = paired_gain(all[i].held_N2, model_N2_),
                    .without = all[i].fit,
                    .others = {}};
      if (!(judged_[i].stays() && !data_.at_bound(model_, i)) &&
          (!least || judged_[i].gain.mean < judged_[*least].gain.mean)) {
        least = i;
      }
    }
    if (!least) {
      return false;
    }
    model_ = std::move(all[*least].fit);
    model_N2_ = std::move(all[*least].held_N2);
    return true;
  }

  /// Finds what could stand in the place of each term. Where that does better it takes the place,
  /// as long as that is allowed, and all are judged anew.
  bool exchange(bool allowed) {
    for (std::size_t place = 0; place < judged_.size(); ++place) {
      for (Candidate& one : in_place_of(place)) {
        const PairedGain lost = paired_gain(one.held_N2, model_N2_);
        if (allowed && lost.mean < -kWorthTrying && lost.z < -kSeen) {
          grown_.push_back(one.fit.terms.back());
          model_ = std::move(one.fit);
          model_N2_ = std::move(one.held_N2);
          return true;
        }
        if (lost.mean < kStandsIn || lost.z < kSeen) {
          judged_[place].others.push_back(one.fit.terms.back());
        }
      }
    }
    return false;
  }

  /// The model with another term in the place of one, where it fits nearly as well or better.
  [[nodiscard]] std::vector<Candidate> in_place_of(std::size_t place) const {
    std::vector<Candidate> all = with_each(judged_[place].without, outside());
    std::erase_if(all, [&](const Candidate& one) {
      return std::log(one.fit.square_N2 / model_.square_N2) / 2 > 2 * kStandsIn;
    });
    hold_out(all);
    return all;
  }

  const ForceData& data_;
  unsigned threads_;
  std::vector<std::string> without_;
  ForceFit nominal_;
  std::vector<double> nominal_N2_;
  ForceFit model_;
  std::vector<double> model_N2_;
  std::vector<Judged> judged_;
  std::vector<ForceTerm> grown_;
};

/// Laplace: the standard errors of the gain as evidence, one parameter more for as many sessions.
double probability_of(const PairedGain& gain, std::size_t sessions) {
  const double log_odds = gain.z * gain.z / 2 - std::log(static_cast<double>(sessions)) / 2 +
                          std::log(kPrior / (1 - kPrior));
  return gain.mean > 0 ? 1 / (1 + std::exp(-log_odds)) : 0;
}

/// What residuals may depend on.
struct Against {
  const char* name;
  const char* unit;
  std::vector<std::vector<double>> values;  ///< by record and sample
};

std::vector<double> travel_of(const ForceRecord& record) {
  std::vector<double> travel_m(record.samples());
  double since_m = record.samples() == 0 ? 0 : record.position_m.front();
  for (std::size_t i = 1; i < record.samples(); ++i) {
    if (record.velocity_m_s[i] * record.velocity_m_s[i - 1] <= 0) {
      since_m = record.position_m[i];
    }
    travel_m[i] = std::abs(record.position_m[i] - since_m);
  }
  return travel_m;
}

std::vector<double> sizes_of(std::vector<double> values) {
  for (double& value : values) {
    value = std::abs(value);
  }
  return values;
}

std::vector<Against> all_against(const std::vector<ForceRecord>& records) {
  std::vector<Against> all{{"output tension", "N", {}},
                           {"position", "m", {}},
                           {"speed", "m/s", {}},
                           {"travel", "m", {}}};
  for (const ForceRecord& record : records) {
    all[0].values.push_back(sizes_of(record.output_N));
    all[1].values.push_back(record.position_m);
    all[2].values.push_back(sizes_of(record.velocity_m_s));
    all[3].values.push_back(travel_of(record));
  }
  return all;
}

/// Mean residual of each session in each bin of a covariate, by direction; absent where a session
/// has few samples there.
class BinMeans {
 public:
  static constexpr std::size_t kBins = 8;

  BinMeans(const std::vector<ForceRecord>& records, const Against& against,
           const std::vector<std::vector<double>>& residuals_N)
      : means_N_(records.size()) {
    std::vector<double> sorted;
    for (const auto& values : against.values) {
      sorted.insert(sorted.end(), values.begin(), values.end());
    }
    std::ranges::sort(sorted);
    for (std::size_t j = 0; j < records.size(); ++j) {
      std::array<double, 2 * kBins> sums{};
      std::array<std::size_t, 2 * kBins> counts{};
      for (std::size_t i = 0; i < records[j].samples(); ++i) {
        const auto below = std::ranges::lower_bound(sorted, against.values[j][i]) - sorted.begin();
        const std::size_t bin =
            std::min(static_cast<std::size_t>(below) * kBins / sorted.size(), kBins - 1) * 2 +
            (records[j].velocity_m_s[i] < 0 ? 1 : 0);
        if (records[j].used[i]) {
          sums[bin] += residuals_N[j][i];
          ++counts[bin];
        }
      }
      for (std::size_t bin = 0; bin < 2 * kBins; ++bin) {
        constexpr std::size_t kFew = 3;
        means_N_[j][bin] = counts[bin] < kFew
                               ? std::nullopt
                               : std::optional(sums[bin] / static_cast<double>(counts[bin]));
      }
    }
  }

  /// How far the means are from zero against their scatter between sessions, all bins together.
  [[nodiscard]] double statistic(const std::vector<double>& signs) const {
    double sum = 0;
    double bins = 0;
    for (std::size_t bin = 0; bin < 2 * kBins; ++bin) {
      double count = 0;
      double mean = 0;
      double square = 0;
      for (std::size_t j = 0; j < means_N_.size(); ++j) {
        if (means_N_[j][bin]) {
          const double value = signs[j] * *means_N_[j][bin];
          ++count;
          mean += value;
          square += value * value;
        }
      }
      constexpr double kFew = 4;
      if (count >= kFew && square > 0) {
        sum += mean * mean / square;
        ++bins;
      }
    }
    return bins > 0 ? sum / bins : 0;
  }

  /// Of one bin, those that there are.
  [[nodiscard]] std::vector<double> of_sessions(std::size_t bin) const {
    std::vector<double> all;
    for (const auto& session : means_N_) {
      if (session[bin]) {
        all.push_back(*session[bin]);
      }
    }
    return all;
  }

 private:
  std::vector<std::array<std::optional<double>, 2 * kBins>> means_N_;
};

struct Left {
  std::string covariate;
  double p = 1;
};

/// Does what is left depend on something in the same way in all sessions? By signs of sessions that
/// are turned over at random, and the largest statistic of all covariates.
Left left_over(const ForceData& data, const ForceFit& model, std::uint64_t seed) {
  constexpr int kDraws = 999;
  std::vector<std::vector<double>> residuals_N;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    residuals_N.push_back(data.residuals_N(j, model.terms, model.parameters));
  }
  const std::vector<Against> all = all_against(data.records());
  std::vector<BinMeans> bins;
  bins.reserve(all.size());
  for (const Against& against : all) {
    bins.emplace_back(data.records(), against, residuals_N);
  }
  std::vector<double> signs(data.records().size(), 1);
  std::size_t most = 0;
  double largest = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double statistic = bins[i].statistic(signs);
    if (statistic > largest) {
      largest = statistic;
      most = i;
    }
  }
  int as_large = 1;
  for (int draw = 0; draw < kDraws; ++draw) {
    constexpr std::uint64_t kStream = 41;
    statistics::Random random(seed, kStream, static_cast<std::uint64_t>(draw));
    for (double& sign : signs) {
      sign = random.uniform() < 0.5 ? -1 : 1;
    }
    as_large += std::ranges::any_of(
        bins, [&](const BinMeans& one) { return one.statistic(signs) >= largest; });
  }
  return {all[most].name, static_cast<double>(as_large) / (kDraws + 1)};
}

struct Spread {
  double mean_N = 0;
  double sd_N = 0;
};

/// @pre two values or more
Spread spread_of(const std::vector<double>& values_N) {
  const auto count = static_cast<double>(values_N.size());
  const double mean_N = std::accumulate(values_N.begin(), values_N.end(), 0.0) / count;
  double square_N2 = 0;
  for (const double value_N : values_N) {
    square_N2 += (value_N - mean_N) * (value_N - mean_N);
  }
  return {mean_N, std::sqrt(square_N2 / (count - 1))};
}

BinMeans bins_of(const ForceData& data, const ForceFit& by, const Against& against) {
  std::vector<std::vector<double>> residuals_N;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    residuals_N.push_back(data.residuals_N(j, by.terms, by.parameters));
  }
  return {data.records(), against, residuals_N};
}

/// What both models leave against one covariate, in the bins that left_over() tests.
std::vector<RemainderPicture> remainder_pictures(const ForceData& data, const ForceFit& nominal,
                                                 const ForceFit& model,
                                                 const std::string& covariate) {
  const std::vector<Against> all = all_against(data.records());
  const Against& against = *std::ranges::find(all, covariate, &Against::name);
  const BinMeans before = bins_of(data, nominal, against);
  const BinMeans after = bins_of(data, model, against);
  std::vector<double> sorted;
  for (const auto& values : against.values) {
    sorted.insert(sorted.end(), values.begin(), values.end());
  }
  std::ranges::sort(sorted);
  std::vector<RemainderPicture> pictures;
  for (const std::size_t back : {0U, 1U}) {
    RemainderPicture picture{against.name, against.unit, back == 0 ? 1 : -1, {}, {}, {}, {}, {}};
    for (std::size_t bin = 0; bin < BinMeans::kBins; ++bin) {
      const std::vector<double> before_N = before.of_sessions(2 * bin + back);
      const std::vector<double> after_N = after.of_sessions(2 * bin + back);
      if (before_N.size() < 2) {
        continue;
      }
      picture.centre.push_back(sorted[(2 * bin + 1) * sorted.size() / (2 * BinMeans::kBins)]);
      const Spread was = spread_of(before_N);
      const Spread is = spread_of(after_N);
      picture.before_N.push_back(was.mean_N);
      picture.before_sd_N.push_back(was.sd_N);
      picture.after_N.push_back(is.mean_N);
      picture.after_sd_N.push_back(is.sd_N);
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

/// The error of the output force that one of the input force is, sample by sample.
double output_rmse_N(const ForceData& data, const ForceFit& model) {
  constexpr double kStep = 1e-3;
  const double step_N = kStep * data.scales().force_N;
  double square_N2 = 0;
  std::vector<double> at;
  std::vector<double> above;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    const std::vector<double> residuals_N = data.residuals_N(j, model.terms, model.parameters);
    ForceRecord moved = data.records()[j];
    predict_input(moved, model.terms, data.scales(), model.parameters, at);
    for (double& output_N : moved.output_N) {
      output_N += step_N;
    }
    predict_input(moved, model.terms, data.scales(), model.parameters, above);
    for (std::size_t i = 0; i < at.size(); ++i) {
      constexpr double kLeastSlope = 0.05;
      const double slope = std::max((above[i] - at[i]) / step_N, kLeastSlope);
      square_N2 += residuals_N[i] * residuals_N[i] / (slope * slope);
    }
  }
  return std::sqrt(square_N2 / data.samples());
}

class Report {
 public:
  Report(const ForceData& data, const Search& search, const NominalModel& nominal,
         const reference::Constants& constants, const DiagnoseOptions& options)
      : data_(data),
        search_(search),
        nominal_(nominal),
        constants_(constants),
        left_(left_over(data, search.model(), options.seed)) {}

  TensionDiagnosis diagnosis() const {
    TensionDiagnosis diagnosis;
    Findings& findings = diagnosis.findings;
    findings.verdict = verdict();
    add_candidates(findings);
    add_effects(findings);
    findings.steps = steps();
    findings.gain = gain();
    const double share = search_.rmse_N() / search_.nominal_rmse_N();
    findings.remainder = Remainder{.share = share * share,
                                   .input_rmse_N = search_.rmse_N(),
                                   .output_rmse_N = output_rmse_N(data_, search_.model()),
                                   .covariate = left_.covariate,
                                   .p = left_.p};
    add_refitted(diagnosis);
    findings.prose = sentences(findings);
    if (findings.verdict == Verdict::named) {
      withdraw_unless_improved(findings);
      diagnosis.damage_ratio = damage_ratio();
    }
    add_traces(diagnosis);
    diagnosis.remainders =
        remainder_pictures(data_, search_.nominal(), search_.model(), left_.covariate);
    return diagnosis;
  }

 private:
  [[nodiscard]] bool few() const { return data_.records().size() < kLeastSessions; }

  [[nodiscard]] Verdict verdict() const {
    const auto& judged = search_.judged();
    if (judged.empty() || few()) {
      constexpr double kChance = 0.01;
      return left_.p < kChance ? Verdict::unknown : Verdict::none;
    }
    return std::ranges::any_of(judged, [&](const Judged& one) { return stands(one); })
               ? Verdict::named
               : Verdict::ambiguous;
  }

  /// By itself: nothing could be in its place.
  [[nodiscard]] bool stands(const Judged& one) const {
    return one.others.empty() && probability_of(one.gain, data_.records().size()) >= kNamed;
  }

  void add_candidates(Findings& findings) const {
    const std::string rest = findings.verdict == Verdict::none ? "none" : "unknown";
    double all = few() ? 0 : 1;
    std::vector<std::string> ids;
    for (const Judged& one : search_.judged()) {
      if (findings.verdict == Verdict::named && !stands(one)) {
        continue;
      }
      ids.emplace_back(definition_of(one.term).id);
      all *= probability_of(one.gain, data_.records().size()) /
             static_cast<double>(1 + one.others.size());
    }
    std::ranges::sort(ids);
    if (ids.empty() || all == 0) {
      findings.candidates = {{rest, 1}};
    } else {
      findings.candidates = {{fmt::format("{}", fmt::join(ids, "+")), all}, {rest, 1 - all}};
    }
    std::ranges::stable_sort(findings.candidates, std::greater<>(), &Candidate::probability);
    findings.credible_set = {findings.candidates.front().id};
    if (findings.candidates.front().probability < kNamed && findings.candidates.size() > 1) {
      findings.credible_set.push_back(findings.candidates.back().id);
    }
  }

  /// A term with its parameters, but for its probability.
  [[nodiscard]] FoundEffect effect_of(ForceTerm term, const ForceFit& model) const {
    const ForceTermDefinition& of = definition_of(term);
    FoundEffect found{.id = std::string(of.id),
                      .term = std::string(of.term),
                      .equation = std::string(of.equation),
                      .life_consequence = std::string(of.life_consequence),
                      .probability = 0,
                      .parameters = {}};
    const std::vector<double> half = data_.half_widths(model);
    std::size_t next = 2;
    for (const ForceTerm before : model.terms) {
      for (const ForceParameter& parameter : parameters_of(before, data_.scales())) {
        const double value = model.parameters[next];
        if (before == term) {
          found.parameters.push_back({std::string(parameter.name), std::string(parameter.unit),
                                      value, value - half[next], value + half[next]});
        }
        ++next;
      }
    }
    return found;
  }

  void add_effects(Findings& findings) const {
    if (findings.verdict != Verdict::named && findings.verdict != Verdict::ambiguous) {
      return;
    }
    for (const Judged& one : search_.judged()) {
      FoundEffect found = effect_of(one.term, search_.model());
      found.probability = probability_of(one.gain, data_.records().size());
      if (!one.others.empty()) {
        std::vector<std::string> same{found.id};
        for (const ForceTerm other : one.others) {
          same.emplace_back(definition_of(other).id);
        }
        findings.equivalent_sets.push_back(std::move(same));
      }
      if (findings.verdict == Verdict::named) {
        add_extension(one.term, found.parameters, findings);
      }
      if (findings.verdict != Verdict::named || stands(one)) {
        findings.effects.push_back(std::move(found));
      }
    }
  }

  /// Of what a written model can hold.
  void add_extension(ForceTerm term, const std::vector<Estimate>& parameters,
                     Findings& findings) const {
    // A controller knows the position by its rotor alone.
    if (term == ForceTerm::position &&
        !std::ranges::all_of(data_.records(), &ForceRecord::rotor_known)) {
      return;
    }
    std::vector<double> values;
    values.reserve(parameters.size());
    for (const Estimate& parameter : parameters) {
      values.push_back(parameter.value);
    }
    if (auto extension = written_term(term, values, data_.scales())) {
      findings.extensions.push_back(*std::move(extension));
    }
  }

  static double density(double rmse_N) {
    return -std::log(rmse_N) - std::log(2 * std::numbers::pi) / 2 - 0.5;
  }

  [[nodiscard]] std::vector<Step> steps() const {
    std::vector<Step> steps;
    const std::vector<Search::Candidate> stairs = search_.stairs();
    for (std::size_t i = 0; i < stairs.size(); ++i) {
      const double rmse_N = data_.rmse_N(stairs[i].held_N2);
      Step step{.effect = {},
                .output_rmse_N = output_rmse_N(data_, stairs[i].fit),
                .input_rmse_N = rmse_N,
                .log_predictive_density = density(rmse_N),
                .sessions = static_cast<int>(data_.records().size())};
      if (i > 0) {
        const std::vector<double>& before_N2 = stairs[i - 1].held_N2;
        step.effect = effect_of(stairs[i].fit.terms.back(), stairs[i].fit);
        step.effect.probability =
            probability_of(paired_gain(before_N2, stairs[i].held_N2), data_.records().size());
        for (std::size_t j = 0; j < before_N2.size(); ++j) {
          step.sessions_better += stairs[i].held_N2[j] < before_N2[j] ? 1 : 0;
        }
      }
      steps.push_back(std::move(step));
    }
    return steps;
  }

  [[nodiscard]] HeldOutGain gain() const {
    if (search_.judged().empty() || few()) {
      return {};
    }
    const double before = search_.nominal_rmse_N();
    const double after = search_.rmse_N();
    return {.held_out_by = "session",
            .metrics = {{"rmse_N", output_rmse_N(data_, search_.nominal()),
                         output_rmse_N(data_, search_.model())},
                        {"input_rmse_N", before, after},
                        {"log_predictive_density", density(before), density(after)}}};
  }

  void add_refitted(TensionDiagnosis& diagnosis) const {
    const ForceFit& model = search_.model();
    const std::vector<double> half = data_.half_widths(model);
    const double gain = model.parameters[0];
    const double friction = model.parameters[1];
    diagnosis.findings.refitted = {
        {"friction_coefficient", "1", friction, friction - half[1], friction + half[1]},
        {"log_gain", "1", -std::log(gain), -std::log(gain) - half[0] / gain,
         -std::log(gain) + half[0] / gain}};
    diagnosis.friction_coefficient =
        written_friction(friction, diagnosis.findings.extensions, data_.scales());
    diagnosis.log_gain = -std::log(gain);
  }

  [[nodiscard]] std::string sentences(const Findings& findings) const {
    std::vector<std::string_view> ids;
    for (const FoundEffect& effect : findings.effects) {
      ids.emplace_back(effect.id);
    }
    const std::string most =
        fmt::format("What is left shows most against {} (p = {:.3f}).", left_.covariate, left_.p);
    const std::string few_sessions =
        few() ? fmt::format(" {} of 4 sessions that it takes to name anything.",
                            data_.records().size())
              : "";
    std::string text;
    if (ids.empty()) {
      text =
          findings.verdict == Verdict::none
              ? "In newtons, no effect of the catalogue gains on sessions that the fit never saw."
              : "No effect of the catalogue explains what the recordings hold. " + most;
      return text + few_sessions + doubts();
    }
    text = fmt::format(
        "{}: with {} the error of the input force on sessions that the fit never saw is {:.3g} N "
        "in place of {:.3g} N. {}",
        fmt::join(ids, " and "), ids.size() > 1 ? "them" : "it", search_.rmse_N(),
        search_.nominal_rmse_N(), most);
    for (const auto& same : findings.equivalent_sets) {
      text += fmt::format(" In place of {} it may be {}.", same.front(),
                          fmt::join(same.begin() + 1, same.end(), " or "));
    }
    return text + doubts();
  }

  /// What a user may have got wrong before any physics does.
  [[nodiscard]] std::string doubts() const {
    constexpr double kLogGain = 0.3;
    constexpr double kTimesNominal = 3;
    const ForceFit& model = search_.model();
    std::string text;
    if (std::abs(std::log(model.parameters[0])) > kLogGain) {
      text += fmt::format(
          " The input force is {:.3g} times what the model has: are its unit, the "
          "radius and the torque constant right?",
          model.parameters[0]);
    }
    if (nominal_.sheath &&
        model.parameters[1] > kTimesNominal * nominal_.sheath->friction_coefficient) {
      text +=
          fmt::format(" Friction is {:.3g} times the nominal one: are bend angle and units right?",
                      model.parameters[1] / nominal_.sheath->friction_coefficient);
    }
    double product = 0;
    double moved_square = 0;
    double square = 0;
    for (const ForceRecord& record : data_.records()) {
      for (std::size_t i = 1; i < record.samples(); ++i) {
        const double moved_m = record.position_m[i] - record.position_m[i - 1];
        const double expected_m = (record.velocity_m_s[i] + record.velocity_m_s[i - 1]) / 2 *
                                  (record.time_s[i] - record.time_s[i - 1]);
        product += moved_m * expected_m;
        moved_square += moved_m * moved_m;
        square += expected_m * expected_m;
      }
    }
    constexpr double kOpposite = -0.5;
    constexpr double kScale = 1.3;
    const double scale = std::sqrt(moved_square / std::max(square, 1e-300));
    if (product < kOpposite * std::sqrt(moved_square * square)) {
      text += " Velocity runs against the position: one of the two has the wrong sign.";
    } else if (product > 0 && (scale > kScale || scale < 1 / kScale)) {
      text += fmt::format(
          " The position moves {:.3g} times as far as the velocity says: are their "
          "units, the radius and the ratio of the gear right?",
          scale);
    }
    return text;
  }

  [[nodiscard]] double damage_ratio() const {
    double sum = 0;
    double sessions = 0;
    std::vector<double> before;
    std::vector<double> after;
    for (const ForceRecord& record : data_.records()) {
      predict_input(record, search_.nominal().terms, data_.scales(), search_.nominal().parameters,
                    before);
      predict_input(record, search_.model().terms, data_.scales(), search_.model().parameters,
                    after);
      const double damage_before = damage_of(before, constants_);
      const double damage_after = damage_of(after, constants_);
      if (damage_before > 0 && damage_after > 0) {
        sum += std::log(damage_before / damage_after);
        sessions += 1;
      }
    }
    return sessions > 0 ? std::exp(sum / sessions) : 1;
  }

  /// The output force that each model has for the input, of the first sessions.
  void add_traces(TensionDiagnosis& diagnosis) const {
    constexpr std::size_t kTraces = 4;
    for (std::size_t j = 0; j < std::min(kTraces, data_.records().size()); ++j) {
      const ForceRecord& record = data_.records()[j];
      TracePicture trace{record.session, record.time_s, record.input_N, record.output_N, {}, {}};
      const auto output = [&](const ForceFit& model) {
        std::vector<double> output_N = record.output_N;
        const std::vector<double> residuals_N = data_.residuals_N(j, model.terms, model.parameters);
        for (std::size_t i = 0; i < output_N.size(); ++i) {
          output_N[i] += residuals_N[i] / model.parameters[0];
        }
        return output_N;
      };
      trace.before_N = output(search_.nominal());
      trace.after_N = output(search_.model());
      diagnosis.traces.push_back(std::move(trace));
    }
  }

  const ForceData& data_;
  const Search& search_;
  const NominalModel& nominal_;
  const reference::Constants& constants_;
  Left left_;
};

}  // namespace

TensionDiagnosis diagnose_forces(const std::vector<ForceRecord>& records,
                                 const NominalModel& nominal, const reference::Constants& constants,
                                 const DiagnoseOptions& options) {
  const ForceData data(records);
  Search search(data, nominal.sheath ? nominal.sheath->friction_coefficient : 0.1, options);
  search.run();
  return Report(data, search, nominal, constants, options).diagnosis();
}

}  // namespace host_sim::diagnose
