// SPDX-License-Identifier: MIT
#include "sample_solution.hpp"

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/delivered/cam_report.hpp"

#include <memory>
#include <numbers>
#include <vector>

namespace camopt::test {

namespace {

/// From x = begin to begin + 1.
SplineCurve four_segments(double begin = 0.0) {
    Eigen::MatrixXd pieces(4, 4);
    const double jerk[] = {32, -32, -32, 32}, h = 0.25;
    double y = 0.0, v = 0.0, a = 0.0;
    for (int i = 0; i < 4; ++i) {
        pieces.col(i) << y, v, a / 2, jerk[i] / 6;
        y += v * h + a * h * h / 2 + jerk[i] * h * h * h / 6;
        v += a * h + jerk[i] * h * h / 2;
        a += jerk[i] * h;
    }
    return {SplineSpace(3, 2, {begin, begin + h, begin + 2 * h, begin + 3 * h, begin + 1.0}), pieces};
}

DualityProof small_proof() {
    DualityProof proof;
    proof.statement = "objective";
    proof.variables = {"a", "b", "c"};
    proof.cost = Eigen::Vector3d(1.0 / 3.0, 0.1, -2e-17);
    proof.constant = 0.25;
    proof.rows = {"first", "limits.jerk (face) at x = 0.25-"};
    proof.origins = {{"first", {}, {}, Side::right, false},
                     {"limits.jerk", "face", 0.25, Side::left, true, 3, -1}};
    proof.matrix.resize(2, 3);
    proof.matrix.insert(0, 0) = std::numbers::pi;
    proof.matrix.insert(0, 2) = -1.0;
    proof.matrix.insert(1, 1) = 1e-300;
    proof.lower = Eigen::Vector2d(-infinity, 0.5);
    proof.upper = Eigen::Vector2d(0.7, infinity);
    proof.multipliers = Eigen::Vector2d(0.1, -0.3);
    proof.box = {Eigen::Vector3d(-1, -2, -infinity), Eigen::Vector3d(1, infinity, 3)};
    proof.bound = 1.0 / 7.0;
    return proof;
}

/// The cam of the scene's dimensions on the motion the solution has.
void add_cam(Solution& solution) {
    solution.cam = cam_report(solution.scene, solution.scene.cam->middle(), *solution.motion);
    for (const ConstraintReport& row : cam_constraints(solution.scene, *solution.cam))
        solution.constraints.push_back(row);
}

}  // namespace

Solution sample_solution() {
    Solution solution;
    Scene& scene = solution.scene;
    scene.title = "Four segments & <one> title";
    scene.motion.lift = 0.010;
    scene.motion.rise = std::numbers::pi / 2;
    scene.motion.speed = 10 * std::numbers::pi;
    scene.spline.segments = 4;
    scene.objective.velocity = scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    scene.limits.velocity = PeakLimit{2.5, "limits.velocity_mm_s", 500.0, "mm/s"};
    solution.curve = four_segments();
    solution.motion = std::make_shared<MotionChain>(std::vector<ChainPart>{
        {0.0, 1.0, std::make_shared<SplineCurve>(*solution.curve), 0.0, 1.0, 0.0, 1.0}});
    solution.peaks.velocity = {2.0, 0.5};
    solution.peaks.acceleration = {8.0, 0.25};
    solution.peaks.jerk = {32.0, 0.0};
    solution.peaks.torque = {9.0, 0.375};
    solution.peaks.rms_velocity = 1.2;
    solution.cam_peaks = solution.motion_peaks = solution.peaks;
    solution.reference_peaks.velocity.value = 1.76;
    solution.reference_peaks.acceleration.value = 5.53;
    solution.certificate.verdict = Verdict::optimal;
    solution.certificate.objective = 1.125961;
    solution.certificate.lower_bound = 1.1259609;
    solution.certificate.gap = 1e-7;
    solution.certificate.worst_violation = -0.2;
    solution.certificate.proof_kind = ProofKind::duality;
    solution.certificate.proof = small_proof();
    solution.any_curve_limit = LimitCurve{0.9371963699, 1.7455851, 5.2837114, std::nullopt};
    solution.constraints = {{"velocity", "limits.velocity_mm_s", 500.0, 400.0, "mm/s", 0.5, false}};
    solution.design.kind = DesignKind::ordinates;
    solution.design.names = {"y1"};
    solution.design.values = Eigen::VectorXd::Constant(1, 1.0 / 12.0);
    solution.solver.name = solution.solver.proof_source = "structured";
    solution.solver.choice = "the scene is convex";
    solution.solver.termination = Termination::converged;
    solution.solver.native_status = "optimal";
    solution.solver.iterations = 12;
    solution.solver.exchange_rounds = 2;
    solution.evaluations.cost = 18;
    solution.seconds_total = 0.004;
    solution.seconds_solve = 0.003;
    solution.notes = {"via point 1 follows from symmetry"};
    return solution;
}

Solution cam_solution() {
    Solution solution = sample_solution();
    Scene& scene = solution.scene;
    scene.title = "Four segments on a cam";
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 30 * units::millimetre);
    scene.cam->set(DimensionIndex::roller_radius, 10 * units::millimetre);
    scene.limits.pressure_angle =
        WrittenLimit{30 * units::degree, "limits.pressure_angle_deg", units::degree, "deg"};
    scene.forces = ForceSpec{};
    scene.forces->mass = 2.0;
    scene.forces->spring_rate = 1e4;
    scene.forces->preload = 60.0;
    scene.forces->contact_width = 8 * units::millimetre;
    add_cam(solution);
    return solution;
}

