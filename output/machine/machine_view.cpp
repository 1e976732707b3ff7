// SPDX-License-Identifier: MIT
#include "output/machine/machine_view.hpp"

#include "core/text/printable.hpp"
#include "core/version.hpp"
#include "output/chart/chart.hpp"
#include "output/view/key_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int steps = 720;  // of one revolution: every half degree
constexpr double panel_width = 812, panel_height = 120;

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

Curve axis_curve(const MachineView& view, std::size_t index, const AxisAlong& along) {
    const Solution& axis = view.solution.axes[index];
    const MotionUnit unit = shown_units(axis.scene).motion[0].first;
    const AxisSpec& spec = axis_of(view.solution, index);
    const double size = axis.scene.motion.lift / unit.per_normalised;
    Curve curve{"axis_" + spec.name, "axes", printable(spec.name), "s", ShownUnit{unit.name, size}};
    if (spec.phase != 0.0)
        curve.title += fmt::format(", phase {} deg", short_text(degrees_shown.of(spec.phase)));
    for (const double angle : view.angles) curve.values.push_back(along.at(angle * units::degree) / size);
    return curve;
}

Curve clearance_curve(const MachineView& view, std::size_t index, const std::vector<AxisAlong>& along) {
    const Clearance& spec = view.solution.spec.clearances[index];
    std::string names;
    for (std::size_t k = 0; k < spec.axes.size(); ++k) {
        const double factor = std::abs(spec.factors[k]);
        const char* const sign = spec.factors[k] < 0.0 ? (k == 0 ? "− " : " − ") : k == 0 ? "" : " + ";
        names += fmt::format("{}{}{}", sign, factor == 1.0 ? "" : short_text(factor) + " · ",
                             printable(axis_of(view.solution, static_cast<std::size_t>(spec.axes[k])).name));
    }
    Curve curve{fmt::format("clearance_{}", index), "clearances", "Clearance: " + names, "c",
                ShownUnit{spec.unit, spec.unit_value}};
    for (const double angle : view.angles) {
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
        add(from, view.angles.back());
        add(view.angles.front(), to);
    }
    const Extremum& closest = view.solution.clearances[index];
    const double value = (spec.at_least + closest.value) / spec.unit_value;
    double place = std::fmod(degrees_shown.of(closest.at), 360.0);
    if (place < 0.0) place += 360.0;
    curve.marks.push_back({place, value, fmt::format("closest: {} {}", short_text(value), spec.unit)});
    return curve;
}

TextTable axis_table(const MachineSolution& solution) {
    TextTable table{{{"axis", true},
                     {"phase deg"},
                     {"objective"},
                     {"velocity"},
                     {"acceleration"},
                     {"jerk"},
                     {"motor torque"},
                     {"rms torque"},
                     {"motor speed"},
                     {"active limits", true}},
                    {}};
    for (std::size_t a = 0; a < solution.axes.size(); ++a) {
        const Solution& axis = solution.axes[a];
        const ShownUnits shown = shown_units(axis.scene);
        std::vector<std::string> row = {printable(axis_of(solution, a).name),
                                        short_text(degrees_shown.of(axis_of(solution, a).phase)),
                                        short_text(axis.certificate.objective)};
        std::size_t order = 1;
        for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk})
            row.push_back(shown.motion[order++].first.normalised_text((axis.motion_peaks.*peak).value, 5));
        const std::string none = "–";
        row.push_back(axis.drive ? shown.torque.text(axis.drive->torque.value, 5) : none);
        row.push_back(axis.drive ? shown.torque.text(axis.drive->rms_torque, 5) : none);
        row.push_back(axis.drive ? rpm_shown.text(axis.drive->speed.value, 5) : none);
        std::string active;
        for (const ConstraintReport& limit : axis.constraints)
            if (limit.active) active += (active.empty() ? "" : ", ") + key_words(limit.key).words;
        row.push_back(active);
        table.rows.push_back(std::move(row));
    }
    return table;
}

TextTable stopping_table(const MachineSolution& solution) {
    TextTable table{{{"what stops it", true},
                     {"at (deg)"},
                     {"share of the proof"},
                     {"given"},
                     {"alone enough for 5 % more speed"}},
                    {}};
    for (const MachineLimit& limit : solution.limited_by) {
        const std::string unit = limit.unit.empty() ? "" : " " + unit_words(limit.unit);
        const std::string axis =
            limit.axis >= 0 ? printable(axis_of(solution, static_cast<std::size_t>(limit.axis)).name) + ": "
                            : "";
        table.rows.push_back({axis + limit.key, short_text(degrees_shown.of(limit.angle), 5),
                              fmt::format("{} %", short_text(100.0 * limit.share, 3)),
                              limit.given ? short_text(*limit.given) + unit : "–",
                              limit.needed  ? short_text(*limit.needed, 5) + unit
                              : limit.asked ? "no value of it"
                                            : "not searched"});
    }
    return table;
}

TextTable clearance_table(const MachineSolution& solution) {
    TextTable table{{{"clearance", true}, {"at least"}, {"closest"}, {"at (deg)"}}, {}};
    for (std::size_t k = 0; k < solution.clearances.size(); ++k) {
        const Clearance& spec = solution.spec.clearances[k];
        const ShownUnit unit{spec.unit, spec.unit_value};
        table.rows.push_back({spec.key, unit.text(spec.at_least),
                              unit.text(spec.at_least + solution.clearances[k].value),
                              short_text(degrees_shown.of(solution.clearances[k].at), 5)});
    }
    return table;
}

