// SPDX-License-Identifier: MIT
#include "shop/disk/disk_export.hpp"

#include "shop/disk/disk_solid.hpp"
#include "shop/nc/milling/groove_passes.hpp"
#include "shop/nc/milling/plane_passes.hpp"
#include "shop/nc/milling/plate_passes.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int checked_points = 1440;
constexpr double usual_cutter = 16e-3;  // m, around a cam

void require(bool holds, const char* what, double found) {
    if (!holds) throw InputError(fmt::format("plane cam: {}, found {:g}", what, found));
}

/// Between the cam's faces, which are taken as faced before, and larger around it.
Blank blank_of(const ProfileShape& shape, const DiskNcOptions& options) {
    double greatest = 0.0;
    for (const Eigen::Vector2d& point : contour_points(shape, checked_points))
        greatest = std::max(greatest, point.norm());
    Blank blank = chosen_blank({greatest + options.blank.allowance, -options.thickness, 0.0}, options.blank);
    if (blank.radius < greatest || blank.lower > -options.thickness || blank.upper < 0.0)
        throw InputError(fmt::format(
            "blank: {} does not hold the cam, which has a greatest radius of {:.3f} mm and lies "
            "between {:g} mm and 0",
            words_of(blank), millimetres_shown.of(greatest), millimetres_shown.of(-options.thickness)));
    return blank;
}

/// The roller in its groove, as wide as the groove: upright, its far end at the floor.
RollerPath groove_roller(const ProfileShape& shape) {
    return [&shape](double theta, double station) {
        const MechanismPoint point = shape.at(theta);
        return RollerPose{{point.pitch.x(), point.pitch.y(), -station},
                          {0.0, 0.0, -1.0},
                          {-point.normal.x(), -point.normal.y(), 0.0}};
    };
}

/// The disk is turned and faced before.
Blank grooved_blank(const ProfileShape& shape, const DiskNcOptions& options) {
    const double rim = rim_radius(shape).value();
    Blank blank = chosen_blank({rim, -options.thickness, 0.0}, options.blank);
    if (blank.radius >= rim && blank.lower <= -options.thickness && blank.upper >= 0.0) return blank;
    throw InputError(
        fmt::format("blank: {} does not hold the disk, which has a radius of {:.3f} mm and lies between "
                    "{:g} mm and 0",
                    words_of(blank), millimetres_shown.of(rim), millimetres_shown.of(-options.thickness)));
}

WantedSurface flank_surface(const ProfileShape& side, const char* name, double height) {
    WantedSurface surface{name, {}};
    for (const Eigen::Vector2d& point : contour_points(side, checked_points))
        surface.points.emplace_back(point.x(), point.y(), height);
    return surface;
}

void add_outline(CuttingTask& task, const WantedSurface& surface) {
    task.outlines.push_back(surface.points);
    task.outlines.back().push_back(surface.points.front());
}

NcWork groove_nc_work(const ProfileShape& shape, const DiskNcOptions& options) {
    const double depth = options.groove_depth.value_or(0.5 * options.thickness);
    require(depth > 0.0 && depth < options.thickness, "the groove must be less deep than the cam is thick, m",
            depth);
    CutterLocation location;
    location.roller_radius = shape.formulas().surface_offset(shape.cam.dimensions, 1);
    location.diameter = options.cutter_diameter.value_or(2.0 * location.roller_radius);
    location.stock = options.stock;
    location.station = depth;

    NcWork work;
    NcJob& job = work.job;
    job = milling_job(options, grooved_blank(shape, options), location.diameter, depth);
    job.remarks = {
        "origin: the centre of the cam, on its upper face", "the cam as it lies at its cam angle 0",
        fmt::format("the groove, {:.3f} mm wide, {:.3f} mm deep; rim, faces and bore are made before",
                    millimetres_shown.of(2.0 * location.roller_radius), millimetres_shown.of(depth))};
    CuttingTask& task = work.task;
    add_groove(work, {groove_roller(shape), shape.knots, location, depth}, options);
    task.surfaces.push_back(flank_surface(shape, "the inner flank", -0.5 * depth));
    task.surfaces.push_back(flank_surface(other_side(shape), "the outer flank", -0.5 * depth));
    for (const WantedSurface& surface : task.surfaces) add_outline(task, surface);
    return work;
}

PlaneContour contour_of(const ProfileShape& shape) {
    return [&shape](double theta) {
        const MechanismPoint point = shape.at(theta);
        return ContourPoint{in_plane(point.contact), in_plane(point.normal)};
    };
}

