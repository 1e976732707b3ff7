// SPDX-License-Identifier: MIT
#include "report/spatial/drum_svg.hpp"

#include "report/drawing/picture_page.hpp"
#include "report/spatial/flank_surfaces.hpp"
#include "report/spatial/indexing_body.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using units::degree;

constexpr int drum_angles = 361, drum_sections = 5, drum_corners = 96, core_rings = 24;
constexpr double core_part = 0.985, core_bore = 0.35;  // of the least radius of the flanks
constexpr double longest_bar = 180;                    // px
constexpr std::array<int, 3> core_colour = {150, 160, 172}, flank_colour = {226, 164, 84},
                             roller_colour = {96, 142, 198};

constexpr std::array<PictureStyle, 11> drum_styles = {
    {{"hub", "stroke:#96a0ac;stroke-width:9"},
     {"rib", "stroke:#e2a454;stroke-width:9"},
     {"rollers", "stroke:#608ec6;stroke-width:9"},
     {"bar", "stroke:#222;stroke-width:1.6"},
     {"turned", "stroke:#c4c4c4;stroke-width:1"},
     {"plus", "fill:none;stroke:#0072b2;stroke-width:2"},
     {"plus-deep", "fill:none;stroke:#0072b2;stroke-width:1.4;stroke-dasharray:6 4"},
     {"minus", "fill:none;stroke:#d55e00;stroke-width:2"},
     {"minus-deep", "fill:none;stroke:#d55e00;stroke-width:1.4;stroke-dasharray:6 4"},
     {"axis", "fill:none;stroke:#555;stroke-width:1.2;stroke-dasharray:7 4"},
     {"peak", "fill:#0072b2;stroke:#fff;stroke-width:1.5"}}};
constexpr const char* peak_style =
    ".peak-label{font-weight:600;fill:#005a8c;paint-order:stroke;stroke:#fff;stroke-width:4px}";

FlankGrid drum_grid(const CamFlanks& cam, const FollowerMotion& motion, int sections) {
    return flank_grid(cam, motion, {sections, drum_angles, 0.0, 0.0});
}

struct DrumCore {
    double least_radius = HUGE_VAL, lower = HUGE_VAL, upper = -HUGE_VAL;
};

DrumCore core_size(const FlankGrid& grid) {
    DrumCore size;
    for (const FlankSurface& flank : grid.flanks)
        for (const Vector3d& point : flank.points) {
            size.least_radius = std::min(size.least_radius, std::hypot(point.x(), point.y()));
            size.lower = std::min(size.lower, point.z());
            size.upper = std::max(size.upper, point.z());
        }
    return size;
}

/// A tube with the groove's floor as its outside, as long as the body.
TriangleMesh core_of(const DrumCore& size, const DrumBody& given, double wall) {
    const DrumSize body = body_around({0.0, size.lower, size.upper}, given, wall);
    const double low = body.lower, high = body.upper;
    std::vector<std::vector<Vector3d>> sections;
    for (int k = 0; k < drum_corners; ++k) {
        const double angle = units::turn * k / drum_corners;
        const auto rim = [&](double part, double z) {
            const double radius = part * size.least_radius;
            return Vector3d(radius * std::cos(angle), radius * std::sin(angle), z);
        };
        std::vector<Vector3d> section = {rim(core_bore, high), rim(core_bore, low)};
        for (int i = 0; i <= core_rings; ++i)
            section.push_back(rim(core_part, low + (high - low) * i / core_rings));
        sections.push_back(std::move(section));
    }
    return swept_solid(sections, true);
}

TriangleMesh both_sides(TriangleMesh mesh) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::array<int, 3> t = mesh.triangles[i];
        mesh.triangles.push_back({t[0], t[2], t[1]});
    }
    return mesh;
}

/// The groove ends where it begins, or one pitch of the rollers on.
bool closes(const Drum& drum) {
    constexpr double same = 1e-9;  // of the largest displacement
    const FollowerMotion& motion = drum.motion;
    double largest = 0.0;
    for (const double theta : motion.breakpoints)
        largest = std::max(largest, std::abs(motion.state(theta).s));
    return indexes(drum.cam, motion) ||
           std::abs(motion.state(motion.end()).s - motion.state(motion.begin()).s) <= same * largest;
}

std::string title_of_drum(const Drum& drum) {
    return drum.solution.scene.title.empty() ? "Drum" : drum.solution.scene.title;
}

/// A round number of the unit, at most so many px long: 1, 2 or 5 times a power of ten.
double bar_length(double longest) {
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    for (const double step : {5.0, 2.0})
        if (step * power <= longest) return step * power;
    return power;
}

