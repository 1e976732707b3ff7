// SPDX-License-Identifier: MIT
#include "studies/machine/machine_speed.hpp"

#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"
#include "scene/written_limits.hpp"
#include "studies/least/monotone.hpp"

namespace camopt {

namespace {

/// Of the motor what constant force and friction leave: the torque that holds.
void stand_still(Scene& scene) {
    DriveSpec& drive = *scene.drive;
    drive.load = drive.motor_inertia = drive.viscous = 0.0;
    LimitSpec& limits = scene.limits;
    limits.motor_speed.reset();
    if (!limits.motor_curve.empty()) {
        const double most = limits.motor_curve.front()[1];
        if (!limits.motor_torque || limits.motor_torque->value > most)
            limits.motor_torque = WrittenLimit(most, "limits.motor_curve", 1.0, "N m");
        limits.motor_curve.clear();
    }
    // Nothing is weighed at standstill, and a reference law may have no torque there.
    scene.objective = {};
    scene.objective.jerk = 1.0;
}

}  // namespace

Scene at_speed(const Scene& scene, double speed) {
    Scene changed = scene;
    changed.motion.speed = speed;
    keep_written(changed, scene.motion);
    return changed;
}

std::vector<Scene> scenes_at(const MachineSpec& machine, double speed) {
    std::vector<Scene> scenes;
    scenes.reserve(machine.axes.size());
    for (const AxisSpec& axis : machine.axes) {
        scenes.push_back(with_written_limits(at_speed(axis.scene, speed)));
        scenes.back().motion.phase = axis.phase;
    }
    return scenes;
}

std::vector<Scene> scenes_at_standstill(const MachineSpec& machine) {
    std::vector<Scene> scenes = scenes_at(machine, machine.least_speed);
    for (Scene& scene : scenes) {
        for (const PeakLimitRow& row : peak_limit_rows())
            if (auto& limit = row.in(scene.limits); limit && limit->in_time()) limit.reset();
        for (const LimitRow& row : limit_rows())
            if (row.needs_forces || row.needs_dynamics) row.in(scene.limits).reset();
        if (scene.drive) stand_still(scene);
    }
    return scenes;
}

bool standstill_is_any_speed(const Scene& scene) {
    const bool relieved = scene.drive && scene.drive->viscous > 0.0 && scene.motion.relative;
    return !relieved && !has_points_in_time(scene.motion);
}

}  // namespace camopt
