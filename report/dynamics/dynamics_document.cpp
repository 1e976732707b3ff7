// SPDX-License-Identifier: MIT
#include "report/dynamics/dynamics_document.hpp"

#include "core/text/list_text.hpp"
#include "report/papers/paper_output.hpp"
#include "report/view/cam_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

constexpr int train_decimals = 2, train_speed_decimals = 1;

// Beside optimum, static optimum and reference law: those most drives offer.
constexpr std::array<std::string_view, 3> shown_laws = {"modified_sine", "polynomial_345", "cycloidal"};

bool is_shown(const TrainStudy& study, const std::string& key) {
    return key == "optimum" || key == "static_optimum" || key == "polydyne" ||
           key == study.scene.objective.reference.law ||
           std::ranges::find(shown_laws, key) != shown_laws.end();
}

/// Rows of one motion in one stroke, speed by speed.
std::span<const TrainRow> rows_of(const TrainStudy& study, std::size_t stroke, std::size_t motion) {
    const std::size_t count = study.speeds.size();
    return std::span(study.rows).subspan((stroke * study.motions.size() + motion) * count, count);
}

/// Of the speed nearest to the scene's own.
std::size_t nearest_speed(const TrainStudy& study) {
    const double speed = study.scene.motion.speed.value();
    const auto nearest =
        std::ranges::min_element(study.speeds, {}, [&](double one) { return std::abs(one - speed); });
    return static_cast<std::size_t>(nearest - study.speeds.begin());
}

/// One stroke: motion by motion.
Table stroke_table(const TrainStudy& study, std::size_t stroke) {
    const ShownUnits shown = shown_units(study.scene);
    const MotionSpec& motion = study.scene.motion;
    const std::vector<MotionStretch>& moving = study.strokes[stroke].moving;
    const std::size_t nearest = nearest_speed(study);
    const double start = motion.master_angle(moving.front().begin),
                 end = motion.master_angle(moving.back().end);
    Table table{
        "motions",
        fmt::format("{}, {} natural periods",
                    capitalised(stroke_words(motion, stroke, moving.front().begin, moving.back().end)),
                    short_text(rows_of(study, stroke, 0)[nearest].frequency_ratio, 4))};
    const auto add = [&](Field field, const auto& cell_of) {
        std::size_t index = 0;
        table.add_column(std::move(field), study.motions, [&](const auto&) { return cell_of(index++); });
    };
    const auto add_number = [&](const char* key, const ShownUnit& unit, const auto& value) {
        add({.key = key, .unit = unit, .decimals = train_decimals},
            [&](std::size_t index) { return value(rows_of(study, stroke, index)); });
    };
    using Rows = std::span<const TrainRow>;
    const auto worst = [](Rows rows) -> const TrainRow& {
        return *std::ranges::max_element(rows, {}, &TrainRow::residual);
    };
    add({.key = "motion", .where = Where::files},
        [&](std::size_t index) { return study.motions[index].first; });
    add({.key = "title", .title = "motion", .left = true},
        [&](std::size_t index) { return study.motions[index].second; });
    add({.key = "stroke", .where = Where::files},
        [&](std::size_t) { return static_cast<double>(stroke + 1); });
    add({.key = "start", .unit = degrees_shown, .where = Where::files}, [&](std::size_t) { return start; });
    add({.key = "end", .unit = degrees_shown, .where = Where::files}, [&](std::size_t) { return end; });
    add_number("residual", shown.vibration, [&](Rows rows) { return rows[nearest].residual * motion.lift; });
    add_number("deflection", shown.vibration,
               [&](Rows rows) { return rows[nearest].peak_deflection * motion.lift; });
    const MotionUnit& acceleration = shown.motion[2].first;
    add_number("output", acceleration, [&](Rows rows) {
        return acceleration.size *
               acceleration_at(study.scene, rows[nearest].peak_acceleration, rows[nearest].speed);
    });
    add_number("worst_residual", shown.vibration,
               [&](Rows rows) { return worst(rows).residual * motion.lift; });
    add({"worst_at", "at rpm", rpm_shown, false, train_speed_decimals},
        [&](std::size_t index) { return worst(rows_of(study, stroke, index)).speed; });
    add_number("least_force", shown.load, [&](Rows rows) { return rows[nearest].least_force; });
    add({"lifts_off_at", {}, rpm_shown, false, train_speed_decimals},
        [&](std::size_t index) { return study.lift_off_speeds[stroke * study.motions.size() + index]; });
    return table;
}

ShownUnit force_unit(const TrainStudy& study) {
    return file_units(study.scene).load;
}

