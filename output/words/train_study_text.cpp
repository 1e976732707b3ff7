// SPDX-License-Identifier: MIT
#include "core/text/list_text.hpp"
#include "output/view/cam_words.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// Of the speed nearest to the scene's own.
std::size_t nearest_speed(const TrainStudy& study) {
    const double speed = study.scene.motion.speed.value();
    const auto nearest =
        std::ranges::min_element(study.speeds, {}, [&](double one) { return std::abs(one - speed); });
    return static_cast<std::size_t>(nearest - study.speeds.begin());
}

/// One stroke: motion by motion.
TextTable stroke_table(const TrainStudy& study, std::size_t stroke) {
    const ShownUnits shown = shown_units(study.scene);
    const ShownUnit& amplitude = shown.vibration;
    const double lift = study.scene.motion.lift;
    const bool pressed = study.scene.dynamics->pressed();
    TextTable table;
    table.columns = {{"motion", true},
                     {fmt::format("residual {}", amplitude.name)},
                     {fmt::format("deflection {}", amplitude.name)},
                     {fmt::format("output {}", shown.motion[2].first.name)},
                     {fmt::format("worst residual {}", amplitude.name)},
                     {"at rpm"}};
    if (pressed) {
        table.columns.push_back({fmt::format("least force {}", shown.load.name)});
        table.columns.push_back({"lifts off at rpm"});
    }
    const std::size_t count = study.speeds.size(), nearest = nearest_speed(study);
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        const std::size_t at = stroke * study.motions.size() + i;
        const auto rows = std::span(study.rows).subspan(at * count, count);
        const TrainRow& row = rows[nearest];
        const TrainRow& worst = *std::ranges::max_element(rows, {}, &TrainRow::residual);
        std::vector<std::string> cells = {
            study.motions[i].second,
            fixed_text(amplitude.of(row.residual * lift), 2),
            fixed_text(amplitude.of(row.peak_deflection * lift), 2),
            fixed_text(acceleration_at(study.scene, row.peak_acceleration, row.speed), 2),
            fixed_text(amplitude.of(worst.residual * lift), 2),
            fixed_text(rpm_shown.of(worst.speed), 1)};
        if (pressed) {
            const std::optional<double>& off = study.lift_off_speeds[at];
            cells.push_back(row.least_force ? fixed_text(shown.load.of(*row.least_force), 2) : "–");
            cells.push_back(off ? fixed_text(rpm_shown.of(*off), 1) : std::string("–"));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace

std::string dynamics_text(const TrainStudy& study) {
    std::string text = study.scene.title.empty() ? std::string() : study.scene.title + "\n";
    text += "Natural frequencies with the cam held:";
    for (const double one : study.natural_frequencies)
        text += fmt::format(" {} Hz", short_text(hertz_shown.of(one)));
    text += fmt::format("; each stroke from rest, {} speeds from {} to {} rpm.\n", study.speeds.size(),
                        short_text(rpm_shown.of(study.speeds.front())),
                        short_text(rpm_shown.of(study.speeds.back())));
    if (study.motions.empty()) return text;
    const std::size_t nearest = nearest_speed(study), rows = study.motions.size() * study.speeds.size();
    text += fmt::format("At {} rpm, the nearest to the scene's speed:\n",
                        short_text(rpm_shown.of(study.speeds[nearest])));
    const MotionSpec& motion = study.scene.motion;
    for (std::size_t stroke = 0; stroke < study.strokes.size(); ++stroke) {
        const std::vector<MotionStretch>& moving = study.strokes[stroke].moving;
        text +=
            fmt::format("\n{}, {} natural periods:\n\n{}",
                        capitalised(stroke_words(motion, stroke, moving.front().begin, moving.back().end)),
                        short_text(study.rows[stroke * rows + nearest].frequency_ratio, 4),
                        aligned_text(stroke_table(study, stroke)));
    }
    if (study.scene.dynamics->pressed())
        text +=
            "\nLifts off: the lowest speed at which the force on the cam reaches 0 (–: none up to twice the "
            "highest speed). Beyond it the train is no longer linear.\n";
    return text;
}

}  // namespace camopt
