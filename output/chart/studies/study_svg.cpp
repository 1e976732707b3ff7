// SPDX-License-Identifier: MIT
#include "output/chart/studies/study_svg.hpp"

#include "output/chart/chart.hpp"
#include "output/papers/paper_output.hpp"
#include "output/view/shown_units.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Beside optimum, static optimum and reference law: those most drives offer.
constexpr std::array<std::string_view, 3> shown_laws = {"modified_sine", "polynomial_345", "cycloidal"};

bool is_shown(const TrainStudy& study, const std::string& key) {
    return key == "optimum" || key == "static_optimum" || key == study.scene.objective.reference.law ||
           std::ranges::find(shown_laws, key) != shown_laws.end();
}

/// One series a motion that is shown, of its worst stroke at each speed.
PaperFigure over_speed(const TrainStudy& study, const char* title, const std::string& unit,
                       const std::function<double(const TrainRow&)>& value) {
    PaperFigure figure{"", title, "speed of the cam, rpm", unit, {}};
    const std::size_t count = study.speeds.size();
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        if (!is_shown(study, study.motions[i].first)) continue;
        PaperSeries& series = figure.series.emplace_back(PaperSeries{study.motions[i].second, {}, {}});
        for (std::size_t k = 0; k < count; ++k) {
            series.x.push_back(rpm_shown.of(study.speeds[k]));
            double& worst = series.y.emplace_back(0.0);
            for (std::size_t row = i * count + k; row < study.rows.size();
                 row += study.motions.size() * count)
                worst = std::max(worst, value(study.rows[row]));
        }
    }
    return figure;
}

PaperFigure over_angle(const TrainStudy& study, const std::string& title, const std::string& unit,
                       const std::function<double(const TrainInstant&)>& value) {
    PaperFigure figure{"", title, "cam angle from the beginning of the first stroke, deg", unit, {}};
    for (const TrainHistory& history : study.histories) {
        const auto named =
            std::ranges::find(study.motions, history.motion, &std::pair<std::string, std::string>::first);
        PaperSeries& series = figure.series.emplace_back(PaperSeries{named->second, {}, {}});
        for (const TrainInstant& instant : history.instants) {
            series.x.push_back(degrees_shown.of(instant.x * study.scene.motion.unit_angle()));
            series.y.push_back(value(instant));
        }
    }
    return figure;
}

// A bar ends here at the latest, in units of the least finite objective: one bad law must not flatten the
// rest.
constexpr double longest_bar = 3.0;
constexpr std::size_t most_letters = 52;  // of a remark
constexpr double row_height = 24;         // px

std::string shortened(const std::string& words) {
    if (words.size() <= most_letters) return words;
    std::size_t end = words.rfind(' ', most_letters - 1);
    if (end == std::string::npos) end = most_letters - 1;
    return words.substr(0, end) + " …";
}

std::string remark_of(const ComparisonRow& row) {
    const std::vector<std::string> broken = broken_limits(row);
    if (broken.empty()) return {};
    const std::string more = broken.size() > 1 ? fmt::format("; {} more", broken.size() - 1) : "";
    return shortened(broken.front()) + more;
}

/// One bar a row that has a finite objective.
ChartPanel bar_panel(const Comparison& comparison) {
    const bool limits =
        std::ranges::any_of(comparison.rows, [](const auto& row) { return !row.limits.empty(); });
    ChartSeries optimum{Look::bar, "optimum-bar", {}, 0.0, "optimum"},
        laws{Look::bar, "law-bar", {}, 0.0, limits ? "law, satisfies every limit" : "law"},
        broken{Look::bar, "broken-bar", {}, 0.0, limits ? "law, violates a limit (the worst is named)" : ""};
    ChartSeries line{Look::line, "optimum-line"};
    ChartSeries words{Look::label, "", {}, 0.0, "", "remark", LabelSide::beside};
    ChartPanel panel{.place = ChartPanel::Place::right, .width = 330, .row_height = row_height};
    panel.frame.horizontal_title = "objective";
    double least = infinity, most = 0.0, last = 0.0;
    for (const ComparisonRow& row : comparison.rows) {
        const double y = -0.5 - panel.rows++;
        if (!row.misfit.empty() || !std::isfinite(row.objective)) {
            if (row.misfit.empty()) words.points.push_back({0.0, y, "", "∞"});
            continue;
        }
        (!row.feasible ? broken : row.is_optimum() ? optimum : laws).points.push_back({row.objective, y});
        if (row.is_optimum()) line.points.push_back({row.objective, y + 0.5});
        least = std::min(least, row.objective);
        most = std::max(most, row.objective);
        last = y - 0.5;
    }
    if (!line.points.empty()) line.points.push_back({line.points.front().x, last});
    if (!(most > 0.0)) most = 1.0;
    panel.frame.horizontal = {0.0, 1.04 * (least > 0.0 ? std::min(most, longest_bar * least) : most)};
    panel.series = {std::move(optimum), std::move(laws), std::move(broken), std::move(line),
                    std::move(words)};
    return panel;
}

