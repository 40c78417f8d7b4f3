#include "host_sim/diagnose/lives/audit.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace host_sim::diagnose::lives {
namespace {

/// Orthonormal base of the columns; those that depend on others to rounding add nothing.
Eigen::MatrixXd base_of(const Eigen::MatrixXd& columns) {
  constexpr double kRounding = 1e-9;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(kRounding);
  const Eigen::Index rank = qr.rank();
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), rank);
}

/// What is left of an effect: one matrix for each shape, of one column, or of one for each draw
/// that specimens share.
struct View {
  std::vector<Eigen::MatrixXd> shapes;
  double largest = 0;  ///< of its first parameter
};

class Auditor {
 public:
  Auditor(const LifeSample& sample, const std::vector<Campaign::Specimen>& specimens,
          const NominalFit& nominal)
      : baseline_{sample.ultimate_tension_N,
                  std::exp(nominal.ln_life_at_centre + nominal.exponent * nominal.centre_ln_N),
                  nominal.exponent},
        covariates_(effects::life_covariates_of(specimens, baseline_)),
        projection_(vector_of(covariates_.log_effective_N), weights_of(sample, nominal)) {}

  LifeEffectAudit audit(const effects::LifeEffect& effect) {
    LifeEffectAudit result{.effect = &effect, .why = effect.missing(covariates_)};
    View view;
    if (result.visible()) {
      view = view_of(effect, result);
      if (result.share < LifeAudit::kLeastShare) {
        result.why =
            fmt::format("its signature vanishes once A and gamma are refitted{}", advice(effect));
      } else if (result.sigmas < LifeAudit::kLeastSigmas) {
        result.why =
            fmt::format("too weak here: {:.1f} standard deviations at the bounds of physics{}",
                        result.sigmas, advice(effect));
      }
    }
    views_.push_back(std::move(view));
    return result;
  }

  /// The worst case over the shapes, the smaller of both ways.
  [[nodiscard]] double likeness(std::size_t one, std::size_t other) const {
    return std::min(imitation(views_[one], views_[other]), imitation(views_[other], views_[one]));
  }

 private:
  static Eigen::VectorXd vector_of(const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  }

  static Eigen::VectorXd weights_of(const LifeSample& sample, const NominalFit& nominal) {
    Eigen::VectorXd weights(static_cast<Eigen::Index>(sample.size()));
    for (std::size_t i = 0; i < sample.size(); ++i) {
      const LifeSample::Specimen& specimen = sample.specimens[i];
      double damage = 0;
      for (const LifeSample::Block& block : specimen.blocks) {
        damage += block.cycles *
                  std::exp(-nominal.ln_life_at_centre +
                           nominal.exponent * (std::log(block.effective_N) - nominal.centre_ln_N));
      }
      const double expected = specimen.failed ? 1 : -std::expm1(-std::pow(damage, nominal.shape));
      weights[static_cast<Eigen::Index>(i)] = nominal.shape * nominal.shape * expected;
    }
    return weights;
  }

