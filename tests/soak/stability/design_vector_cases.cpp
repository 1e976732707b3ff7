// SPDX-License-Identifier: MIT
#include "tests/soak/stability/condition_number.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

namespace camopt::stability {

namespace {

constexpr MotionType drd = MotionType::drd;

struct DesignCase {
    int degree = 3;
    DesignKind kind = DesignKind::states;
    int segments = 0;
    std::string backend = "structured";
};

StabilityRow run(const DesignCase& one) {
    SceneText scene = study_scene(drd, one.degree, one.segments);
    scene.at("spline").set("design", soak::quoted(name_of(one.kind)));
    set_solver(scene, one.backend);
    set_tie_break(scene, TieBreak::none);
    scene.at("solver").set("max_seconds", 20.0);
    Expectation expected = known_optimum(drd, one.degree, one.segments);
    expected.honest_gap = true;
    const bool promised = one.segments <= 64 || (one.kind == DesignKind::states && one.degree == 3);
    expected.may_give_up = !promised || one.backend != "structured";
    StabilityRow row = solved_row(scene, expected);
    constexpr int most_for_singular_values = 256;
    if (one.segments <= most_for_singular_values && row.judgement != Judgement::absent) {
        row.condition_acceleration = condition_number(scene_of(scene), one.kind, 2);
        row.condition_jerk = condition_number(scene_of(scene), one.kind, 3);
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
    const auto add_splines = [&](int degree, const std::vector<int>& counts) {
        for (const int segments : counts)
            cases.push_back(make_case("many segments",
                                      fmt::format("{} n = {}", degree == 3 ? "cubic" : "quintic", segments),
                                      false, [degree, segments] {
                                          SceneText scene = study_scene(drd, degree, segments);
                                          set_tie_break(scene, TieBreak::none);
                                          scene.at("solver").set("max_seconds", 120.0);
                                          Expectation expected = known_optimum(drd, degree, segments);
                                          expected.may_give_up = degree == 5;
                                          return solved_row(scene, expected);
                                      }));
    };
    add_splines(3, {512, 1024, 2048, 4096, 16384});
    add_splines(5, {512, 1024});
    return cases;
}

}  // namespace camopt::stability
