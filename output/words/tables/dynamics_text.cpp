// SPDX-License-Identifier: MIT
#include "output/words/tables/dynamics_text.hpp"

#include "core/units.hpp"
#include "output/words/display_scale.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace {

double rpm(double speed) {
    return speed / units::revolution_per_minute;
}

struct AmplitudeUnit {
    double per_lift;
    const char* name;
};

/// Micrometres, or thousandths of a degree.
AmplitudeUnit amplitude_unit(const MotionSpec& motion) {
    if (motion.lift_is_angle) return {motion.lift / (1e-3 * units::degree), "mdeg"};
    return {motion.lift / 1e-6, "um"};
}

struct AccelerationUnit {
    double per_normalised;
    const char* name;
};

AccelerationUnit acceleration_unit(const MotionSpec& motion) {
    const double per_second = motion.speed.value() / motion.unit_angle();
    return {motion.lift * per_second * per_second, motion.lift_is_angle ? "rad/s^2" : "m/s^2"};
}

const char* force_unit(const MotionSpec& motion) {
    return motion.lift_is_angle ? "N m" : "N";
}

/// The row of a motion at the speed nearest to the scene's own.
const TrainRow& row_at_speed(const TrainStudy& study, std::size_t motion) {
    const std::size_t count = study.speeds.size();
    const double speed = study.scene.motion.speed.value();
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < count; ++k)
        if (std::abs(study.speeds[k] - speed) < std::abs(study.speeds[nearest] - speed)) nearest = k;
    return study.rows[motion * count + nearest];
}

std::string speeds_words(const std::array<double, 2>& speeds) {
    if (speeds[0] == speeds[1]) return fmt::format("at {:.6g} rpm", rpm(speeds[0]));
    return fmt::format("from {:.6g} to {:.6g} rpm", rpm(speeds[0]), rpm(speeds[1]));
}

}  // namespace

std::string dynamics_text(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    const AmplitudeUnit amplitude = amplitude_unit(motion);
    const AccelerationUnit acceleration = acceleration_unit(motion);
    std::string text = study.scene.title.empty() ? std::string() : study.scene.title + "\n";
    text += "Natural frequencies with the cam held:";
    for (const double one : study.natural_frequencies) text += fmt::format(" {:.6g} Hz", one / units::turn);
    text += fmt::format("; one rise from rest, {} speeds from {:.6g} to {:.6g} rpm.\n", study.speeds.size(),
                        rpm(study.speeds.front()), rpm(study.speeds.back()));
    if (study.motions.empty()) return text;
    text += fmt::format("At {:.6g} rpm, the nearest to the scene's speed, {:.4g} natural periods a rise:\n\n",
                        rpm(row_at_speed(study, 0).speed), row_at_speed(study, 0).frequency_ratio);
    const bool pressed = study.scene.dynamics->pressed();
    TextTable table;
    table.columns = {{"motion", true},
                     {fmt::format("residual {}", amplitude.name)},
                     {fmt::format("deflection {}", amplitude.name)},
                     {fmt::format("output {}", acceleration.name)},
                     {fmt::format("worst residual {}", amplitude.name)},
                     {"at rpm"}};
    if (pressed) {
        table.columns.push_back({fmt::format("least force {}", force_unit(motion))});
        table.columns.push_back({"lifts off at rpm"});
    }
    const std::size_t count = study.speeds.size();
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        const TrainRow& row = row_at_speed(study, i);
        const auto begin = study.rows.begin() + static_cast<std::ptrdiff_t>(i * count);
        const TrainRow& worst =
            *std::max_element(begin, begin + static_cast<std::ptrdiff_t>(count),
                              [](const TrainRow& a, const TrainRow& b) { return a.residual < b.residual; });
        const double seconds = row.speed / motion.speed.value();
        std::vector<std::string> cells = {
            study.motions[i].second,
            fixed_text(row.residual * amplitude.per_lift, 2),
            fixed_text(row.peak_deflection * amplitude.per_lift, 2),
            fixed_text(row.peak_acceleration * acceleration.per_normalised * seconds * seconds, 2),
            fixed_text(worst.residual * amplitude.per_lift, 2),
            fixed_text(rpm(worst.speed), 1)};
        if (pressed) {
            cells.push_back(fixed_text(row.least_force, 2));
            cells.push_back(study.lift_off_speeds[i] ? fixed_text(rpm(*study.lift_off_speeds[i]), 1)
                                                     : std::string("–"));
        }
        table.rows.push_back(std::move(cells));
    }
    text += aligned_text(table);
    if (pressed)
        text +=
            "\nLifts off: the lowest speed at which the force on the cam reaches 0 (–: none up to twice the "
            "highest speed). Beyond it the train is no longer linear.\n";
    return text;
}

std::vector<std::string> train_sentences(const Solution& solution) {
    if (!solution.train) return {};
    const TrainReport& train = *solution.train;
    const MotionSpec& motion = solution.scene.motion;
    const AmplitudeUnit amplitude = amplitude_unit(motion);
    const double degrees = display_scale(motion).degrees_per_x;
    std::string frequencies;
    for (const double one : train.natural_frequencies)
        frequencies += fmt::format("{}{:.6g}", frequencies.empty() ? "" : ", ", one / units::turn);
    std::vector<std::string> sentences = {
        fmt::format("elastic follower train of {} Hz: {:.4g} natural periods in the rise at {:.6g} rpm",
                    frequencies, train.frequency_ratio, rpm(motion.speed.value()))};
    const std::string range = speeds_words(train.speeds);
    if (train.residual)
        sentences.push_back(fmt::format("residual vibration at most {:.4g} {} {} (worst at {:.6g} rpm)",
                                        train.residual->value * amplitude.per_lift, amplitude.name, range,
                                        rpm(train.residual->speed)));
    const double per_second = train.acceleration.speed / motion.unit_angle();
    sentences.push_back(fmt::format(
        "acceleration of the output at most {:.5g} (normalised), {:.5g} {} {}, at {:.5g} deg",
        train.acceleration.value, train.acceleration.value * motion.lift * per_second * per_second,
        acceleration_unit(motion).name, range, train.acceleration.at * degrees));
    if (train.least_force)
        sentences.push_back(
            fmt::format("force of the train on the cam at least {:.5g} {} {}, at {:.5g} deg{}",
                        train.least_force->value, force_unit(motion), range, train.least_force->at * degrees,
                        train.least_force->value < 0.0 ? ": THE FOLLOWER LIFTS OFF" : ""));
    return sentences;
}

}  // namespace camopt