  [[nodiscard]] Eigen::MatrixXd indicators(const std::vector<std::size_t>& shared_by) const {
    const std::size_t draws = std::ranges::max(shared_by) + 1;
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(shared_by.size()),
                                                    static_cast<Eigen::Index>(draws));
    for (std::size_t i = 0; i < shared_by.size(); ++i) {
      columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(shared_by[i])) = 1;
    }
    return columns;
  }

  View view_of(const effects::LifeEffect& effect, LifeEffectAudit& result) const {
    View view{{}, effect.parameters().front().maximum};
    constexpr double kRounding = 1e-9;
    const double least =
        kRounding *
        projection_.scaled(Eigen::VectorXd::Ones(vector_of(covariates_.log_effective_N).size()))
            .norm();
    for (const std::vector<double>& shape : effect.shapes()) {
      const effects::Signature signature = effect.signature(covariates_, baseline_, shape);
      const Eigen::MatrixXd columns =
          signature.columns.empty()
              ? indicators(effect.scatter(covariates_, baseline_, shape).shared_by)
              : Eigen::MatrixXd(vector_of(signature.columns.front()));
      const Eigen::MatrixXd left = projection_.left(columns);
      const double all = projection_.scaled(columns).norm();
      // A and gamma take what an effect does to the mean, not what it does to the scatter.
      const double shown = effect.kind() == effects::LifeEffectKind::both ? all : left.norm();
      result.share = std::max(result.share, all > least ? shown / all : 0);
      const double draws = static_cast<double>(std::max<Eigen::Index>(1, columns.cols() - 1));
      result.sigmas = std::max(result.sigmas, view.largest * shown / std::sqrt(draws));
      view.shapes.push_back(left.norm() > least ? left : Eigen::MatrixXd::Zero(left.rows(), 1));
    }
    return view;
  }

  static double imitation(const View& one, const View& other) {
    double largest = 0;
    for (const Eigen::MatrixXd& columns : one.shapes) {
      if (columns.cols() == 1) {
        for (const Eigen::MatrixXd& others : other.shapes) {
          largest = std::max(largest, imitated(columns.col(0), others));
        }
      } else {
        largest = 1;  // Draws are free: what they can show is asked of the other.
      }
    }
    return largest;
  }

  static std::string advice(const effects::LifeEffect& effect) {
    return effect.separations().empty()
               ? ""
               : fmt::format("; {}", effect.separations().front().experiment);
  }

  effects::LifeBaseline baseline_;
  effects::LifeCovariates covariates_;
  LifeProjection projection_;
  std::vector<View> views_;
};

/// Connected by pairs.
std::vector<std::vector<std::string>> classes_of(const std::vector<LifeEffectAudit>& effects,
                                                 const Auditor& auditor) {
  std::vector<std::size_t> class_of(effects.size());
  for (std::size_t i = 0; i < effects.size(); ++i) {
    class_of[i] = i;
  }
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (std::size_t j = i + 1; j < effects.size(); ++j) {
      if (effects[i].visible() && effects[j].visible() &&
          auditor.likeness(i, j) > LifeAudit::kSameCosine) {
        std::ranges::replace(class_of, class_of[j], class_of[i]);
      }
    }
  }
  std::vector<std::vector<std::string>> classes;
  for (std::size_t c = 0; c < effects.size(); ++c) {
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (class_of[i] == c && effects[i].visible()) {
        ids.emplace_back(effects[i].effect->id());
      }
    }
    if (ids.size() > 1) {
      classes.push_back(std::move(ids));
    }
  }
  return classes;
}

}  // namespace

LifeProjection::LifeProjection(const Eigen::VectorXd& ln_tension, const Eigen::VectorXd& weights)
    : roots_(weights.cwiseSqrt()) {
  Eigen::MatrixXd law(ln_tension.size(), 2);
  law.col(0).setOnes();
  law.col(1) = ln_tension.array() - ln_tension.mean();
  base_ = base_of(scaled(law));
}

Eigen::MatrixXd LifeProjection::scaled(const Eigen::MatrixXd& columns) const {
  return roots_.asDiagonal() * columns;
}

Eigen::MatrixXd LifeProjection::left(const Eigen::MatrixXd& columns) const {
  const Eigen::MatrixXd all = scaled(columns);
  return all - base_ * (base_.transpose() * all);
}

double imitated(const Eigen::VectorXd& column, const Eigen::MatrixXd& others) {
  constexpr double kNothing = 1e-12;
  if (column.norm() < kNothing || others.norm() < kNothing) {
    return 0;
  }
  const Eigen::MatrixXd base = base_of(others);
  return (base.transpose() * column).norm() / column.norm();
}

std::vector<std::string> LifeAudit::visible() const {
  std::vector<std::string> ids;
  for (const LifeEffectAudit& effect : effects) {
    if (effect.visible()) {
      ids.emplace_back(effect.effect->id());
    }
  }
  return ids;
}

LifeAudit audit_lives(const LifeSample& sample, const std::vector<Campaign::Specimen>& specimens,
                      const NominalFit& nominal, std::span<const std::string> without) {
  Auditor auditor(sample, specimens, nominal);
  LifeAudit audit;
  for (const auto& effect : effects::life_effects()) {
    if (std::ranges::find(without, effect->id()) == without.end()) {
      audit.effects.push_back(auditor.audit(*effect));
    }
  }
  audit.equivalent = classes_of(audit.effects, auditor);
  return audit;
}

}  // namespace host_sim::diagnose::lives
