// SPDX-License-Identifier: MIT
// The hard limits, one row a limit: how a scene file writes it, what it holds on to, where it may lie, what
// it needs.
//
// Reader, checks, relaxations, reports, charts and words iterate over the rows or ask for the limit on a
// figure; only the row knows which member of LimitSpec it is. What keeps a limit is its rule, in
// objectives/rules.
#pragma once

#include "scene/cost_table.hpp"
#include "scene/key_row.hpp"

namespace camopt {

/// A cap on a peak of the motion, or on one side of a derivative, normalised or in time.
struct PeakLimitRow {
    CostFigure figure;                    ///< the peak
    const char* key_name;                 ///< of the key limits.KEY_NAME: "velocity", "cam_velocity"
    std::span<const Spelling> spellings;  ///< the first one is normalised
    std::optional<PeakLimit> LimitSpec::*limit;
    const char* meaning = "";                            ///< of the key; of both sides
    std::span<const std::string_view> also_called = {};  ///< what other programs call it
    int side = 0;                                        ///< 0: |y^{(r)}| <=; 1: y^{(r)} <=; −1: y^{(r)} >=
    const char* sided_name = nullptr;                    ///< "velocity_min"; null of both sides
    /// Of the cam's own motion where that of the output is prescribed (DynamicsSpec::prescribes_output).
    bool of_cam = false;

    [[nodiscard]] const char* name() const { return side == 0 ? key_name : sided_name; }
    /// Held by the peak of the objective; others are bounds of their own (objectives/motion_bounds.hpp).
    [[nodiscard]] bool on_peak() const { return side == 0 && !of_cam; }
    /// Of the derivative: 1 velocity, 2 acceleration, 3 jerk.
    [[nodiscard]] int order() const { return cost_term(figure).measured.order; }
    [[nodiscard]] std::optional<PeakLimit>& in(LimitSpec& limits) const { return limits.*limit; }
    [[nodiscard]] const std::optional<PeakLimit>& in(const LimitSpec& limits) const { return limits.*limit; }
};

/// Of the motion: those of both sides by order, then those of one side; then the cam's in the same order.
[[nodiscard]] std::span<const PeakLimitRow> peak_limit_rows();

/// What is limited, for people: in tables, charts and the studio.
namespace figure_words {
inline constexpr const char *pressure_angle = "largest pressure angle",
                            *rise_pressure_angle = "largest pressure angle of the rise",
                            *return_pressure_angle = "largest pressure angle of the return",
                            *convex_radius = "least convex radius of the cam",
                            *concave_radius = "least concave radius of the cam",
                            *regularity = "least undercut margin", *torque = "largest camshaft torque",
                            *hertz_pressure = "largest Hertz pressure";
}  // namespace figure_words

struct LimitRow {
    enum class Sense { most, least };
    enum class Cams { any, planar, disk };  ///< which can have it
    /// What a violation is measured by, and a limit that may be 0: itself, the cam's base radius, one, or the
    /// largest force.
    enum class Size { itself, base_radius, one, largest_force };
    /// Under this name and in these units where the follower swings.
    struct Swinging {
        const char* name = nullptr;  ///< null: as otherwise
        std::span<const Spelling> spellings = {};
        const char* meaning = nullptr;
    };
    struct Refusal {
        std::optional<ContactKind> contact = {};  ///< none: every follower may have it
        const char* found = nullptr;              ///< before: for the follower "…"
        const char* allowed = nullptr;
    };

    LimitedFigure figure;
    const char* name;  ///< key without its unit, name in reports
    std::optional<WrittenLimit> LimitSpec::*limit;
    std::span<const Spelling> spellings;
    Sense sense;
    Range range;  ///< SI, rad
    Cams cams = Cams::any;
    bool needs_forces = false;  ///< and with them a speed
    bool needs_contact_width = false;
    bool needs_dynamics = false;   ///< of the elastic follower train: needs no cam
    bool needs_drive = false;      ///< of the motor: needs no cam
    const char* side = nullptr;    ///< "min", "max": written in a table in the place of the number of `table`
    const char* table = nullptr;   ///< "motor_torque"
    bool needs_contact = false;    ///< a figure without a value where the follower cannot touch the cam
    bool may_be_infinite = false;  ///< an infinite figure is one
    Size size = Size::itself;
    Refusal refusal = {};
    const char* default_text = "none";
    const char* meaning = nullptr;  ///< of the key limits.NAME
    const char* words = nullptr;    ///< null: they follow from the name
    Swinging swinging = {};
    std::span<const std::string_view> also_called = {};

    [[nodiscard]] std::optional<WrittenLimit>& in(LimitSpec& limits) const { return limits.*limit; }
    [[nodiscard]] const std::optional<WrittenLimit>& in(const LimitSpec& limits) const {
        return limits.*limit;
    }
    [[nodiscard]] bool is_least() const { return sense == Sense::least; }
    [[nodiscard]] bool of_cam() const { return !needs_dynamics && !needs_drive; }
    /// Its key with the unit the manual shows: "pressure_angle_deg".
    [[nodiscard]] std::string first_key() const;
};

/// Every limit of a cam or of an elastic follower train, by LimitedFigure.
[[nodiscard]] std::span<const LimitRow> limit_rows();
[[nodiscard]] const LimitRow& limit_row(LimitedFigure figure);
/// The scene's limit on this figure.
[[nodiscard]] const std::optional<WrittenLimit>& limit_on(const LimitSpec& limits, LimitedFigure figure);
/// The row whose name, or swinging name, this is; null where none is.
[[nodiscard]] const LimitRow* limit_named(std::string_view name);
/// The name of the row that a written key belongs to: "limits.pressure_angle_deg" → "pressure_angle"; null
/// where it belongs to none.
[[nodiscard]] const char* limit_name_in(std::string_view key);
/// A limit of this name, of the cam or of the motion, is a least value.
[[nodiscard]] bool is_least_limit(std::string_view name);

[[nodiscard]] bool limits_cam(const LimitSpec& limits);     ///< any of the cam
[[nodiscard]] bool limits_forces(const LimitSpec& limits);  ///< any that needs forces
[[nodiscard]] bool limits_spring(
    const LimitSpec& limits);  ///< of these any that preload and spring rate change

}  // namespace camopt
