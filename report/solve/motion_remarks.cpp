// SPDX-License-Identifier: MIT
#include "report/solve/motion_remarks.hpp"

#include "core/text/list_text.hpp"
#include "report/view/cam_words.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr int own_term_digits = 9;
constexpr double no_train_force =
    1e-7;  // of what presses at the top: a limit of 0 is met to the tolerance of the solve

double rpm(double speed) {
    return rpm_shown.of(speed);
}

std::string rpm_text(double speed) {
    return short_text(rpm(speed));
}

std::string hertz_text(double frequency) {
    return short_text(hertz_shown.of(frequency));
}

/// "from 300 to 1200 rpm"
std::string speeds_words(const std::array<double, 2>& speeds) {
    if (speeds[0] == speeds[1]) return fmt::format("at {} rpm", rpm_text(speeds[0]));
    return fmt::format("from {} to {} rpm", rpm_text(speeds[0]), rpm_text(speeds[1]));
}

/// What the cam does so that the output moves as is wanted. There is an output of its own.
std::string cam_sentence(const Solution& solution) {
    const ShownUnits shown = shown_units(solution.scene);
    const auto peak = [&](std::size_t order) {
        const Extremum& found = derivative_peak(solution.cam_peaks, static_cast<int>(order));
        return fmt::format("{} {} at {} deg", derivative_names[order],
                           shown.motion[order].first.normalised_text(found.value),
                           degrees_at(solution, found.at));
    };
    return fmt::format(
        "the motion is the output's; the cam gives what the train needs for it at {} rpm, and its own "
        "largest {}, "
        "{} and {}",
        rpm_text(*solution.scene.motion.speed), peak(1), peak(2), peak(3));
}

}  // namespace

std::string own_term_sentence(const OwnTermReport& term) {
    return fmt::format("{} reaches {}, {} in the objective (weight {}, reference {})", term.name,
                       short_text(term.value, own_term_digits),
                       short_text(term.weight * term.value / term.reference, own_term_digits),
                       short_text(term.weight), short_text(term.reference));
}

std::vector<std::string> train_sentences(const Solution& solution) {
    if (!solution.train) return {};
    const TrainReport& train = *solution.train;
    const Scene& scene = solution.scene;
    const ShownUnits shown = shown_units(scene);
    std::vector<std::string> sentences = {
        fmt::format("elastic follower train of {} Hz: {} natural periods in the rise at {} rpm",
                    listed(train.natural_frequencies, ", ", hertz_text), short_text(train.frequency_ratio, 4),
                    rpm_text(*scene.motion.speed))};
    if (solution.output) sentences.push_back(cam_sentence(solution));
    if (!train.acceleration) {
        sentences.emplace_back(
            "no dwell: the motion never rests, so there is no transient from rest and no residual vibration "
            "to report");
        return sentences;
    }
    const std::string range = speeds_words(train.speeds);
    if (train.residual)
        sentences.push_back(fmt::format("residual vibration at most {} {} (worst at {} rpm)",
                                        shown.vibration.text(train.residual->value * scene.motion.lift, 4),
                                        range, rpm_text(train.residual->speed)));
    sentences.push_back(fmt::format(
        "acceleration of the output at most {} (normalised), {} {} {}, at {} deg",
        short_text(train.acceleration->value, 5),
        short_text(acceleration_at(scene, train.acceleration->value, train.acceleration->speed), 5),
        shown.motion[2].first.name, range, degrees_at(solution, train.acceleration->at)));
    const DynamicsSpec& spec = *scene.dynamics;
    const double pressed = spec.preload + spec.return_stiffness * scene.motion.lift;
    if (train.least_force)
        sentences.push_back(fmt::format(
            "force of the train on the cam at least {} {}, at {} deg{}",
            shown.load.text(train.least_force->value, 5), range, degrees_at(solution, train.least_force->at),
            train.least_force->value < -no_train_force * pressed ? ": THE FOLLOWER LIFTS OFF" : ""));
    return sentences;
}

std::vector<std::string> drive_sentences(const Solution& solution) {
    if (!solution.drive) return {};
    const DriveFigures& drive = *solution.drive;
    const Scene& scene = solution.scene;
    const ShownUnits shown = shown_units(scene);
    const auto at = [&](const Extremum& one) { return degrees_at(solution, one.at); };
    std::vector<std::string> sentences = {
        fmt::format("motor: torque at most {} at {} deg, rms {} over the cycle",
                    shown.torque.text(drive.torque.value), at(drive.torque),
                    shown.torque.text(drive.rms_torque)),
        fmt::format("motor: speed at most {} at {} deg, power at most {} W at {} deg",
                    rpm_shown.text(drive.speed.value), at(drive.speed), short_text(drive.power.value),
                    at(drive.power))};
    if (const std::optional<double> ratio = scene.drive->inertia_ratio())
        sentences.push_back(
            fmt::format("motor: the load's inertia is {} times its own", short_text(*ratio, 4)));
    if (scene.drive->transmission_range)
        sentences.push_back(
            fmt::format("motor: a transmission of {} was found best",
                        transmission_shown(scene.motion, scene.length_unit).text(scene.drive->transmission)));
    if (!scene.limits.motor_curve.empty())
        sentences.push_back(fmt::format("motor: nearest to its torque-speed curve at {} deg, {} % of it",
                                        at(drive.share_of_curve),
                                        short_text(100.0 * drive.share_of_curve.value, 4)));
    return sentences;
}

}  // namespace camopt