/// The table left of the bars, and that right of them.
std::array<ChartPanel, 2> tables_of(const Comparison& comparison) {
    std::array<ChartPanel, 2> tables;
    const auto add = [&](std::size_t table, const std::string& head,
                         const std::function<std::string(const ComparisonRow&)>& words) {
        ChartColumn column{head};
        for (const ComparisonRow& row : comparison.rows)
            column.cells.push_back(
                {row.misfit.empty() || table == 0 ? words(row) : "", row.is_optimum() ? "value best"
                                                                     : row.feasible   ? "value"
                                                                                      : "value faint"});
        tables[table].columns.push_back(std::move(column));
    };
    add(0, "", row_title);
    add(1, "objective", [](const ComparisonRow& row) { return fixed_text(row.objective, 4); });
    add(1, "loss", loss_words);
    for (const PhysicalPeak& peak : physical_peaks(comparison))
        add(1, peak.title, [&](const ComparisonRow& row) { return peak.text(row); });
    add(1, "V", [](const ComparisonRow& row) { return fixed_text(row.peaks.velocity.value, 3); });
    add(1, "A", [](const ComparisonRow& row) { return fixed_text(row.peaks.acceleration.value, 3); });
    add(1, "J", [](const ComparisonRow& row) { return fixed_text(row.peaks.jerk.value, 2); });
    if (has_bases(comparison))
        add(1, base_title(comparison), [&](const ComparisonRow& row) { return base_words(comparison, row); });
    ChartColumn remarks{"", TextSide::start};
    for (const ComparisonRow& row : comparison.rows)
        remarks.cells.push_back({row.misfit.empty() ? remark_of(row) : "left out: " + row.misfit, "remark"});
    tables[1].columns.push_back(std::move(remarks));
    tables[1].place = ChartPanel::Place::right;
    for (ChartPanel& table : tables) table.row_height = row_height;
    return tables;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    const ShownUnits shown = shown_units(study.scene);
    const double amplitude = shown.vibration.of(motion.lift);
    const std::string& amplitude_unit = shown.vibration.name;
    const MotionUnit& acceleration_unit = shown.motion[2].first;
    const auto physical = [&](double value, double speed) {
        return acceleration_unit.of(value * motion.lift * speed * speed /
                                    (motion.unit_angle() * motion.unit_angle()));
    };
    std::vector<std::pair<std::string, std::string>> pictures;
    const auto add = [&](const char* name, const PaperFigure& figure) {
        pictures.emplace_back(name, paper_figure_svg(figure));
    };
    add("residual_over_speed.svg",
        over_speed(study, "Residual vibration after a stroke from rest", amplitude_unit,
                   [&](const TrainRow& row) { return row.residual * amplitude; }));
    add("acceleration_over_speed.svg",
        over_speed(study, "Largest acceleration of the output during a stroke", acceleration_unit.name,
                   [&](const TrainRow& row) { return physical(row.peak_acceleration, row.speed); }));
    if (study.histories.empty()) return pictures;
    const std::string at = fmt::format(" at {:.6g} rpm", rpm_shown.of(study.histories.front().speed));
    const double speed = study.histories.front().speed;
    add("deflection.svg",
        over_angle(study, "Output minus cam path" + at, amplitude_unit,
                   [&](const TrainInstant& one) { return (one.output - one.input) * amplitude; }));
    add("acceleration.svg",
        over_angle(study, "Acceleration of the output" + at, acceleration_unit.name,
                   [&](const TrainInstant& one) { return physical(one.acceleration, speed); }));
    add("force.svg", over_angle(study, "Force of the train on the cam" + at, shown.load.name,
                                [&](const TrainInstant& one) { return shown.load.of(one.force); }));
    return pictures;
}

std::string comparison_svg(const Comparison& comparison) {
    const Solution& solution = comparison.optimum;
    auto [names, numbers] = tables_of(comparison);
    return chart_svg({solution.scene.title.empty() ? "Comparison of laws" : solution.scene.title,
                      {verdict_sentence(solution), comparison_sentence(comparison),
                       "Objective = " + objective_words(comparison)},
                      {std::move(names), bar_panel(comparison), std::move(numbers)}});
}

}  // namespace camopt
