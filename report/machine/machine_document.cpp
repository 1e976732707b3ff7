// SPDX-License-Identifier: MIT
#include "report/machine/machine_document.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "report/view/key_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int steps = 720;  // of one revolution: every half degree
constexpr int table_digits = 5, speed_digits = 7, objective_digits = 9;

using Kind = Sentence::Kind;

const AxisSpec& axis_of(const MachineSolution& solution, std::size_t index) {
    return solution.spec.axes[index];
}

/// The displacement of an axis at an angle of the master, SI; of one that advances over the whole turn.
class AxisAlong {
 public:
    explicit AxisAlong(const Solution& axis) : turn_(axis.master_turn()), scene_(axis.scene) {}

    [[nodiscard]] double at(double master) const {
        const double x = turn_.begin() + master / scene_.motion.unit_angle();
        return scene_.motion.lift * turn_.at(std::min(x, turn_.end())).derivative[0];
    }

 private:
    MotionChain turn_;
    const Scene& scene_;
};

std::vector<AxisAlong> axes_along(const MachineSolution& solution) {
    std::vector<AxisAlong> all;
    for (const Solution& axis : solution.axes) all.emplace_back(axis);
    return all;
}

Curve axis_curve(const MachineSolution& solution, std::size_t index, const AxisAlong& along,
                 const std::vector<double>& angles) {
    const Solution& axis = solution.axes[index];
    const MotionUnit unit = shown_units(axis.scene).motion[0].first;
    const AxisSpec& spec = axis_of(solution, index);
    const double size = axis.scene.motion.lift / unit.per_normalised;
    Curve curve{"axis_" + spec.name, "Axes over one revolution of the master", printable(spec.name), "s",
                ShownUnit{unit.name, size, unit.suffix}};
    if (spec.phase != 0.0)
        curve.title += fmt::format(", phase {} deg", short_text(degrees_shown.of(spec.phase)));
    for (const double angle : angles) curve.values.push_back(along.at(angle * units::degree) / size);
    return curve;
}

/// As its bound is written.
ShownUnit shown_unit(const Clearance& spec) {
    const Spelling* const written = unit_of_key(spec.key);
    return ShownUnit(spec.unit, spec.unit_value, written ? std::string(written->suffix) : std::string());
}

Curve clearance_curve(const MachineSolution& solution, std::size_t index, const std::vector<AxisAlong>& along,
                      const std::vector<double>& angles) {
    const Clearance& spec = solution.spec.clearances[index];
    std::string names;
    for (std::size_t k = 0; k < spec.axes.size(); ++k) {
        const double factor = std::abs(spec.factors[k]);
        const char* const sign = spec.factors[k] < 0.0 ? (k == 0 ? "− " : " − ") : k == 0 ? "" : " + ";
        names += fmt::format("{}{}{}", sign, factor == 1.0 ? "" : short_text(factor) + " · ",
                             printable(axis_of(solution, static_cast<std::size_t>(spec.axes[k])).name));
    }
    Curve curve{fmt::format("clearance_{}", index), "Clearances", "Clearance: " + names, "c",
                shown_unit(spec)};
    for (const double angle : angles) {
        double sum = 0.0;
        for (std::size_t k = 0; k < spec.axes.size(); ++k)
            sum += spec.factors[k] * along[spec.axes[k]].at(angle * units::degree);
        curve.values.push_back(sum / spec.unit_value);
    }
    const double at = spec.at_least / spec.unit_value;
    const double from = degrees_shown.of(spec.from), to = degrees_shown.of(spec.to);
    const auto add = [&](double begin, double end) {
        curve.limits.push_back(
            {begin, end, at, -1, fmt::format("at least {} {}", short_text(at), spec.unit)});
    };
    if (from < to) {
        add(from, to);
    } else {
        add(from, angles.back());
        add(angles.front(), to);
    }
    const Extremum& closest = solution.clearances[index];
    const double value = (spec.at_least + closest.value) / spec.unit_value;
    double place = std::fmod(degrees_shown.of(closest.at), 360.0);
    if (place < 0.0) place += 360.0;
    curve.marks.push_back({place, value, fmt::format("closest: {} {}", short_text(value), spec.unit)});
    return curve;
}

