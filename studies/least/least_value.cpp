// SPDX-License-Identifier: MIT
#include "studies/least/least_value.hpp"

#include "core/text/list_text.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/limit_table.hpp"
#include "scene/written_limits.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/least/feasible_edge.hpp"
#include "studies/least/monotone.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A cap on a peak that limits nothing, by the peak of a motion from 0 to 1 over x from 0 to 1; and any other
// cap, in SI: the first solve says what its motion reaches. Far larger ones are no numbers to scale a row by.
constexpr double idle_peak = 1e4;
constexpr double idle_cap = 1e7, idle_pressure = 1e11;
// A motion that reaches v satisfies a cap of v; this much further off it does so to rounding, too.
constexpr double reached_room = 1e-6;
// Values found and proved lie up to half of the gap from the edge: nearly a quarter of it, and as much for
// rounding to a number that people can read.
constexpr double part_of_gap = 0.24;
constexpr double edge_accuracy = 1e-7;
// Of the first step: an edge this close to 0 is 0; and a value for people where a number has to be above 0.
constexpr double zero_part = 1e-6, zero_value = 1e-3;
// Where a solve at such a value does not end as the search says: this much further off, of the gap.
constexpr double beyond_gap[] = {1.0, 4.0, 16.0, 100.0, 1000.0};
// Of a gap, at least: limits are met to the tolerance of the solve.
constexpr double tolerances_of_gap = 10.0;
// Of the time: for closing in on the edge, and for the motion there; the rest is for the proof.
constexpr double search_part = 0.4, motion_part = 0.6;
// Beyond the first edge of a number that is not monotone.
constexpr int scanned_values = 8;

// The limit of a key, given or not.

/// A limit that a scene could have, under a key as written.
struct LimitKey {
    const PeakLimitRow* peak = nullptr;
    const LimitRow* row = nullptr;
    const Spelling* spelling = nullptr;

    [[nodiscard]] explicit operator bool() const { return spelling != nullptr; }
    /// It is a least value: better large.
    [[nodiscard]] bool is_least() const { return peak != nullptr ? peak->side < 0 : row->is_least(); }
};

LimitKey limit_key(const Scene& scene, std::string_view key) {
    const auto find = [&](std::string_view name, std::span<const Spelling> spellings, std::string_view side) {
        for (const Spelling& spelling : spellings)
            if (key == written_limit_key(name, spelling.suffix, side)) return &spelling;
        return static_cast<const Spelling*>(nullptr);
    };
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const Spelling* spelling = find(row.key_name, row.spellings, side_of_key(row.side)))
            return {&row, nullptr, spelling};
    const bool swings = scene.motion.lift_is_angle;
    for (const LimitRow& row : limit_rows()) {
        const bool own = swings && row.swinging.name != nullptr;
        if (const Spelling* spelling =
                find(own                   ? row.swinging.name
                     : row.side != nullptr ? row.table
                                           : row.name,
                     own ? row.swinging.spellings : row.spellings, row.side != nullptr ? row.side : ""))
            return {nullptr, &row, spelling};
    }
    return {};
}

/// A value of the limit that limits nothing, in the unit of its key.
double idle_value(const Scene& scene, const LimitKey& limit) {
    const double sign = limit.is_least() ? -1.0 : 1.0;
    if (limit.peak != nullptr)
        return sign * idle_peak * one_normalised_peak(scene.motion, limit.peak->order(), *limit.spelling);
    const Range& range = limit.row->range;
    const double end = limit.is_least() ? range.low : range.high;
    const bool is_angle = !limit.is_least() && std::isfinite(end);
    const double idle = limit.spelling->quantity.pressure != 0 ? idle_pressure : idle_cap;
    const double value = is_angle ? largest_pressure_angle : std::isfinite(end) ? end : sign * idle;
    return as_written(value / limit.spelling->factor);
}

/// Whether a limit that the scene gives of the same derivative leaves no place for it in a scene file, which
/// has one of both sides, or one of each in the same unit.
bool is_excluded(const Scene& scene, const LimitKey& limit) {
    if (limit.peak == nullptr) return false;
    return std::ranges::any_of(peak_limit_rows(), [&](const PeakLimitRow& row) {
        const auto& given = row.in(scene.limits);
        if (!given || &row == limit.peak || std::string_view(row.key_name) != limit.peak->key_name)
            return false;
        return row.side == 0 || limit.peak->side == 0 || given->unit != limit.spelling->unit;
    });
}