/// Every row; no person reads them one by one.
Table row_table(const TrainStudy& study) {
    Table table{.key = "rows", .file = "dynamics.csv", .in_json = true};
    const auto add = [&](Field field, const auto& cell_of) {
        table.add_column(std::move(field), study.rows, cell_of);
    };
    add({"motion"}, [](const TrainRow& row) { return row.motion; });
    add({"stroke"}, [](const TrainRow& row) { return static_cast<double>(row.stroke); });
    add({"speed", {}, rpm_shown}, [](const TrainRow& row) { return row.speed; });
    add({"frequency_ratio"}, [](const TrainRow& row) { return row.frequency_ratio; });
    add({"residual"}, [](const TrainRow& row) { return row.residual; });
    add({"peak_deflection"}, [](const TrainRow& row) { return row.peak_deflection; });
    add({"peak_acceleration"}, [](const TrainRow& row) { return row.peak_acceleration; });
    add({"lifts_off"}, [](const TrainRow& row) { return counted_flag(row.lifts_off()); });
    add({"least_force", {}, force_unit(study)}, [](const TrainRow& row) { return row.least_force; });
    return table;
}

Table steady_table(const TrainStudy& study) {
    Table table{.key = "steady_state", .file = "steady.csv", .in_json = true};
    const auto add = [&](Field field, const auto& cell_of) {
        table.add_column(std::move(field), study.steady, cell_of);
    };
    add({"speed", {}, rpm_shown}, [](const SteadyRow& row) { return row.speed; });
    add({"peak_deflection"}, [](const SteadyRow& row) { return row.peak_deflection; });
    add({"peak_acceleration"}, [](const SteadyRow& row) { return row.peak_acceleration; });
    add({"least_force", {}, force_unit(study)}, [](const SteadyRow& row) { return row.least_force; });
    return table;
}

/// What is left where the train is stiffer or softer than it was thought to be.
Table detuned_table(const TrainStudy& study) {
    const ShownUnits shown = shown_units(study.scene);
    Table table{
        "detuned",
        "Residual vibration at the scene's speed, where the natural frequency is another",
        {{.key = "motion", .where = Where::files}, {.key = "title", .title = "motion", .left = true}}};
    for (const double factor : detuning)
        table.columns.push_back(
            {.key = fmt::format("residual_at_{:.0f}_percent", 100.0 * factor),
             .title = factor == 1.0 ? "as given" : fmt::format("{:+.0f} %", 100.0 * (factor - 1.0)),
             .unit = shown.vibration,
             .decimals = train_decimals});
    for (std::size_t i = 0; i < study.detuned.size(); ++i) {
        std::vector<Cell>& cells =
            table.rows.emplace_back(std::vector<Cell>{study.motions[i].first, study.motions[i].second});
        for (const double residual : study.detuned[i].residual)
            cells.emplace_back(residual * study.scene.motion.lift);
    }
    table.file = "detuned.csv";
    return table;
}

Table history_table(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    const ShownUnit path = motion.lift_is_angle ? degrees_shown : millimetres_shown;
    const ShownUnit acceleration = motion.lift_is_angle ? unit_named<"rad/s^2"> : unit_named<"m/s^2">;
    Table table{.key = "history",
                .columns = {{"motion"},
                            {"speed", {}, rpm_shown},
                            {"theta", {}, degrees_shown},
                            {"input", {}, path},
                            {"output", {}, path},
                            {"output", {}, acceleration},
                            {"force", {}, force_unit(study)}},
                .file = "history.csv"};
    for (const TrainHistory& history : study.histories) {
        const double per_second = history.speed / motion.unit_angle();
        for (const TrainInstant& one : history.instants)
            table.rows.push_back({history.motion, Cell(history.speed), Cell(one.x * motion.unit_angle()),
                                  Cell(one.input * motion.lift), Cell(one.output * motion.lift),
                                  Cell(one.acceleration * motion.lift * per_second * per_second),
                                  Cell(one.force)});
    }
    return table;
}

/// One series a motion that is shown, of its worst stroke at each speed.
Picture over_speed(const TrainStudy& study, const char* key, const char* title, const std::string& unit,
                   const std::function<double(const TrainRow&)>& value) {
    PaperFigure figure{"", title, "speed of the cam, rpm", unit, {}};
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        if (!is_shown(study, study.motions[i].first)) continue;
        PaperSeries& series = figure.series.emplace_back(PaperSeries{study.motions[i].second, {}, {}});
        for (std::size_t k = 0; k < study.speeds.size(); ++k) {
            series.x.push_back(rpm_shown.of(study.speeds[k]));
            double& worst = series.y.emplace_back(0.0);
            for (std::size_t stroke = 0; stroke < study.strokes.size(); ++stroke)
                worst = std::max(worst, value(rows_of(study, stroke, i)[k]));
        }
    }
    return {key, title, paper_chart(figure)};
}