Curves timing_curves(const MachineSolution& solution) {
    Curves curves;
    curves.key = "timing";
    curves.caption = "Timing diagram and clearances over one revolution of the master";
    curves.angle_key = "master";
    curves.angle_title = "angle of the master";
    if (solution.axes.empty()) return curves;
    for (int i = 0; i <= steps; ++i) curves.angles.push_back(360.0 * i / steps);
    const std::vector<AxisAlong> along = axes_along(solution);
    for (std::size_t a = 0; a < along.size(); ++a)
        curves.curves.push_back(axis_curve(solution, a, along[a], curves.angles));
    for (std::size_t c = 0; c < solution.clearances.size(); ++c)
        curves.curves.push_back(clearance_curve(solution, c, along, curves.angles));
    return curves;
}

/// The limits that are active, and where, by the master's angle.
std::string active_words(const Solution& axis, double phase) {
    std::string active;
    for (const ConstraintReport& limit : axis.constraints) {
        if (!limit.active) continue;
        const double at =
            std::fmod(phase + units::turn + limit.at * axis.scene.motion.unit_angle(), units::turn);
        append_item(active, fmt::format("{} at {}", key_words(limit.key).words,
                                        degrees_shown.text(at, table_digits)));
    }
    return active;
}

Table axis_table(const MachineSolution& solution) {
    Table table{"axes",
                "Axes",
                {{.key = "axis", .left = true},
                 {"phase", {}, degrees_shown},
                 {"objective"},
                 {"velocity"},
                 {"acceleration"},
                 {"jerk"},
                 {"motor_torque"},
                 {"rms_torque"},
                 {"motor_speed"},
                 {.key = "active_limits", .left = true}},
                {},
                "Largest magnitudes at this speed; each axis has its own folder."};
    for (std::size_t a = 0; a < solution.axes.size(); ++a) {
        const Solution& axis = solution.axes[a];
        const ShownUnits shown = shown_units(axis.scene);
        std::vector<Cell> row = {Cell(printable(axis_of(solution, a).name)), Cell(axis_of(solution, a).phase),
                                 Cell(axis.certificate.objective)};
        std::size_t order = 1;
        for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk}) {
            const MotionUnit& unit = shown.motion[order++].first;
            row.push_back(motion_cell(unit, (axis.motion_peaks.*peak).value, table_digits));
        }
        const auto of_motor = [&](const ShownUnit& unit, const std::function<double()>& value) {
            row.emplace_back(axis.drive ? std::optional(value()) : std::nullopt, unit, table_digits);
        };
        of_motor(shown.torque, [&] { return axis.drive->torque.value; });
        of_motor(shown.torque, [&] { return axis.drive->rms_torque; });
        of_motor(rpm_shown, [&] { return axis.drive->speed.value; });
        row.emplace_back(active_words(axis, axis_of(solution, a).phase));
        table.rows.push_back(std::move(row));
        table.folders.push_back(axis_of(solution, a).name);
    }
    return table;
}

Table stopping_table(const MachineSolution& solution) {
    const ShownUnit percent("%", 0.01, "_percent");
    Table table{"stops",
                "What stops the machine",
                {{.key = "limit", .title = "what stops it", .left = true},
                 {"at", "at (deg)", degrees_shown},
                 {"share", "share of the proof", percent},
                 {"given"},
                 {"needed", "alone enough for 5 % more speed"}},
                {},
                "Shares of the multipliers of the proof at the speed above; the last column changes this one "
                "number alone."};
    for (const MachineLimit& limit : solution.limited_by) {
        const ShownUnit unit(unit_words(limit.unit));
        const std::string axis =
            limit.axis >= 0 ? printable(axis_of(solution, static_cast<std::size_t>(limit.axis)).name) + ": "
                            : "";
        table.rows.push_back({axis + limit.key,
                              {limit.angle, table_digits},
                              {limit.share, percent, 3},
                              {limit.given, unit},
                              limit.needed  ? Cell(limit.needed, unit, table_digits)
                              : limit.asked ? Cell("no value of it")
                                            : Cell("not searched")});
    }
    return table;
}