Solution undercut_solution() {
    Solution solution = cam_solution();
    solution.scene.cam->set(DimensionIndex::base_radius, 5 * units::millimetre);
    solution.scene.cam->set(DimensionIndex::roller_radius, 30 * units::millimetre);
    solution.constraints.pop_back();
    add_cam(solution);
    return solution;
}

Solution program_solution() {
    Solution solution = sample_solution();
    MotionSpec& motion = solution.scene.motion;
    motion.type = MotionType::program;
    motion.segments = {{SegmentKind::dwell, 60 * units::degree, {}, {}},
                       {SegmentKind::spline, 90 * units::degree, {}, 1.0},
                       {SegmentKind::dwell, 165 * units::degree, {}, {}},
                       {SegmentKind::law, 45 * units::degree, "modified_sine", 0.0}};
    const double up = 2.0 / 3.0, top = up + 1.0, down = 3.5, end = 4.0;
    const SplineCurve curve = four_segments(up);
    solution.curve.reset();
    solution.motion = std::make_shared<MotionChain>(
        std::vector<ChainPart>{{0.0, up, nullptr, 0.0, 1.0, 0.0, 1.0},
                               {up, top, std::make_shared<SplineCurve>(curve), 0.0, 1.0, 0.0, 1.0},
                               {top, down, nullptr, 0.0, 1.0, 1.0, 1.0},
                               {down, end, make_law("modified_sine"), down, 0.5, 1.0, -1.0}});
    for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque})
        (solution.peaks.*peak).at += up;
    solution.cam_peaks = solution.motion_peaks = solution.peaks;
    solution.motion_peaks.velocity = {2 * 1.7596, 3.75};
    solution.cam_peaks = solution.motion_peaks;
    Peaks law = make_law("modified_sine")->peaks();
    for (Extremum Peaks::*peak : {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk, &Peaks::torque})
        (law.*peak).at = down + (end - down) * (law.*peak).at;
    solution.segments = {{SegmentKind::dwell, {}, 0.0, up, 0.0, 0.0, {}, {}, 2},
                         {SegmentKind::spline, {}, up, top, 0.0, 1.0, solution.peaks, curve, 2},
                         {SegmentKind::dwell, {}, top, down, 1.0, 1.0, {}, {}, 2},
                         {SegmentKind::law, "modified_sine", down, end, 1.0, 0.0, law, {}, 2}};
    solution.any_curve_limit.reset();
    return solution;
}

Solution infeasible_cam_solution() {
    Solution solution = cam_solution();
    solution.curve.reset();
    solution.motion.reset();
    solution.cam.reset();
    solution.peaks = solution.motion_peaks = solution.cam_peaks = {};
    solution.certificate = {};
    solution.certificate.verdict = Verdict::infeasible;
    solution.constraints.clear();
    solution.design = {};
    solution.conflict = {{"limits.pressure_angle_deg", 0.26, 0.4},
                         {"limits.cam_radius_min_mm", 0.9, 0.25},
                         {"limits.pressure_angle_deg", 0.31, 0.2},
                         {"limits.pressure_angle_deg", 0.5, 0.15}};
    solution.relaxation = {{"cam.base_radius_mm", 30.0, 31.41234},
                           {"motion.rise_deg", 60.0, 68.15},
                           {"limits.pressure_angle_deg", 30.0, 33.1},
                           {"limits.cam_radius_min_mm", 4.0, 2.50009},
                           {"cam.roller_radius_mm", 10.0, std::nullopt}};
    return solution;
}

Solution infeasible_solution() {
    Solution solution = sample_solution();
    solution.curve.reset();
    solution.motion.reset();
    solution.peaks = solution.motion_peaks = solution.cam_peaks = {};
    solution.certificate = {};
    solution.certificate.verdict = Verdict::infeasible;
    solution.constraints.clear();
    solution.design = {};
    solution.relaxation = {{"limits.velocity_mm_s", 100.0, 312.5}, {"limits.jerk", 1.0, std::nullopt}};
    return solution;
}

}  // namespace camopt::test
