// SPDX-License-Identifier: MIT
#include "output/report/cam_files.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/chart/curve_chart.hpp"
#include "output/csv/csv_line.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/drawing/dxf/cam_dxf.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "output/drawing/mechanism_svg.hpp"
#include "output/drawing/profile_svg.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/follower_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace camopt {

namespace {

using enum CamView;

constexpr const char* drawing_name = "profile.dxf";
const CamFile force_file = {diagram, "forces.svg", "Force, torque and pressure", ""};

/// The files of a kind and what makes them.
struct KindFiles {
    bool (*is_it)(const CamMechanism&);
    std::vector<CamFile> files;
    std::vector<std::string> (*texts)(const View&, const CamFileOptions&);
};

/// The first that fits.
const std::array<KindFiles, 4>& kinds() {
    static const std::array<KindFiles, 4> all = {{
        {[](const CamMechanism& cam) { return cam.is_direct() && cam.stations() > 1; },
         {{table, "profile.csv", "", ""},
          {picture, "profile.svg", "The cam to scale", ""},
          {diagram, "profile_diagrams.svg", "Pressure angle and curvature", ""},
          {table, "second_profile.csv", "", ""}},
         disk_texts},
        {[](const CamMechanism& cam) { return cam.is_direct(); },
         {{table, "profile.csv", "", ""},
          {picture, "profile.svg", "The cam to scale", ""},
          {diagram, "profile_diagrams.svg", "Pressure angle and curvature", ""}},
         disk_texts},
        {[](const CamMechanism& cam) { return cam.has_guide(); },
         {{table, "guide.csv", "", ""},
          {picture, "guide.svg", "The guide to scale", ""},
          {diagram, "pressure_angle.svg", "Pressure angle", ""}},
         guide_texts},
        {[](const CamMechanism& cam) { return cam.planar(); },
         {{table, "profile.csv", "", ""},
          {picture, "mechanism.svg", "Cam and linkage to scale", ""},
          {diagram, "pressure_angle.svg", "Pressure angle", ""},
          {diagram, "curvature.svg", "Curvature", ""}},
         linkage_texts},
    }};
    return all;
}

/// Null where there are none.
const KindFiles* kind_of(const Solution& solution) {
    if (!solution.cam) return nullptr;
    const auto* const found = std::ranges::find_if(
        kinds(), [&](const KindFiles& kind) { return kind.is_it(*solution.cam->cam.formulas); });
    return found == kinds().end() ? nullptr : &*found;
}

/// Of each point; none where the scene has no forces. Of a cam that drives both ways those of one side: 0
/// along the normal where the other one carries.
std::vector<FollowerLoads> loads_of(const Solution& solution, const Motion& motion,
                                    const MechanismProfile& profile, int side) {
    const LoadsAt loads = delivered_loads(solution);
    if (!loads) return {};
    const double unit_angle = motion_scale(solution.scene).unit_angle;
    std::vector<FollowerLoads> all;
    for (const MechanismPoint& point : profile.points) {
        const double x = std::clamp(point.theta / unit_angle, motion.begin(), motion.end());
        all.push_back(loads(motion.at(x, x < motion.end() ? Side::right : Side::left), point));
        if (all.back().side == side || solution.cam->summary.no_contact) continue;
        all.back().normal_force = 0.0;
        if (all.back().hertz_pressure) all.back().hertz_pressure = 0.0;
    }
    return all;
}

std::string csv_of(const Solution& solution, const Motion& motion, const CamFileOptions& options, int side) {
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionScale scale = motion_scale(solution.scene);
    MechanismProfile profile;
    profile.points = sampled_profile(cam, motion, scale, {options.points, options.chord_tolerance}, side);
    for (const MechanismPoint& point : profile.points) {
        const double x = std::clamp(point.theta / scale.unit_angle, motion.begin(), motion.end());
        profile.outputs.push_back(scale.lift * motion.at(x).derivative[0]);
    }
    ProfileColumns columns{
        .swings = cam.formulas->swings(), .face = !cam.formulas->has_pitch_curve(), .loads = {}};
    columns.loads = loads_of(solution, motion, profile, side);
    columns.pressure = solution.cam->summary.forces && solution.cam->summary.forces->hertz_pressure;
    return profile_csv(profile, columns);
}

using units::degree, units::millimetre;

constexpr int left_wall = 0, right_wall = 1;  // stations of the mechanism

std::string csv_of_walls(const GuideWalls& walls) {
    std::string text =
        "theta_deg,s_mm,middle_x_mm,middle_y_mm,left_x_mm,left_y_mm,right_x_mm,right_y_mm,"
        "pressure_angle_deg,middle_radius_mm,regularity_left,regularity_right\n";
    for (std::size_t i = 0; i < walls.left.points.size(); ++i) {
        const MechanismPoint &left = walls.left.points[i], &right = walls.right.points[i];
        CsvLine line;
        line.number(left.theta / degree).number(walls.left.outputs[i] / millimetre);
        for (const Eigen::Vector3d& place : {left.pitch, left.contact, right.contact})
            line.number(place.x() / millimetre).number(place.y() / millimetre);
        line.number(left.pressure_angle / degree).number(1.0 / (left.pitch_curvature * millimetre));
        line.number(left.regularity).number(right.regularity);
        text += line.finish();
    }
    return text;
}

}  // namespace