std::string headline_of(const MachineSolution& solution) {
    const auto rpm = [](double speed) { return rpm_shown.text(speed, 7); };
    if (solution.axes.empty())
        return solution.at_standstill
                   ? "No motions exist at any speed: the contradiction remains as the speed approaches 0"
               : solution.certificate.verdict == Verdict::infeasible
                   ? fmt::format("No motions exist at {}: proved", rpm(solution.speed))
                   : "No motions were found";
    if (!solution.spec.searches_speed()) return fmt::format("Motions at {}, as given", rpm(solution.speed));
    if (solution.impossible_above)
        return fmt::format("Largest speed {}; at {} it is proved that no motions exist", rpm(solution.speed),
                           rpm(*solution.impossible_above));
    return fmt::format("Largest speed {}{}", rpm(solution.speed),
                       solution.reached_most ? ", the end of the range" : "");
}

ChartPanel panel_of(const MachineView& view, const Curve& curve, bool last) {
    ChartPanel panel;
    panel.width = panel_width;
    panel.height = panel_height;
    panel.caption = curve.title;
    panel.frame.vertical_title = curve.unit.name;
    panel.frame.horizontal = {0.0, 360.0};
    for (int tick = 0; tick <= 360; tick += 30)
        panel.frame.horizontal_ticks.push_back(
            {static_cast<double>(tick), last ? fmt::format("{}", tick) : ""});
    if (last) panel.frame.horizontal_title = "angle of the master (deg)";
    ChartSeries line{Look::line, "optimum"};
    for (std::size_t i = 0; i < view.angles.size(); ++i)
        line.points.push_back({view.angles[i], curve.values[i]});
    panel.series.push_back(std::move(line));
    for (const CurveLimit& limit : curve.limits)
        panel.series.push_back({Look::line,
                                "limit",
                                {{limit.from, limit.at, "", limit.words}, {limit.to, limit.at}},
                                4.0,
                                "",
                                "limit-label",
                                LabelSide::below});
    for (const CurveMark& mark : curve.marks)
        panel.series.push_back({Look::dot,
                                "peak",
                                {{mark.at, mark.value, "", mark.words}},
                                4.0,
                                "",
                                "peak-label",
                                LabelSide::above});
    return panel;
}

std::vector<std::string> sentences_of(const MachineSolution& solution) {
    std::vector<std::string> all;
    const Certificate& certificate = solution.certificate;
    if (!solution.axes.empty())
        all.push_back(
            fmt::format("Verdict {} of the motions at this speed: total objective {}{}.",
                        name_of(certificate.verdict), short_text(certificate.objective, 9),
                        certificate.lower_bound
                            ? fmt::format(", at least {} is proved", short_text(*certificate.lower_bound, 9))
                            : ""));
    if (solution.scanned)
        all.emplace_back(
            "Some limits do not only tighten as the speed grows: speeds were tried over the range, and "
            "between them nothing is claimed.");
    return all;
}

}  // namespace

MachineView::MachineView(const MachineSolution& shown)
    : solution(shown), headline(headline_of(shown)), sentences(sentences_of(shown)) {
    const auto add = [&](const char* key, const char* title, TextTable table, std::string note = {}) {
        if (!table.rows.empty()) tables.push_back({key, title, std::move(table), std::move(note)});
    };
    add("stops", "What stops the machine", stopping_table(solution),
        "Shares of the multipliers of the proof at the speed above; the last column changes this one number "
        "alone.");
    if (solution.axes.empty()) return;
    for (int i = 0; i <= steps; ++i) angles.push_back(360.0 * i / steps);
    const std::vector<AxisAlong> along = axes_along(solution);
    for (std::size_t a = 0; a < along.size(); ++a) curves.push_back(axis_curve(*this, a, along[a]));
    for (std::size_t c = 0; c < solution.clearances.size(); ++c)
        curves.push_back(clearance_curve(*this, c, along));
    add("axes", "Axes", axis_table(solution),
        "Largest magnitudes at this speed; each axis has its own folder.");
    add("clearances", "Clearances", clearance_table(solution));
}

std::string timing_svg(const MachineView& view) {
    if (view.curves.empty()) throw InputError("timing.svg needs motions, and this machine has none");
    Chart chart{view.solution.spec.title.empty() ? "Machine" : view.solution.spec.title};
    chart.lines = {view.headline};
    for (const Curve& curve : view.curves)
        chart.panels.push_back(panel_of(view, curve, &curve == &view.curves.back()));
    return chart_svg(std::move(chart));
}

std::string machine_markdown(const MachineView& view, const RunOrigin& origin) {
    const MachineSolution& solution = view.solution;
    std::string text = fmt::format(
        "# {}\n\n**{}.**\n\n", solution.spec.title.empty() ? "Machine" : markdown_words(solution.spec.title),
        view.headline);
    for (const std::string& sentence : view.sentences) text += sentence + "\n\n";
    if (!view.curves.empty())
        text += "![Timing diagram and clearances over one revolution of the master](timing.svg)\n";
    for (const ViewTable& table : view.tables)
        text += fmt::format("\n## {}\n\n{}{}", table.title, markdown_text(table.table),
                            table.note.empty() ? "" : "\n" + table.note + "\n");
    if (!solution.axes.empty()) {
        text += "\n## Files\n\n";
        for (const AxisSpec& axis : solution.spec.axes)
            text +=
                fmt::format("- `{0}/`: report, motion table and certificate of {0}\n", printable(axis.name));
    }
    if (!solution.notes.empty()) text += "\n## Notes\n\n";
    for (const std::string& note : solution.notes) text += "- " + markdown_words(note) + "\n";
    return text + fmt::format("\nCommand: {}, camopt {}\n", markdown_code(origin.command), version());
}

}  // namespace camopt