/// The same as a change, for a limit that the scene does not give.
Adjustment absent_limit(const Scene& scene, const std::string& key, const LimitKey& limit) {
    const double idle = idle_value(scene, limit);
    Adjustment change =
        number_adjustment(key, idle, std::abs(idle), Range{}, [key, limit](Scene& changed, double value) {
            const std::string unit(limit.spelling->unit);
            if (limit.peak != nullptr)
                limit.peak->in(changed.limits) = PeakLimit(0.0, key, value, unit);
            else
                limit.row->in(changed.limits) =
                    WrittenLimit(value * limit.spelling->factor, key, limit.spelling->factor, unit);
            changed = with_written_limits(std::move(changed));
        });
    change.limit = true;
    return change;
}

/// Where the values of a number end in the direction of the search, in the unit of its key.
double end_of(const Scene& scene, const SoughtNumber& sought) {
    const double direction = sought.largest ? 1.0 : -1.0;
    const double given = sought.change.given;
    if (!sought.change.limit) {
        const bool signed_number = sought.change.least < 0.0;
        if (sought.largest) return sought.change.most > given ? sought.change.most : infinity;
        if (signed_number) return sought.change.least < given ? sought.change.least : -infinity;
        return 0.0;
    }
    const LimitKey limit = limit_key(scene, sought.change.key);
    if (!limit || (limit.peak != nullptr && limit.peak->side != 0)) return direction * infinity;
    if (limit.peak != nullptr) return 0.0;
    return (sought.largest ? limit.row->range.high : limit.row->range.low) / limit.spelling->factor;
}

[[noreturn]] void refuse(const Scene& scene, const std::string& found) {
    const SoughtKey& sought = *scene.objective.sought;
    const bool largest = sought.largest;
    std::string keys;
    for (const Adjustment& one : adjustments(scene)) {
        const LimitKey limit = limit_key(scene, one.key);
        const std::string item = fmt::format("\"{}\"", one.key);
        const bool wanted = !limit || limit.is_least() == largest;
        if (wanted && keys.find(item) == std::string::npos) append_item(keys, item);
    }
    const LimitRow& example =
        limit_row(largest ? LimitedFigure::convex_radius : LimitedFigure::pressure_angle);
    throw SceneError(
        {sought.member(), found,
         fmt::format("a limit that is better {} (\"limits.{}\"), or one of this scene's numbers: {}",
                     largest ? "large" : "small", example.first_key(), keys)});
}

// The search.

/// A value beyond the edge in a direction, at least so far, with as few digits as twice the distance allows.
double beyond(double edge, double direction, double distance) {
    return shortest_decimal(edge + direction * distance, edge + 2.0 * direction * distance);
}

class LeastSearch {
 public:
    LeastSearch(const Scene& scene, SoughtNumber sought, const SolveControl& control,
                const PlanOptions& options)
        : asked_(scene),
          scene_(plain(scene)),
          sought_(std::move(sought)),
          direction_(sought_.largest ? 1 : -1),
          control_(control.sooner(scene.solver.max_seconds)),
          all_(control_),
          options_(options) {}

    Solution run() {
        say(fmt::format("the {} {}: searching", sought_.largest ? "largest" : "least", sought_.change.key));
        const std::optional<double> start = first_value();
        if (!start) return without_motion();
        const FeasibleEdge edge = scanned(feasible_edge(scene_, sought_.change, *start, direction_,
                                                        end_of(scene_, sought_), all_.part(search_part)));
        LeastReport report;
        report.key = sought_.change.key;
        report.largest = sought_.largest;
        Solution solution = delivered(edge, report);
        if (!solution.motion) return solution;
        prove(edge, report);
        if (report.impossible && report.limited_by.empty())  // a proof over boxes has no rows
            for (const ConstraintReport& limit : solution.constraints)
                if (limit.active) report.limited_by.push_back(limit.key);
        solution.least = std::move(report);
        return solution;
    }

 private:
    const Scene& asked_;
    Scene scene_;  ///< what is solved: it seeks nothing itself
    SoughtNumber sought_;
    int direction_;
    SolveControl control_;
    Budget all_;
    PlanOptions options_;

    [[nodiscard]] static Scene plain(Scene scene) {
        scene.objective.sought.reset();
        scene.objective.least_gap = ObjectiveSpec().least_gap;
        return scene;
    }
    void say(std::string_view message) const { all_.say(message); }
    [[nodiscard]] Scene scene_with(double value) const { return sought_.change.with(scene_, value); }
    [[nodiscard]] double size(double value) const { return std::max(std::abs(value), sought_.change.step); }
    [[nodiscard]] double gap() const { return asked_.objective.least_gap; }
    [[nodiscard]] bool is_zero(double edge) const {
        return std::abs(edge) <= zero_part * sought_.change.step;
    }
    /// Of the values found and proved from the edge, which is known to a part of the first step.
    [[nodiscard]] double distance(double edge) const {
        return std::max(part_of_gap * gap() * std::abs(edge), edge_accuracy * sought_.change.step);
    }

