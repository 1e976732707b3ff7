// SPDX-License-Identifier: MIT
#include "benchmarks/stability/condition_number.hpp"
#include "benchmarks/stability/stability_cases.hpp"
#include "benchmarks/stability/stability_scenes.hpp"

#include <fmt/format.h>

namespace camopt::stability {

namespace {

constexpr MotionType drd = MotionType::drd;

// A dense form may give up; what it calls optimal has to be. `states` has no such excuse.
const std::vector<Verdict> honest = {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::failed};

struct DesignCase {
    int degree = 3;
    DesignKind kind = DesignKind::states;
    int segments = 0;
    std::string backend = "structured";
};

StabilityRow run(const DesignCase& one) {
    Scene scene = study_scene(drd, one.degree, one.segments);
    scene.spline.design = one.kind;
    scene.solver.name = one.backend;
    scene.objective.tie_break = TieBreak::none;
    scene.solver.max_seconds = 20.0;
    Expectation expected = known_optimum(drd, one.degree, one.segments);
    expected.honest_gap = true;
    const bool promised = one.kind == DesignKind::states || one.segments <= 64;
    if (!promised || one.backend != "structured") expected.verdicts = honest;
    StabilityRow row = solved_row(scene, expected);
    constexpr int most_for_singular_values = 256;
    if (one.segments <= most_for_singular_values && row.judgement != Judgement::absent) {
        row.condition_acceleration = condition_number(scene, one.kind, 2);
        row.condition_jerk = condition_number(scene, one.kind, 3);
    }
    return row;
}

void add(std::vector<StabilityCase>& cases, const DesignCase& one) {
    const std::string name =
        fmt::format("{} {} n = {}", one.degree == 3 ? "cubic" : "quintic", name_of(one.kind), one.segments);
    const bool quick = one.segments <= (one.degree == 3 ? 32 : 16) && one.backend == "structured";
    cases.push_back(make_case("design vectors", name, quick, [one] { return run(one); }));
}

}  // namespace

std::vector<StabilityCase> design_vector_cases() {
    std::vector<StabilityCase> cases;
    for (const int degree : {3, 5})
        for (const DesignKind kind : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states})
            for (const int segments : {4, 8, 16, 32, 64, 128, 256}) add(cases, {degree, kind, segments});
    for (const DesignKind kind : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states})
        for (const int segments : {12, 32}) {
            add(cases, {3, kind, segments, "ipopt"});
            add(cases, {3, kind, segments, "nlopt.slsqp"});
        }
    return cases;
}

std::vector<StabilityCase> many_segment_cases() {
    std::vector<StabilityCase> cases;
    for (const int segments : {512, 1024, 2048, 4096, 16384})
        cases.push_back(make_case("many segments", fmt::format("cubic n = {}", segments), false, [segments] {
            Scene scene = study_scene(drd, 3, segments);
            scene.objective.tie_break = TieBreak::none;
            scene.solver.max_seconds = 120.0;
            Expectation expected = known_optimum(drd, 3, segments);
            expected.accuracy = segments > 4096 ? 1e-8 : 1e-9;
            return solved_row(scene, expected);
        }));
    for (const int segments : {512, 1024})
        cases.push_back(
            make_case("many segments", fmt::format("quintic n = {}", segments), false, [segments] {
                Scene scene = study_scene(drd, 5, segments);
                scene.objective.tie_break = TieBreak::none;
                scene.solver.max_seconds = 120.0;
                // Between the limit of any curve and the optimum of 64 segments, whose space it contains.
                Expectation expected = exactly(0.938201615, "the limit of any curve; 64 segments");
                expected.least = 0.9371963699;
                expected.digits = 1e-8;
                return solved_row(scene, expected);
            }));
    return cases;
}

}  // namespace camopt::stability