/// The surface, and behind its last knot one side, the bottom and the other side, a unit of θ each.
PlaneBody plate_body(const ProfileShape& shape) {
    PlaneBody body{contour_of(shape), shape.knots};
    const double end = shape.end();
    const Eigen::Vector2d first = in_plane(shape.at(shape.begin()).contact),
                          last = in_plane(shape.at(end).contact);
    const std::array<Eigen::Vector2d, 4> corners = {last, {last.x(), 0.0}, {first.x(), 0.0}, first};
    body.contour = [surface = body.contour, corners, end](double theta) -> ContourPoint {
        if (theta <= end) return surface(theta);
        const auto side = std::min<std::size_t>(static_cast<std::size_t>(theta - end), corners.size() - 2);
        const double part = theta - end - static_cast<double>(side);
        return {(1.0 - part) * corners[side] + part * corners[side + 1], Eigen::Vector2d::Zero()};
    };
    for (std::size_t side = 1; side < corners.size(); ++side)
        body.knots.push_back(end + static_cast<double>(side));
    return body;
}

/// Sides, bottom and faces of the plate are made before; the allowance is above the surface.
Blank plate_blank(const ProfileShape& shape, const DiskNcOptions& options) {
    if (options.blank.radius)
        throw InputError(
            "blank: found a diameter; allowed: none, a plate is cut from a block as long as itself");
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : contour_points(shape, checked_points)) box.extend(point);
    const double first = shape.at(shape.begin()).contact.x(), last = shape.at(shape.end()).contact.x();
    box.extend(in_plane(shape.at(shape.end()).contact));
    Blank blank = chosen_blank({box.diagonal().norm(), -options.thickness, 0.0}, options.blank);
    blank.radius = 0.0;
    blank.block =
        Eigen::AlignedBox2d(Eigen::Vector2d(std::min(first, last), 0.0),
                            Eigen::Vector2d(std::max(first, last), box.max().y() + options.blank.allowance));
    if (blank.lower <= -options.thickness && blank.upper >= 0.0) return blank;
    throw InputError(fmt::format("blank: {} does not hold the plate, which lies between {:g} mm and 0",
                                 words_of(blank), millimetres_shown.of(-options.thickness)));
}

NcWork plate_nc_work(const ProfileShape& shape, const DiskNcOptions& options) {
    const double depth = options.thickness + options.tip_beyond;
    const double diameter = options.cutter_diameter.value_or(usual_cutter);
    NcWork work;
    NcJob& job = work.job;
    job = milling_job(options, plate_blank(shape, options), diameter, depth);
    job.remarks = {"origin: x = 0 of the plate's frame, on its bottom, on its upper face",
                   "sides and bottom of the plate are made before"};
    CuttingTask& task = work.task;
    task.finished = plane_finished_cam(plate_body(shape));
    take_passes(work, plate_passes({contour_of(shape),
                                    shape.knots,
                                    {diameter, options.stock, -depth},
                                    job.blank,
                                    options.safe_distance,
                                    options.chord_tolerance,
                                    task.finished.get(),
                                    options.milling}));
    task.knots = shape.knots;
    task.blocks.chord_tolerance = options.chord_tolerance;
    task.cutter = {diameter, depth};
    task.gouge_tolerance = options.gouge_tolerance;
    task.surfaces.push_back(flank_surface(shape, "the surface of the plate", -0.5 * options.thickness));
    std::vector<Eigen::Vector3d>& outline = task.outlines.emplace_back(task.surfaces.front().points);
    const double height = -0.5 * options.thickness;
    outline.emplace_back(shape.at(shape.end()).contact.x(), shape.at(shape.end()).contact.y(), height);
    outline.emplace_back(outline.back().x(), 0.0, height);
    outline.emplace_back(outline.front().x(), 0.0, height);
    outline.push_back(outline.front());
    return work;
}

}  // namespace

NcWork disk_nc_work(const ProfileShape& shape, const DiskNcOptions& options) {
    check_can_be_made(shape);
    require(std::isfinite(options.thickness) && options.thickness > 0.0, "the thickness must be > 0 m",
            options.thickness);
    require(std::isfinite(options.tip_beyond) && options.tip_beyond >= 0.0,
            "the tip must reach to the cam's underside or beyond, by >= 0 m", options.tip_beyond);
    if (shape.is_plate()) return plate_nc_work(shape, options);
    if (shape.other) return groove_nc_work(shape, options);
    const double depth = options.thickness + options.tip_beyond;
    const double diameter = options.cutter_diameter.value_or(usual_cutter);
    NcWork work;
    NcJob& job = work.job;
    job = milling_job(options, blank_of(shape, options), diameter, depth);
    job.remarks = {"origin: the centre of the cam, on its upper face",
                   "the cam as it lies at its cam angle 0"};

    CuttingTask& task = work.task;
    const PlaneContour around = contour_of(shape);
    task.finished = plane_finished_cam({around, shape.knots});
    take_passes(work, plane_passes({around,
                                    shape.knots,
                                    {diameter, options.stock, -depth},
                                    job.blank,
                                    options.safe_distance,
                                    options.chord_tolerance,
                                    task.finished.get(),
                                    options.milling}));
    task.knots = shape.knots;
    task.blocks.chord_tolerance = options.chord_tolerance;
    task.cutter = {diameter, depth};
    task.gouge_tolerance = options.gouge_tolerance;
    task.surfaces.push_back(flank_surface(shape, "the cam's contour", -0.5 * options.thickness));
    add_outline(task, task.surfaces.front());
    return work;
}

}  // namespace camopt
