// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "motions/bounds/smallest_cam.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/view/number_text.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace camopt::stability {

namespace {

/// A figure printed with this many units in its last place.
Expectation printed(double value, double last, std::string source) {
    Expectation expected = exactly(value, std::move(source), 0.0);
    expected.digits = 0.5001 * last / std::abs(value);
    return expected;
}

class Claims {
 public:
    void add(const std::string& name, bool quick, std::function<StabilityRow()> run) {
        list.push_back(make_case("claims", name, quick, std::move(run)));
    }
    std::vector<StabilityCase> list;
};

StabilityRow first_scene() {
    const SceneText scene = SceneText::parse(
        "[motion]\ntype = \"DRD\"\nlift_mm = 10\nrise_deg = 120\n[spline]\ndegree = 3\nsegments = 12\n"
        "[objective]\nvelocity = 0.4\nacceleration = 0.4\njerk = 0.2\n");
    return solved_row(scene, printed(0.93951, 1e-5, "README.md: 0.93951, optimal"));
}

StabilityRow file_row(const std::string& file, double objective, double last, Verdict verdict) {
    Expectation expected = printed(objective, last, "docs: " + file);
    expected.verdicts = {verdict};
    return solved_row(SceneText::parse(text_of_file(file)), expected);
}

/// The scene at the loosest and the tightest tolerance it may ask for.
StabilityRow with_tolerance(double tolerance, double gap) {
    SceneText scene = study_scene(MotionType::drd, 3, 12);
    scene.at("solver").set("tolerance", tolerance);
    scene.at("solver").set("gap", gap);
    Expectation expected = exactly(study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7), "fraction");
    expected.honest_gap = true;
    expected.accuracy = std::max(1e-9, tolerance);
    expected.violation = std::max(1e-9, tolerance);
    expected.may_give_up = gap < 1e-11;
    return solved_row(scene, expected);
}

StabilityRow dimension_of_smallest_cam() {
    const Solution solution = solve(scene_of_file("cam_smallest.toml"));
    return figure_row(
        "base radius, mm",
        disk_cam(solution.cam.value().cam).value()[DimensionIndex::base_radius] / units::millimetre,
        printed(29.3502, 1e-4, "docs/cams.md"));
}

StabilityRow smallest_of_any_motion() {
    const double spiral = 20.0 / (std::exp(std::numbers::pi / 3 * std::tan(std::numbers::pi / 6)) - 1.0);
    const Solution solution = solve(scene_of_file("cam_smallest.toml"));
    return figure_row("prime radius, mm",
                      solution.cam.value().smallest.value().prime_radius / units::millimetre,
                      exactly(spiral, "h / (exp(β tan φm) − 1) = 24.0813", 1e-12));
}

/// What would help an infeasible cam, from docs/cams.md.
StabilityRow needed(const std::string& key, double value, double last) {
    const Solution solution = solve(scene_of_file("cam_infeasible.toml"));
    for (const Relaxation& relaxation : solution.relaxation) {
        if (relaxation.key == key) {
            // The summary rounds to the side that helps.
            Expectation expected = exactly(value, "docs/cams.md, rounded to the side that helps", 1e-12);
            expected.least = value - last;
            return figure_row("needed " + key, relaxation.needed.value_or(std::nan("")), expected);
        }
    }
    throw ModelError("no relaxation of " + key);
}

StabilityRow unlimited_drdrd() {
    SceneText scene = SceneText::parse(text_of_file("cam_drdrd.toml"));
    scene.erase("limits");
    return solved_row(scene, printed(0.93877, 1e-5, "docs/programs.md"));
}

Scene compared_scene() {
    return scene_of(study_scene(
        "[motion]\ntype = \"DRD\"\nlift_mm = 20\nrise_deg = 60\n[spline]\nsegments = 24\n[cam]\ntype = "
        "\"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = 30\nroller_radius_mm = "
        "10\n"
        "[limits]\npressure_angle_deg = 30\n",
        "auto"));
}

StabilityRow loss_of_best_law() {
    for (const ComparisonRow& row : compare(compared_scene()).rows)
        if (!row.is_optimum() && row.feasible)
            return figure_row("loss of the one law within the limit, %", row.loss_percent.value(),
                              printed(43, 1, "docs/compare.md"));
    throw ModelError("no law keeps the limit");
}

StabilityRow base_of_modified_sine() {
    for (const ComparisonRow& row : compare(compared_scene()).rows)
        if (row.key == "modified_sine")
            return figure_row("base radius, mm", row.base.value().radius.value() / units::millimetre,
                              printed(39, 1, "docs/compare.md"));
    throw ModelError("no modified sine");
}

/// Doubles of every size, written and read again.
StabilityRow numbers_read_back() {
    std::mt19937_64 random(4);
    int different = 0;
    for (int k = 0; k < 20000; ++k) {
        const double value = std::ldexp(std::uniform_real_distribution<double>(-1.0, 1.0)(random),
                                        std::uniform_int_distribution<int>(-1000, 1000)(random));
        different += number_in(round_trip_text(value)) == value ? 0 : 1;
    }
    Expectation none;
    none.most = 0.0;
    none.accuracy = 0.0;
    none.source = "docs/results.md: numbers read back as the same double";
    return figure_row("of 20000 numbers differ", different, none);
}

}  // namespace

std::vector<StabilityCase> claim_cases() {
    Claims claims;
    claims.add("the first scene", true, first_scene);
    claims.add("cam_drdrd.toml", false,
               [] { return file_row("cam_drdrd.toml", 0.94614, 1e-5, Verdict::optimal); });
    claims.add("cam_drdrd.toml without limits", false, unlimited_drdrd);
    claims.add("cam_undercut.toml", false,
               [] { return file_row("cam_undercut.toml", 0.906610145, 1e-9, Verdict::optimal); });
    for (const auto& [tolerance, gap] : {std::pair{1e-12, 1e-7}, {1e-12, 1e-12}, {1e-9, 1e-9}, {1e-2, 1e-2}})
        claims.add(fmt::format("tolerance {}, gap {}", tolerance, gap), true,
                   [tolerance = tolerance, gap = gap] { return with_tolerance(tolerance, gap); });
    claims.add("cam_smallest.toml: base radius", true, dimension_of_smallest_cam);
    claims.add("cam_smallest.toml: limit of any motion", true, smallest_of_any_motion);
    claims.add("cam_infeasible.toml: pressure angle", false,
               [] { return needed("limits.pressure_angle_deg", 32.27, 0.01); });
    claims.add("cam_infeasible.toml: rise", false, [] { return needed("motion.rise_deg", 65.621, 0.001); });
    claims.add("cam_infeasible.toml: base radius", false,
               [] { return needed("cam.base_radius_mm", 17.006, 0.001); });
    claims.add("cam_infeasible.toml: roller radius", false,
               [] { return needed("cam.roller_radius_mm", 13.006, 0.001); });
    claims.add("cam_infeasible.toml: offset", false, [] { return needed("cam.offset_mm", 1.7734, 1e-4); });
    claims.add("laws on a cam: loss", false, loss_of_best_law);
    claims.add("laws on a cam: modified sine", false, base_of_modified_sine);
    claims.add("numbers in files", true, numbers_read_back);
    for (StabilityCase& one : profile_claims()) claims.list.push_back(std::move(one));
    for (StabilityCase& one : mechanism_claims()) claims.list.push_back(std::move(one));
    return std::move(claims.list);
}

}  // namespace camopt::stability