std::vector<CamFile> cam_file_list(const Solution& solution) {
    const KindFiles* const kind = kind_of(solution);
    if (kind == nullptr) return {};
    std::vector<CamFile> files = kind->files;
    if (solution.cam->summary.forces) files.push_back(force_file);
    return files;
}

std::vector<CamFile> cam_files(const View& view, const CamFileOptions& options) {
    const Solution& solution = view.solution;
    std::vector<CamFile> files = cam_file_list(solution);
    if (files.empty()) return files;
    std::vector<std::string> texts = kind_of(solution)->texts(view, options);
    if (solution.cam->summary.forces) texts.push_back(force_diagrams_svg(view));
    for (std::size_t i = 0; i < files.size(); ++i) files[i].text = std::move(texts[i]);
    if (options.drawing)
        files.push_back({drawing, drawing_name, "", cam_dxf(solution, options.dxf_tolerance).text});
    return files;
}

std::string cam_view(const View& view, CamView shown, CamFileOptions options) {
    options.drawing = shown == drawing;
    const std::vector<CamFile> files = cam_files(view, options);
    const auto found = std::ranges::find(files, shown, &CamFile::view);
    if (found == files.end())
        throw InputError("a plane profile needs a plane mechanism, and this solution has none");
    return found->text;
}

std::vector<std::string> cam_file_names() {
    std::vector<std::string> names = {drawing_name, force_file.name};
    for (const KindFiles& kind : kinds())
        for (const CamFile& file : kind.files) names.push_back(file.name);
    return names;
}

std::vector<std::string> disk_texts(const View& view, const CamFileOptions& options) {
    const MotionChain drawn = drawn_motion(view.solution);
    const ProfileShape whole = delivered_shape(view.solution, drawn).value();
    std::vector<std::string> texts = {csv_of(view.solution, drawn, options, 0),
                                      profile_svg(whole, view.title("Cam")), cam_diagrams_svg(view)};
    if (whole.other) texts.push_back(csv_of(view.solution, drawn, options, 1));
    return texts;
}

std::vector<std::string> guide_texts(const View& view, const CamFileOptions& options) {
    const MotionChain& motion = *view.delivered.whole;
    const MotionScale& scale = view.delivered.scale;
    const int count = options.points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = view.solution.cam->cam;
    const GuideWalls walls{mechanism_profile(mechanism, motion, scale, count, left_wall),
                           mechanism_profile(mechanism, motion, scale, count, right_wall)};
    return {csv_of_walls(walls), guide_svg(view.solution, walls), cam_diagrams_svg(view, "pressure_angle")};
}

std::vector<std::string> linkage_texts(const View& view, const CamFileOptions& options) {
    const MotionChain motion = drawn_motion(view.solution);
    const MotionScale& scale = view.delivered.scale;
    const int count = options.points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = view.solution.cam->cam;
    const MechanismProfile profile = mechanism_profile(mechanism, motion, scale, count);
    return {profile_csv(profile, {.swings = mechanism.formulas->swings(), .loads = {}}),
            mechanism_svg(view.solution, motion), cam_diagrams_svg(view, "pressure_angle"),
            cam_diagrams_svg(view, "curvature")};
}

}  // namespace camopt