void draw_scale_bar(SvgCanvas& canvas, double scale, const ShownUnit& length) {
    const double shown = bar_length(length.of(longest_bar / scale)), px = shown * length.size * scale;
    const double x = picture_left + 12, y = picture_top + picture_frame_height - 14;
    canvas.line(x, y, x + px, y, "bar");
    for (const double end : {x, x + px}) canvas.line(end, y - 5, end, y + 5, "bar");
    canvas.text(x + 0.5 * px, y - 9, fmt::format("{} {}", short_text(shown), length.name), "middle");
}

std::vector<Vector2d> developed_line(const std::vector<Vector3d>& points, double radius, double from,
                                     double sense) {
    std::vector<Vector2d> line;
    double angle = 0.0;
    for (const Vector3d& point : points) {
        const double here = sense * (from - std::atan2(point.y(), point.x()));
        angle += std::remainder(here - angle, units::turn);
        line.emplace_back(radius * angle, point.z());
    }
    return line;
}

/// The end that is seen hides all of the cam and its rollers that lies behind it: it is painted last, whole.
std::vector<PaintedMesh> painted_indexing_cam(TriangleMesh body, TriangleMesh rollers) {
    const auto [low, high] =
        std::ranges::minmax(body.vertices, {}, [](const Vector3d& vertex) { return vertex.z(); });
    TriangleMesh ends{body.vertices, {}};
    for (const double z : {low.z(), high.z()})
        std::erase_if(body.triangles, [&](const std::array<int, 3>& corners) {
            const bool in_end =
                std::ranges::all_of(corners, [&](int i) { return body.vertices[i].z() == z; });
            if (in_end) ends.triangles.push_back(corners);
            return in_end;
        });
    return {{std::move(body), flank_colour, MeshPlace::revolved},
            {std::move(rollers), roller_colour, MeshPlace::revolved},
            {std::move(ends), flank_colour, MeshPlace::anywhere}};
}

}  // namespace

std::vector<PaintedMesh> drum_parts(const CamFlanks& cam, const FollowerMotion& motion,
                                    const FlankGrid& grid) {
    if (indexes(cam, motion))
        if (auto body = drawn_indexing_body(cam, motion, {180, 4}))
            return painted_indexing_cam(std::move(*body), holding_rollers(cam, motion));
    std::vector<PaintedMesh> parts = {
        {core_of(core_size(grid), cam.body, 0.5 * grid.roller_radius), core_colour, MeshPlace::revolved}};
    for (const SurfaceGrid& flank : flank_surfaces(grid))
        parts.push_back({both_sides(mesh_of(flank)), flank_colour, MeshPlace::around_revolved});
    return parts;
}

MeshView drum_view(const CamFlanks& cam) {
    MeshView view;
    view.up = Vector3d::UnitY();  // where the roller stands at cam angle 0
    view.azimuth = (90.0 - sense_of(cam.rotation) * 50.0) * degree;
    view.elevation = 28.0 * degree;
    return view;
}

std::string drum_svg(const Drum& drum) {
    const ShownUnit length = shown_units(drum.solution.scene).length;
    SvgCanvas canvas = new_picture(css_of(drum_styles), title_of_drum(drum));
    canvas.rectangle(picture_left, picture_top, picture_frame_width, picture_frame_height, "frame");
    MeshView view = drum_view(drum.cam);
    view.width = picture_frame_width - 40;
    const double room = picture_frame_height - 90;  // the bar stands below
    const MeshElements mesh = mesh_elements(
        drum_parts(drum.cam, drum.motion, drum_grid(drum.cam, drum.motion, drum_sections)), view, room);
    canvas.insert(picture_left + 0.5 * (picture_frame_width - mesh.width),
                  picture_top + 20 + 0.5 * (room - mesh.height), mesh.elements);
    draw_scale_bar(canvas, mesh.scale, length);
    canvas.text(picture_left + picture_frame_width - 10, picture_top + picture_frame_height - 12,
                "parallel projection, cam angle 0", "end");
    const bool ribs = indexes(drum.cam, drum.motion);
    LegendColumn column(canvas, 8 + figure_entries(drum.solution, DrawnFigures::of_whole_cam));
    if (!ribs) column.sample("hub", "core");
    column.sample("rib", ribs ? "cam" : "both flanks of the groove");
    if (ribs) column.sample("rollers", "rollers that hold its rib");
    column.heading("dimensions");
    add_dimensions(column, drum.solution);
    column.words(fmt::format("turns {}", name_of(drum.cam.rotation)));
    add_figures(column, drum.solution, DrawnFigures::of_whole_cam);
    if (!closes(drum)) add_opening(column, drum.solution);
    return canvas.finish();
}