    /// A value with a motion: what the motion of the scene reaches, its own, or the nearest to that.
    [[nodiscard]] std::optional<double> first_value() {
        Adjustment& change = sought_.change;
        if (change.limit)
            if (const std::optional<double> reached = reached_by_a_motion()) return reached;
        const double given = violation_of_any(scene_with(change.given), all_);
        if (given <= 0.0) return change.given;
        Adjustment back = change;
        (sought_.largest ? back.may_grow : back.may_shrink) = false;
        (sought_.largest ? back.may_shrink : back.may_grow) = true;
        return nearest_value(scene_, back, given, all_.part(search_part));
    }
    /// The figure that the limit holds, of a motion that the search for one finds with a limit that holds
    /// nothing.
    [[nodiscard]] std::optional<double> reached_by_a_motion() {
        const LimitKey limit = limit_key(scene_, sought_.change.key);
        if (!limit) return std::nullopt;
        const double idle = idle_value(scene_, limit);
        const Solution first = solve_without_explaining(scene_with(idle), all_.part(search_part).control(),
                                                        nullptr, {.look = true});
        for (const ConstraintReport& one : first.constraints)
            if (first.motion && one.key == sought_.change.key && std::isfinite(one.worst)) {
                sought_.change.step = first_part_of(one.worst, limit, first.cam ? &*first.cam : nullptr);
                const double room = one.worst - direction_ * reached_room * size(one.worst);
                return sought_.largest ? std::max(room, idle) : std::min(room, idle);
            }
        return std::nullopt;
    }
    /// The first step from a figure, which may be 0: a part of it, or of the quantity itself.
    [[nodiscard]] double first_part_of(double worst, const LimitKey& limit, const CamReport* cam) const {
        const double given = std::abs(sought_.change.given);
        const bool is_angle = limit.row != nullptr && std::isfinite(limit.row->range.high);
        const double least = given > 0.0 ? std::min((is_angle ? 1e-4 : 1e-9) * given, 1.0) : 1.0;
        const double unit =
            limit.peak != nullptr
                ? std::abs(one_normalised_peak(scene_.motion, limit.peak->order(), *limit.spelling))
                : quantity_size(scene_, cam, *limit.row) / limit.spelling->factor;
        return first_change * std::max({std::abs(worst), unit, least});
    }

    /// Of a number that is not monotone: whether values beyond the edge have motions again.
    [[nodiscard]] FeasibleEdge scanned(FeasibleEdge edge) const {
        if (sought_.monotone || !edge.outside) return edge;
        const double end = end_of(scene_, sought_);
        double step = first_change * size(edge.inside);
        for (int k = 0; k < scanned_values && !all_.spent(); ++k, step *= 2.0) {
            const double value = edge.inside + direction_ * step;
            if (direction_ * (value - end) >= 0.0) break;
            if (violation_of_any(scene_with(value), all_) > 0.0) continue;
            return scanned(
                feasible_edge(scene_, sought_.change, value, direction_, end, all_.part(search_part)));
        }
        return edge;
    }

    /// The scene without a value, or with one that limits nothing: why it has no motion.
    [[nodiscard]] Solution without_motion() const {
        Scene loose = scene_;
        if (sought_.change.limit) loose = scene_with(sought_.change.given);
        Solution solution = solve_without_explaining(loose, control_, nullptr, options_);
        solution.notes.push_back(
            fmt::format("no value of {} was found for which the scene has a motion", sought_.change.key));
        return take_back(std::move(solution));
    }
    [[nodiscard]] Solution take_back(Solution solution) const {
        solution.scene.objective.sought = asked_.objective.sought;
        solution.scene.objective.least_gap = asked_.objective.least_gap;
        return solution;
    }

    /// The motion at the edge: the best one by the weights.
    [[nodiscard]] Solution delivered(const FeasibleEdge& edge, LeastReport& report) const {
        std::vector<double> values;
        if (is_zero(edge.inside)) {
            if (!find_fault(scene_with(0.0))) values.push_back(0.0);
            const double least = zero_value * sought_.change.step;
            values.push_back(-direction_ * shortest_decimal(least, 2.0 * least));
        }
        for (const double further : beyond_gap)
            values.push_back(edge.outside ? beyond(edge.inside, -direction_, distance(edge.inside) * further)
                                          : edge.inside);
        Solution best;
        for (const double value : values) {
            report.value = value;
            say(fmt::format("{} = {:g}: solving", report.key, report.value));
            best = solve_without_explaining(scene_with(report.value), all_.part(motion_part).control(),
                                            nullptr, {.look = options_.look, .explain = options_.explain});
            if (best.motion || all_.spent()) break;
        }
        return take_back(std::move(best));
    }

