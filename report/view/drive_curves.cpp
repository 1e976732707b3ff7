// SPDX-License-Identifier: MIT
// Torque and speed of the motor by the angle of the master, beside those of the reference law.
#include "report/view/peak_comparison.hpp"
#include "report/view/view.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

struct DriveRow {
    const char* key = nullptr;
    const char* title = nullptr;
    const char* symbol = nullptr;
    ShownUnit unit;
    double DrivePoint::*value = nullptr;
    Extremum largest;
};

Curve drive_curve(const View& view, const DriveAlong& along, const DriveRow& row, const Motion* law,
                  const std::string& law_title) {
    Curve curve{row.key, "motor", row.title, row.symbol, row.unit};
    for (const DeliveredRow& place : view.delivered.rows)
        curve.values.push_back(row.unit.of(place.drive.value().*row.value));
    if (law != nullptr) {
        curve.reference = ComparedCurve{law_title, {}};
        for (const DeliveredRow& place : view.delivered.rows) {
            const double x = std::clamp(place.x, law->begin(), law->end());
            curve.reference->values.push_back(
                row.unit.of(along.at(law->at(x, place.side), place.side).*row.value));
        }
    }
    const double value = curve.values[view.delivered.index_at(row.largest.at)];
    const double signed_value = std::copysign(row.unit.of(row.largest.value), value);
    curve.marks.push_back({view.degrees(row.largest.at), signed_value,
                           row.unit.text(std::copysign(row.largest.value, value), curve_mark_digits)});
    return curve;
}

/// A line at `at` (SI); `outside`: the side that violates it.
void add_line(Curve& curve, const View& view, double at, int outside) {
    curve.limits.push_back({view.angles.front(), view.angles.back(), curve.unit.of(at), outside,
                            "limit " + curve.unit.text(at)});
}

}  // namespace

std::vector<Curve> drive_curves(const View& view) {
    const Scene& scene = view.solution.scene;
    const DriveAlong along(scene);
    const DriveFigures& figures = *view.solution.drive;
    ReferenceMotion reference = reference_motion(scene);
    const std::shared_ptr<const Motion> law = reference_curve(view.solution, reference);
    std::vector<Curve> all = {
        drive_curve(view, along,
                    {"motor_torque", "Torque of the motor", "τ", view.units.torque, &DrivePoint::torque,
                     figures.torque},
                    law.get(), reference.title),
        drive_curve(view, along,
                    {"motor_speed", "Speed of the motor", "n", rpm_shown, &DrivePoint::speed, figures.speed},
                    law.get(), reference.title)};
    all[0].note = fmt::format("rms {} over the cycle", view.units.torque.text(figures.rms_torque));
    const LimitSpec& limits = scene.limits;
    for (const int side : {1, -1}) {
        if (limits.motor_torque) add_line(all[0], view, side * limits.motor_torque->value, side);
        if (limits.motor_speed) add_line(all[1], view, side * limits.motor_speed->value, side);
    }
    if (limits.motor_torque_min) add_line(all[0], view, limits.motor_torque_min->value, -1);
    if (limits.motor_torque_max) add_line(all[0], view, limits.motor_torque_max->value, 1);
    return all;
}

}  // namespace camopt