std::string developed_svg(const Drum& drum) {
    const ShownUnit length = shown_units(drum.solution.scene).length;
    const FlankGrid grid = drum_grid(drum.cam, drum.motion, 2);
    const std::size_t count = grid.angles.size();
    const auto axis_point = [&](std::size_t k, double part) {
        return grid.feet[k] + part * drum.cam.roller_length * grid.directions[k];
    };
    // The outer end of the roller.
    const auto radius_of = [&](double part) {
        double sum = 0.0;
        for (std::size_t k = 0; k < count; ++k) sum += axis_point(k, part).head<2>().norm();
        return sum / static_cast<double>(count);
    };
    const std::size_t outer = radius_of(0.0) >= radius_of(1.0) ? 0 : 1;
    const double radius = radius_of(static_cast<double>(outer)), sense = sense_of(drum.cam.rotation);
    const Vector3d first = axis_point(0, static_cast<double>(outer));
    const double from = std::atan2(first.y(), first.x());
    std::vector<Vector3d> axis;
    for (std::size_t k = 0; k < count; ++k) axis.emplace_back(axis_point(k, 0.5));
    const std::vector<Vector2d> middle = developed_line(axis, radius, from, sense);
    Drawing drawing;
    for (std::size_t flank = 0; flank < 2; ++flank)
        for (std::size_t section = 0; section < 2; ++section) {
            const std::vector<Vector3d>& points = grid.flanks[flank].points;
            const std::vector<Vector3d> row(
                points.begin() + static_cast<std::ptrdiff_t>(section * count),
                points.begin() + static_cast<std::ptrdiff_t>((section + 1) * count));
            drawing.polyline(std::string(flank == 0 ? "plus" : "minus") + (section != outer ? "-deep" : ""),
                             developed_line(row, radius, from, sense));
        }
    DrawingBox box = drawing.box();
    for (const double x : {0.0, radius * units::turn}) box.add({x, box.least.y()});

    SvgCanvas canvas = new_picture(css_of(drum_styles) + peak_style, title_of_drum(drum));
    const PicturePlace place = fitted_place(box);
    draw_length_frame(canvas, place, length,
                      fmt::format("around the drum at a radius of {}, along its axis: {}",
                                  length.text(radius, 5), length.name));
    for (int angle = 0; angle <= 360; angle += 60) {
        const double x = place({radius * angle * degree, 0.0}).x();
        canvas.line(x, picture_top, x, picture_top + picture_frame_height, "turned");
        canvas.text(x, picture_top + 14, fmt::format("{}°", angle), "tick middle");
    }
    drawing.polyline("axis", middle);
    const CamExtreme& largest = drum.solution.cam->summary.pressure_angle;
    const double theta = drum.solution.scene.motion.unit_angle() * largest.at;
    const auto nearest = static_cast<std::size_t>(
        std::ranges::min_element(grid.angles, {}, [&](double angle) { return std::abs(angle - theta); }) -
        grid.angles.begin());
    drawing.circle("peak", middle[nearest], place.px(4));
    draw(canvas, drawing, place, drum_styles);
    const std::string words = fmt::format("φ = {}° at {}°", short_text(degrees_shown.of(largest.value), 4),
                                          short_text(degrees_shown.of(theta), 5));
    constexpr double font = 12;
    const Vector2d peak = place(middle[nearest]);
    PlacedTexts labels = labels_of(
        drawing, place, std::array<std::string_view, 5>{"plus", "plus-deep", "minus", "minus-deep", "axis"});
    labels.draw(canvas, words, places_around(peak.x(), peak.y(), text_width(words, font, true), font),
                "peak-label", font, true);
    LegendColumn column(canvas, 9 + figure_entries(drum.solution, DrawnFigures::of_whole_cam));
    column.sample("plus", "one flank, outer end");
    column.sample("plus-deep", "at the inner end");
    column.sample("minus", "other flank, outer end");
    column.sample("minus-deep", "at the inner end");
    column.sample("axis", "way of the roller's axis");
    column.heading("dimensions");
    add_dimensions(column, drum.solution);
    add_figures(column, drum.solution, DrawnFigures::of_whole_cam);
    if (!closes(drum)) add_opening(column, drum.solution);
    return canvas.finish();
}

}  // namespace camopt
