// SPDX-License-Identifier: MIT
//
// The cost terms of a motion, one row per term:
//
//   f = Σ weight · figure / reference,   the figure one of core/motion.hpp, normalised.
//
// Reader, validation, model, files, charts and words iterate over the rows. The dimensions of the cam, which
// may have weights too, are listed by DimensionIndex (scene/cam_spec.hpp).
#pragma once

#include "scene/scene.hpp"

namespace camopt {

/// The figures of a motion in an objective, in the order of the rows and of the columns.
enum class CostFigure { velocity, acceleration, jerk, torque, rms_acceleration, rms_jerk };
inline constexpr int cost_figure_count = 6;

struct CostTerm {
    /// peak: of a derivative, by two epigraph rules. torque: of y'·y''. rms: by its energy.
    enum class Kind { peak, torque, rms };

    CostFigure figure{};
    Kind kind{};
    PeakFigure measured{};  ///< the member of Peaks; its name is the term's
    const char* symbol{};   ///< in formulas and tables: "V", "rms A"
    double ObjectiveSpec::*weight{};
    std::optional<double> Reference::*reference{};
    std::optional<PeakLimit> LimitSpec::*limit{};  ///< null: it cannot be limited
    double typical{};                 ///< of good motions, to a factor of ten: of the modified sine
    bool traded{};                    ///< a front can trade it against another
    const char* weight_meaning{};     ///< of the key objective.NAME
    const char* reference_meaning{};  ///< of the key objective.reference.NAME

    /// "velocity": the key below [objective] and [objective.reference], the column, the word in JSON.
    [[nodiscard]] const char* name() const { return measured.name.data(); }
    [[nodiscard]] double weight_in(const ObjectiveSpec& objective) const { return objective.*weight; }
};

/// Figures of the whole motion in addition to its peaks: responses of the elastic follower train, the lost
/// area, and the torque of the motor.
enum class ResponseFigure {
    residual,
    dynamic_acceleration,
    lost_area,
    motor_torque,
    motor_torque_rms,
    deviation,
    deviation_rms
};

/// A term that is a rule of the whole motion. Its figure is not a member of Peaks: it depends on a train and
/// a speed, or on all strokes together.
struct ResponseTerm {
    ResponseFigure figure{};
    const char* name{};    ///< "residual": the key below [objective] and [objective.reference]
    const char* symbol{};  ///< in formulas and tables
    double ObjectiveSpec::*weight{};
    std::optional<double> Reference::*reference{};
    const char* weight_meaning{};
    const char* reference_meaning{};

    [[nodiscard]] double weight_in(const ObjectiveSpec& objective) const { return objective.*weight; }
    [[nodiscard]] bool needs_dynamics() const {
        return figure == ResponseFigure::residual || figure == ResponseFigure::dynamic_acceleration;
    }
    [[nodiscard]] bool needs_drive() const {
        return figure == ResponseFigure::motor_torque || figure == ResponseFigure::motor_torque_rms;
    }
    [[nodiscard]] bool needs_measured() const {
        return figure == ResponseFigure::deviation || figure == ResponseFigure::deviation_rms;
    }
};
[[nodiscard]] std::span<const ResponseTerm> response_terms();
/// Whether any of those that need dynamics has a weight.
[[nodiscard]] bool weighs_response(const ObjectiveSpec& objective);

/// Every term, by CostFigure.
[[nodiscard]] std::span<const CostTerm> cost_terms();
[[nodiscard]] const CostTerm& cost_term(CostFigure figure);
[[nodiscard]] const char* name_of(CostFigure figure);
/// Of every term, in order.
[[nodiscard]] std::vector<std::string> cost_term_names();
/// Whether any term of this kind has a weight.
[[nodiscard]] bool weighs_any(const ObjectiveSpec& objective, CostTerm::Kind kind);
/// A bound that holds without a proof: only a lost area may be negative.
[[nodiscard]] double least_objective(const ObjectiveSpec& objective);

/// The same scene but for the weights of its peaks (V, A, J, torque). Never where a program brought rules of
/// its own, which cannot be compared.
[[nodiscard]] bool differ_in_peak_weights_only(const Scene& one, const Scene& other);
/// The same peaks have a weight > 0.
[[nodiscard]] bool weigh_same_peaks(const ObjectiveSpec& one, const ObjectiveSpec& other);

/// Allowed values of objective.tie_break.
inline constexpr std::array<TieBreak, 2> tie_breaks = {TieBreak::rms_jerk, TieBreak::none};

}  // namespace camopt
