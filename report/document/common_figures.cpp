// SPDX-License-Identifier: MIT
#include "report/document/common_figures.hpp"

namespace camopt {

std::vector<Figure> verdict_figures(const Certificate& certificate) {
    return {{{"verdict"}, name_of(certificate.verdict)},  {{"reason"}, name_of(certificate.reason)},
            {{"objective"}, Cell(certificate.objective)}, {{"bound.lower"}, Cell(certificate.lower_bound)},
            {{"bound.gap"}, Cell(certificate.gap)},       {{"bound.proof"}, name_of(certificate.proof_kind)}};
}

const char* tone_of(Verdict verdict) {
    if (verdict == Verdict::optimal || verdict == Verdict::local) return "good";
    return verdict == Verdict::feasible ? "fair" : "bad";
}

std::vector<Figure> drive_figures(const Scene& scene, const DriveFigures& drive) {
    const ShownUnits units = file_units(scene);
    const auto peak = [&](const char* key, const ShownUnit& unit, const Extremum& figure) {
        return Figure{{key, {}, unit}, Cell(figure.value), scene.motion.unit_angle() * figure.at};
    };
    const ShownUnit watts("W", 1.0, "_w");
    std::vector<Figure> all = {peak("peak_torque", units.torque, drive.torque),
                               {{"rms_torque", {}, units.torque}, Cell(drive.rms_torque)},
                               peak("peak_speed", rpm_shown, drive.speed),
                               peak("peak_power", watts, drive.power),
                               {{"inertia_ratio"}, Cell(scene.drive->inertia_ratio())}};
    if (scene.drive->transmission_range)
        all.push_back({{"transmission", {}, transmission_shown(scene.motion, LengthUnit::millimetre)},
                       Cell(scene.drive->transmission)});
    if (!scene.limits.motor_curve.empty()) all.push_back(peak("share_of_curve", {}, drive.share_of_curve));
    return all;
}

}  // namespace camopt
