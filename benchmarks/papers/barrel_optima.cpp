// SPDX-License-Identifier: MIT
#include "benchmarks/papers/spatial_methods.hpp"
#include "benchmarks/papers/spatial_tables.hpp"
#include "core/numbers/extremum.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "scene/cam_flanks.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/solve/solve.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>

namespace camopt::spatial_tables {

namespace {

using units::degree;
using units::millimetre;

// Chosen: below the 43.8 deg of the modified sine on this cam, and the round limit of handbooks for indexing.
constexpr double limit_here_deg = 42.0, limit_smallest_deg = 40.0, undercut_margin = 0.5;
constexpr double least_distance = 120.0 * millimetre, most_distance = 250.0 * millimetre;
constexpr double distance_weight = 10.0;  // so much that the distance decides
constexpr double rise = 160.0 * degree;

Scene barrel_scene(const Example& example, double limit_deg, bool smallest) {
    Scene scene;
    scene.motion.lift = 2.0 * std::numbers::pi / 7.0;
    scene.motion.lift_is_angle = true;
    scene.motion.rise = rise;
    scene.spline.degree = 5;
    scene.spline.segments = 16;
    scene.spline.continuity = 3;
    scene.objective.velocity = scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    scene.cam = spatial_spec(SpatialFollower::barrel);
    const SpatialCam& cam = example.cam;
    const auto set = [&](SpatialNumber number, const Dimension& value) {
        scene.cam->dimensions[static_cast<std::size_t>(number)].value = value;
    };
    for (int i = 0; i < spatial_dimension_count; ++i)
        set(static_cast<SpatialNumber>(i), cam[static_cast<SpatialDimension>(i)]);
    set(SpatialNumber::roller_length, cam.roller_length);
    set(SpatialNumber::start, cam.start);
    if (smallest) {
        set(SpatialNumber::center_distance, {least_distance, most_distance});
        scene.objective.dimensions[static_cast<std::size_t>(DimensionIndex::center_distance)] =
            distance_weight;
    }
    scene.limits.pressure_angle =
        WrittenLimit{limit_deg * degree, "limits.pressure_angle_deg", degree, "deg"};
    scene.limits.undercut_margin = WrittenLimit{undercut_margin, "limits.undercut_margin", 1.0, ""};
    return scene;
}

double largest_angle(const SpatialCam& cam, const FollowerMotion& motion) {
    return std::max(largest_pressure_angle(cam, motion, 0.0).value,
                    largest_pressure_angle(cam, motion, cam.roller_length).value);
}

/// The smallest distance of the axes at which the motion keeps the limit.
double needed_distance(SpatialCam cam, const FollowerMotion& motion, double limit) {
    constexpr int bisections = 50;
    const auto keeps = [&](double distance) {
        cam[SpatialDimension::center_distance] = distance;
        return largest_angle(cam, motion) <= limit;
    };
    return bisected(keeps, {most_distance, cam.roller_length + 50.0 * millimetre}, bisections).with;
}

PaperSeries angle_at_tip(const std::string& title, const SpatialCam& cam, const FollowerMotion& motion) {
    PaperSeries series{title, {}, {}};
    constexpr int angles = 321;
    for (const double theta : even_angles(motion, angles)) {
        const SpatialPoint point = spatial_point(cam, theta, motion.state(theta), {cam.roller_length, 1});
        series.x.push_back((theta - motion.begin()) / degree);
        series.y.push_back(point.pressure_angle / degree);
    }
    return series;
}

class Rows {
 public:
    explicit Rows(BarrelOptima& target) : target_(target) {}

    void add(const std::string& name, const SpatialCam& cam, const FollowerMotion& motion, const Peaks& peaks,
             const std::string& remark) {
        const HeightRange roller{0.0, cam.roller_length};
        const double g = std::min(least_undercut(cam, motion, 1, roller).value,
                                  least_undercut(cam, motion, -1, roller).value);
        target_.table.rows.push_back({name, cam[SpatialDimension::center_distance] / millimetre,
                                      largest_angle(cam, motion) / degree, g, peaks.velocity.value,
                                      peaks.acceleration.value, peaks.jerk.value, remark});
    }

 private:
    BarrelOptima& target_;
};

const char* word_of(Verdict verdict) {
    if (verdict == Verdict::optimal) return "proved optimal";
    return verdict == Verdict::local ? "local optimum, the best of several starts"
                                     : "satisfies every limit; the search ended before an optimum was found";
}

}  // namespace

BarrelOptima barrel_optima(const Example& example, const SolveControl& control,
                           const PaperProgress& finished) {
    BarrelOptima result;
    result.table = {
        "optimised",
        "An optimised motion and the modified sine",
        fmt::format("Quintic spline of 16 segments; 0.4 V + 0.4 A + 0.2 J over those of the modified "
                    "sine; |φ| limited to {} deg, or to {} deg with the distance of the axes free; g >= {}.",
                    limit_here_deg, limit_smallest_deg, undercut_margin),
        {{"motion", "motion", ""},
         {"center_distance_mm", "l3", "mm", 7},
         {"pressure_angle_deg", "largest |φ|", "deg", 7},
         {"least_g", "least g", "", 5},
         {"velocity", "V", "", 5},
         {"acceleration", "A", "", 5},
         {"jerk", "J", "", 5},
         {"remark", "remark", ""}},
        {}};
    result.figure = {"optimised_pressure_angle",
                     "Pressure angle at the roller's tip, l3 = 150 mm",
                     "cam angle of the index, deg",
                     "pressure angle, deg",
                     {}};
    Rows rows(result);
    const Peaks law = make_law("modified_sine")->peaks();
    FollowerMotion sine = example.motion;
    sine.breakpoints.erase(sine.breakpoints.begin());  // without the dwell
    rows.add("modified sine", example.cam, sine, law, "");
    result.figure.series.push_back(angle_at_tip("modified sine", example.cam, sine));
    for (const bool smallest : {false, true}) {
        const double limit = smallest ? limit_smallest_deg : limit_here_deg;
        if (smallest) {
            SpatialCam cam = example.cam;
            cam[SpatialDimension::center_distance] = needed_distance(cam, sine, limit * degree);
            rows.add("modified sine", cam, sine, law, fmt::format("the l3 that it needs for {} deg", limit));
        }
        const Solution solution = solve(barrel_scene(example, limit, smallest), control);
        const Verdict verdict = solution.certificate.verdict;
        if (!solution.motion || verdict == Verdict::failed || verdict == Verdict::infeasible) {
            result.faults.push_back(fmt::format("no motion was found under {} deg", limit));
            continue;
        }
        const FollowerMotion motion = follower_motion(*solution.motion, motion_scale(solution.scene));
        const SpatialCam cam = spatial_cam(solution.scene.cam.value(), solution.cam->cam.dimensions);
        rows.add("optimised", cam, motion, solution.peaks, word_of(verdict));
        if (!smallest) result.figure.series.push_back(angle_at_tip("optimised", cam, motion));
        if (finished) finished(fmt::format("optimum under {} deg", limit));
    }
    return result;
}

}  // namespace camopt::spatial_tables
