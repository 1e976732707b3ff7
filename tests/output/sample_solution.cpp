// SPDX-License-Identifier: MIT
#include "sample_solution.hpp"

#include <numbers>

namespace camopt::test {

namespace {

SplineCurve four_segments() {
    Eigen::MatrixXd pieces(4, 4);
    const double jerk[] = {32, -32, -32, 32}, h = 0.25;
    double y = 0.0, v = 0.0, a = 0.0;
    for (int i = 0; i < 4; ++i) {
        pieces.col(i) << y, v, a / 2, jerk[i] / 6;
        y += v * h + a * h * h / 2 + jerk[i] * h * h * h / 6;
        v += a * h + jerk[i] * h * h / 2;
        a += jerk[i] * h;
    }
    return SplineCurve(SplineSpace::uniform(3, 2, 4, 1.0), pieces);
}

DualityProof small_proof() {
    DualityProof proof;
    proof.statement = "objective";
    proof.variables = {"a", "b", "c"};
    proof.cost = Eigen::Vector3d(1.0 / 3.0, 0.1, -2e-17);
    proof.constant = 0.25;
    proof.rows = {"first", "second"};
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
    solution.peaks.velocity = {2.0, 0.5};
    solution.peaks.acceleration = {8.0, 0.25};
    solution.peaks.jerk = {32.0, 0.0};
    solution.peaks.torque = {9.0, 0.375};
    solution.peaks.rms_velocity = 1.2;
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
    solution.solver = {"structured", "the scene is convex", Termination::converged, "optimal", 12, 2,
                       "structured"};
    solution.evaluations.cost = 18;
    solution.seconds_total = 0.004;
    solution.seconds_solve = 0.003;
    solution.notes = {"via point 1 follows from symmetry"};
    return solution;
}

Solution infeasible_solution() {
    Solution solution = sample_solution();
    solution.curve.reset();
    solution.peaks = {};
    solution.certificate = {};
    solution.certificate.verdict = Verdict::infeasible;
    solution.constraints.clear();
    solution.design = {};
    solution.relaxation = {{"limits.velocity_mm_s", 100.0, 312.5}, {"limits.jerk", 1.0, std::nullopt}};
    return solution;
}

}  // namespace camopt::test
