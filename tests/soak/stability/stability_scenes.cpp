// SPDX-License-Identifier: MIT
#include "tests/soak/stability/stability_scenes.hpp"

#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "input/loading/load_scene.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

namespace camopt::stability {

namespace {

/// A figure printed with so many decimals is known to half the last one.
Expectation printed(double objective, double last_decimal, std::string source) {
    Expectation expected = exactly(objective, std::move(source));
    expected.digits = 0.5 * last_decimal / objective;
    return expected;
}

std::optional<Expectation> fraction(int segments) {
    const auto make = [](double velocity, double acceleration, double jerk) {
        return exactly(study_objective(velocity, acceleration, jerk), "fraction");
    };
    switch (segments) {
        case 4:
            return make(2.0, 8.0, 32.0);
        case 6:
            return make(2.0, 6.0, 36.0);
        case 8:
            return make(2.0, 16.0 / 3, 128.0 / 3);
        case 10:
            return make(5.0 / 3, 50.0 / 9, 500.0 / 9);
        case 12:
            return make(12.0 / 7, 36.0 / 7, 432.0 / 7);
        case 16:
            return make(16.0 / 9, 256.0 / 45, 2048.0 / 45);
        default:
            return {};
    }
}

struct Printed {
    MotionType type;
    int degree, segments;
    double objective, last_decimal;
};

std::optional<Expectation> linear_program(MotionType type, int degree, int segments) {
    using enum MotionType;
    static const Printed table[] = {{drd, 3, 32, 0.938020776, 1e-9},      {drd, 3, 64, 0.9374118703, 1e-10},
                                    {drd, 3, 128, 0.9373927539, 1e-10},   {drd, 3, 256, 0.9372204408, 1e-10},
                                    {drd, 3, 512, 0.9372090807, 1e-10},   {drd, 3, 1024, 0.9371969944, 1e-10},
                                    {drd, 3, 2048, 0.9371965704, 1e-10},  {drd, 3, 4096, 0.9371964916, 1e-10},
                                    {drd, 3, 16384, 0.9371963733, 1e-10}, {drd, 5, 8, 0.981910672, 2e-8},
                                    {drd, 5, 12, 0.957101375, 2e-8},      {drd, 5, 16, 0.953251487, 2e-8},
                                    {drd, 5, 24, 0.946894763, 2e-8},      {drd, 5, 32, 0.940832852, 2e-8},
                                    {drd, 5, 64, 0.938201615, 2e-8},      {rr, 3, 16, 0.864227617, 1e-9},
                                    {rr, 3, 24, 0.856144381, 1e-9},       {rr, 3, 32, 0.855556437, 1e-9},
                                    {rr, 3, 64, 0.853505489, 1e-9},       {rr, 3, 96, 0.852675861, 1e-9}};
    for (const Printed& row : table)
        if (row.type == type && row.degree == degree && row.segments == segments)
            return printed(row.objective, row.last_decimal, "linear program, HiGHS");
    return {};
}

}  // namespace

namespace {

void set_peaks(soak::SceneTable& table, const PeakNumbers& peaks) {
    table.set("velocity", peaks.velocity);
    table.set("acceleration", peaks.acceleration);
    table.set("jerk", peaks.jerk);
}

}  // namespace

void set_weights(SceneText& scene, const PeakNumbers& weights) {
    set_peaks(scene.at("objective"), weights);
}

void set_reference(SceneText& scene, const PeakNumbers& peaks) {
    soak::SceneTable reference;
    set_peaks(reference, peaks);
    scene.at("objective").set("reference", inline_text(reference));
}

void set_solver(SceneText& scene, std::string_view name) {
    scene.at("solver").set("name", soak::quoted(name));
}

void set_tie_break(SceneText& scene, TieBreak ties) {
    scene.at("objective").set("tie_break", soak::quoted(name_of(ties)));
}

SceneText study_scene(const std::string& toml, std::string_view backend) {
    SceneText scene = SceneText::parse(toml);
    set_weights(scene, {0.4, 0.4, 0.2});
    set_reference(scene, {1.76, 5.53, 69.0});
    set_solver(scene, backend);
    return scene;
}

SceneText study_scene(MotionType type, int degree, int segments) {
    // Any rise that leaves room for the return.
    return study_scene(
        fmt::format("[motion]\ntype = \"{}\"\nrise_rad = 2.0\n[spline]\ndegree = {}\nsegments = {}\n"
                    "design = \"states\"\n",
                    name_of(type), degree, segments));
}

double study_objective(double velocity, double acceleration, double jerk) {
    return 0.4 * velocity / 1.76 + 0.4 * acceleration / 5.53 + 0.2 * jerk / 69.0;
}

Scene scene_of_text(const std::string& toml) {
    return scene_of_toml(toml, {}, "stability");
}

std::string text_of_file(const std::string& name) {
    return read_text_file(std::string(CAMOPT_SOURCE_DIR) + "/scenes/" + name);
}

Expectation known_optimum(MotionType type, int degree, int segments) {
    if (type == MotionType::drd && degree == 3)
        if (const auto known = fraction(segments)) return *known;
    if (const auto known = linear_program(type, degree, segments)) return *known;
    if (type == MotionType::drd && degree == 5 && segments > 64) {
        Expectation expected = exactly(0.938201615, "the limit of any curve; 64 segments, which it contains");
        expected.least = any_curve_limit_of_study;
        expected.digits = 2e-8;
        return expected;
    }
    return proved_optimum(study_scene(type, degree, segments), "structured, states, proved");
}

Expectation proved_optimum(SceneText scene, std::string source) {
    set_solver(scene, "structured");
    scene.at("solver").set("tolerance", 1e-11);
    set_tie_break(scene, TieBreak::none);
    const Certificate certificate = solve_without_explaining(scene_of(scene), {}).certificate;
    constexpr double worst_gap = 1e-8;
    if (certificate.verdict != Verdict::optimal || !(*certificate.gap <= worst_gap))
        throw ModelError(fmt::format("{}: no reference, {} {}, gap {}", source, name_of(certificate.verdict),
                                     name_of(certificate.reason), certificate.gap.value_or(infinity)));
    Expectation expected;
    expected.least = *certificate.lower_bound;
    expected.most = certificate.objective;
    expected.source = std::move(source);
    return expected;
}

StabilityCase make_case(std::string group, std::string name, bool quick, std::function<StabilityRow()> run) {
    const auto labelled = [group, name, run = std::move(run)] {
        StabilityRow row;
        try {
            row = run();
        } catch (const std::exception& error) {
            row.judgement = Judgement::wrong;
            row.why = error.what();
        }
        row.group = group;
        row.name = name;
        return row;
    };
    return {group, name, quick, labelled};
}

std::string text_of(double value) {
    return fmt::format("{:.6g}", value);
}

}  // namespace camopt::stability
