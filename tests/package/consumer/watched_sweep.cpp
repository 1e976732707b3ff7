// SPDX-License-Identifier: MIT
// A sweep with progress that is stopped after its third row, and a cam drawn into memory.
#include <camopt/disk_cam.hpp>
#include <camopt/drawings.hpp>
#include <camopt/solve.hpp>
#include <camopt/sweep.hpp>
#include <camopt/units.hpp>
#include <iostream>
#include <vector>

int main() {
    using namespace camopt;
    Scene scene;
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 8 * units::millimetre;
    scene.motion.rise = 90 * units::degree;
    scene.spline.segments = 12;
    scene.objective.velocity = 1.0;
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 40 * units::millimetre);
    scene.cam->set(DimensionIndex::roller_radius, 8 * units::millimetre);

    bool told = false;
    int rows = 0;
    SolveControl control;
    control.progress = [&](const Progress& progress) { told = told || progress.incumbent.has_value(); };
    control.stop_requested = [&] { return rows >= 3; };
    const std::vector<double> weights = {0.1, 0.2, 0.3, 0.4, 0.5};
    const std::vector<SweptScene> swept = sweep(
        scene, weights, [](Scene& one, double weight) { one.objective.jerk = weight; }, control,
        [&](const SweptScene&) { ++rows; });
    std::cout << swept.size() << " rows, progress " << (told ? "told" : "not told") << '\n';

    const Solution& last = swept.back().solution;
    const ProfileDxf drawing = cam_dxf(last, 1e-6);
    std::cout << name_of(last.certificate.verdict) << ", cam of " << drawing.text.size() / 1000 << " kB\n";
    return drawing.text.find("EOF") == std::string::npos;
}