    /// The nearest value without a motion that a solve proves.
    void prove(const FeasibleEdge& edge, LeastReport& report) const {
        const double away = distance(edge.inside);
        const bool at_end =
            edge.at_end || (edge.outside && find_fault(scene_with(beyond(edge.inside, direction_, away))));
        if (at_end && sought_.monotone)  // no scene has a value beyond the end
            report.verdict =
                is_zero(edge.inside) && report.value != 0.0 ? Verdict::feasible : Verdict::optimal;
        if (!edge.outside || at_end || options_.look) return;
        for (const double further : beyond_gap) {
            const double value = beyond(edge.inside, direction_, away * further);
            const Scene scene = scene_with(value);
            if (all_.spent() || find_fault(scene)) return;
            say(fmt::format("{} = {:g}: proving that no motion exists", report.key, value));
            Solution none = solve_without_explaining(scene, all_.control());
            if (none.certificate.verdict != Verdict::infeasible) continue;
            report.impossible = value;
            for (const ConflictReport& row : none.conflict)
                if (std::ranges::find(report.limited_by, row.key) == report.limited_by.end())
                    report.limited_by.push_back(row.key);
            report.proof = std::make_shared<const Solution>(std::move(none));
            const bool close =
                std::abs(report.value - value) <= gap() * std::abs(report.value) * (1.0 + 1e-12);
            if (sought_.monotone) report.verdict = close ? Verdict::optimal : Verdict::feasible;
            return;
        }
    }
};

}  // namespace

std::optional<SoughtNumber> sought_number(const Scene& scene) {
    const ObjectiveSpec& objective = scene.objective;
    if (!objective.sought) return std::nullopt;
    if (objective.least_gap < tolerances_of_gap * scene.solver.tolerance)
        throw SceneError(
            {"objective.least_gap",
             fmt::format("{:g} with solver.tolerance = {:g}", objective.least_gap, scene.solver.tolerance),
             fmt::format("{:g} or more: a limit is met to the tolerance, and the two values have to differ "
                         "by more",
                         tolerances_of_gap * scene.solver.tolerance)});
    const auto& [key, largest] = *objective.sought;
    SoughtNumber sought;
    sought.largest = largest;
    const LimitKey limit = limit_key(scene, key);
    if (limit && limit.is_least() != largest)
        refuse(scene, fmt::format("\"{}\", a {}", key, limit.is_least() ? "least value" : "largest value"));
    const std::vector<Adjustment> all = adjustments(scene);
    if (const auto own = std::ranges::find(all, key, &Adjustment::key); own != all.end()) {
        sought.change = *own;
    } else if (limit && is_excluded(scene, limit)) {
        refuse(scene, fmt::format("\"{}\", together with another limit of this derivative", key));
    } else if (limit) {
        const Adjustment absent = absent_limit(scene, key, limit);
        if (const auto fault = find_fault(absent.with(scene, absent.given)))
            refuse(scene, fmt::format("\"{}\", which this scene cannot have ({}: found {}; allowed: {})", key,
                                      fault->member, fault->found, fault->allowed));
        sought.change = absent;
    } else {
        refuse(scene, fmt::format("\"{}\"", key));
    }
    const Tightens direction = largest ? Tightens::upward : Tightens::downward;
    sought.monotone = sought.change.limit || tightening_of(scene, key) == direction;
    return sought;
}

void refuse_sought_number(const Scene& scene, std::string_view study) {
    const std::optional<SoughtKey>& sought = scene.objective.sought;
    if (!sought) return;
    throw InputError(
        fmt::format("{}: found {} = \"{}\"; allowed: a scene that seeks no number: solve it first, and take "
                    "scene.toml of its result without that key",
                    study, sought->member(), sought->key));
}

Solution solve_asked(const Scene& scene, const SolveControl& control, KnownSolutions* known,
                     const PlanOptions& options) {
    if (!scene.objective.sought) return solve_without_explaining(scene, control, known, options);
    const Scene complete = valid_scene(scene);
    if (known != nullptr) known->optima.withdraw();
    return LeastSearch(complete, *sought_number(complete), control, options).run();
}

}  // namespace camopt