Table clearance_table(const MachineSolution& solution) {
    Table table{"clearances",
                "Clearances",
                {{.key = "clearance", .left = true},
                 {"at_least", "required"},
                 {"closest"},
                 {"at", "at (deg)", degrees_shown}}};
    for (std::size_t k = 0; k < solution.clearances.size(); ++k) {
        const Clearance& spec = solution.spec.clearances[k];
        const ShownUnit unit = shown_unit(spec);
        Cell required(spec.at_least, unit);
        required.bound = Bound::at_least;
        table.rows.push_back({spec.key,
                              required,
                              {spec.at_least + solution.clearances[k].value, unit},
                              {solution.clearances[k].at, table_digits}});
    }
    return table;
}

std::string headline_of(const MachineSolution& solution) {
    const auto rpm = [](double speed) { return rpm_shown.text(speed, speed_digits); };
    if (solution.axes.empty())
        return solution.at_standstill
                   ? "No motions exist at any speed: the contradiction remains as the speed approaches 0"
               : solution.certificate.verdict == Verdict::infeasible
                   ? fmt::format("No motions exist at {}: proved", rpm(solution.speed))
                   : "No motions were found";
    if (!solution.spec.searches_speed()) return fmt::format("Motions at {}, as given", rpm(solution.speed));
    if (solution.impossible_above)
        return fmt::format("Largest speed {}; at {} ({} % more) it is proved that no motions exist",
                           rpm(solution.speed), rpm(*solution.impossible_above),
                           short_text(100.0 * (*solution.impossible_above / solution.speed - 1.0), 2));
    return fmt::format("Largest speed {}{}", rpm(solution.speed),
                       solution.reached_most ? ", the end of the range: a larger range may allow more" : "");
}

std::vector<Sentence> sentences_of(const MachineSolution& solution) {
    const Certificate& certificate = solution.certificate;
    std::vector<Sentence> all = {{Kind::headline, "speed", headline_of(solution)}};
    if (!solution.axes.empty())
        all.push_back(
            {Kind::verdict, "verdict",
             fmt::format("Verdict {} of the motions at this speed: total objective {}{}.",
                         name_of(certificate.verdict), short_text(certificate.objective, objective_digits),
                         certificate.lower_bound
                             ? fmt::format(", at least {} is proved",
                                           short_text(*certificate.lower_bound, objective_digits))
                             : "")});
    else if (certificate.verdict != Verdict::infeasible)
        all.push_back({Kind::verdict, "verdict",
                       fmt::format("Verdict {}: {}.", name_of(certificate.verdict),
                                   words_of(name_of(certificate.reason)))});
    if (solution.scanned)
        all.push_back(
            {Kind::remark, "scanned",
             "Some limits do not only tighten as the speed grows: speeds were tried over the range, and "
             "between them nothing is claimed."});
    for (const std::string& note : solution.notes) all.push_back({Kind::note, "", note});
    all.push_back({Kind::effort, "effort",
                   fmt::format("{} speeds tried, {:.2f} s", solution.trials, solution.seconds_total)});
    return all;
}

}  // namespace

Document machine_document(const MachineSolution& solution) {
    const Certificate& certificate = solution.certificate;
    const bool moves = !solution.axes.empty();
    Document document{solution.spec.title.empty() ? "Machine" : solution.spec.title, moves ? "good" : "bad"};
    Section& section = document.sections.emplace_back();
    section.sentences = sentences_of(solution);
    section.figures = {{{.key = "verdict"}, Cell(std::string(name_of(certificate.verdict)))},
                       {{"speed", {}, rpm_shown}, moves ? Cell(solution.speed) : Cell()},
                       {{"impossible_above", {}, rpm_shown}, Cell(solution.impossible_above)},
                       {{"objective"}, moves ? Cell(certificate.objective) : Cell()},
                       {{"lower_bound"}, Cell(certificate.lower_bound)}};
    section.curves = timing_curves(solution);
    section.tables = {stopping_table(solution), axis_table(solution), clearance_table(solution)};
    return document;
}

}  // namespace camopt