Picture over_angle(const TrainStudy& study, const char* key, const char* title, const std::string& unit,
                   const std::function<double(const TrainInstant&)>& value) {
    PaperFigure figure{
        "",
        fmt::format("{} at {} rpm", title, short_text(rpm_shown.of(study.histories.front().speed))),
        "cam angle from the beginning of the first stroke, deg",
        unit,
        {}};
    for (const TrainHistory& history : study.histories) {
        const auto named =
            std::ranges::find(study.motions, history.motion, &std::pair<std::string, std::string>::first);
        PaperSeries& series = figure.series.emplace_back(PaperSeries{named->second, {}, {}});
        for (const TrainInstant& instant : history.instants) {
            series.x.push_back(degrees_shown.of(instant.x * study.scene.motion.unit_angle()));
            series.y.push_back(value(instant));
        }
    }
    return {key, figure.title, paper_chart(figure)};
}

std::vector<Picture> pictures_of(const TrainStudy& study) {
    const ShownUnits shown = shown_units(study.scene);
    const double amplitude = shown.vibration.of(study.scene.motion.lift);
    const std::string& unit = shown.motion[2].first.name;
    const auto physical = [&](double value, double speed) {
        return acceleration_at(study.scene, value, speed);
    };
    std::vector<Picture> pictures = {
        over_speed(study, "residual_over_speed", "Residual vibration after a stroke from rest",
                   shown.vibration.name, [&](const TrainRow& row) { return row.residual * amplitude; }),
        over_speed(study, "acceleration_over_speed", "Largest acceleration of the output during a stroke",
                   unit, [&](const TrainRow& row) { return physical(row.peak_acceleration, row.speed); })};
    if (study.histories.empty()) return pictures;
    const double speed = study.histories.front().speed;
    pictures.push_back(
        over_angle(study, "deflection", "Output minus cam path", shown.vibration.name,
                   [&](const TrainInstant& one) { return (one.output - one.input) * amplitude; }));
    pictures.push_back(
        over_angle(study, "acceleration", "Acceleration of the output", unit,
                   [&](const TrainInstant& one) { return physical(one.acceleration, speed); }));
    pictures.push_back(over_angle(study, "force", "Force of the train on the cam", shown.load.name,
                                  [&](const TrainInstant& one) { return shown.load.of(one.force); }));
    return pictures;
}

}  // namespace

Document dynamics_document(const TrainStudy& study) {
    Document document{study.scene.title.empty() ? "Elastic follower train" : study.scene.title};
    document.kind = "Dynamics";
    Section& section = document.sections.emplace_back();
    Figure frequencies{{"natural_frequencies_hz"}};
    std::string words;
    for (const double one : study.natural_frequencies) {
        frequencies.cell.numbers.push_back(hertz_shown.of(one));
        words += " " + hertz_shown.text(one);
    }
    section.figures = {std::move(frequencies)};
    section.sentences = {
        {Kind::verdict, "frequencies",
         fmt::format(
             "Natural frequencies with the cam held:{}; each stroke from rest, {} speeds from {} to {}.",
             words, study.speeds.size(), short_text(rpm_shown.of(study.speeds.front())),
             rpm_shown.text(study.speeds.back()))}};
    if (!study.motions.empty()) {
        const auto& [key, title] = study.motions.front();
        const std::size_t nearest = nearest_speed(study);
        double residual = 0.0;
        for (std::size_t stroke = 0; stroke < study.strokes.size(); ++stroke)
            residual = std::max(residual, rows_of(study, stroke, 0)[nearest].residual);
        section.sentences.insert(
            section.sentences.begin(),
            {Kind::headline, "residual",
             fmt::format("{} at {}, the speed nearest to the scene's: residual vibration {}",
                         capitalised(title), rpm_shown.text(study.speeds[nearest]),
                         shown_units(study.scene).vibration.text(residual * study.scene.motion.lift, 4))});
        for (std::size_t stroke = 0; stroke < study.strokes.size(); ++stroke)
            section.tables.push_back(stroke_table(study, stroke));
        section.pictures = pictures_of(study);
    }
    if (study.scene.dynamics->pressed() && !section.tables.empty())
        section.tables.back().note =
            "Lifts off: the lowest speed at which the force on the cam reaches 0 (–: none up to twice the "
            "highest speed). Beyond it the train is no longer linear.";
    section.tables.push_back(detuned_table(study));
    section.tables.push_back(row_table(study));
    section.tables.push_back(steady_table(study));
    section.tables.push_back(history_table(study));
    return document;
}

}  // namespace camopt
