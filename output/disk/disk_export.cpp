// SPDX-License-Identifier: MIT
#include "output/disk/disk_export.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/disk/disk_solid.hpp"
#include "output/nc/milling/plane_passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace camopt {

namespace {

constexpr int checked_points = 1440;

void require(bool holds, const char* what, double found) {
    if (!holds) throw InputError(fmt::format("plane cam: {}, found {:g}", what, found));
}

std::vector<Eigen::Vector2d> contour(const ProfileShape& shape, int count) {
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k < count; ++k)
        points.push_back(shape.at(shape.begin() + (shape.end() - shape.begin()) * k / count).contact);
    return points;
}

/// Between the cam's faces, which are taken as faced before, and larger around it.
Blank blank_of(const ProfileShape& shape, const DiskNcOptions& options) {
    double greatest = 0.0;
    for (const Eigen::Vector2d& point : contour(shape, checked_points))
        greatest = std::max(greatest, point.norm());
    const Blank blank =
        chosen_blank({greatest + options.blank.allowance, -options.thickness, 0.0}, options.blank);
    if (blank.radius < greatest || blank.lower > -options.thickness || blank.upper < 0.0)
        throw InputError(fmt::format(
            "blank: {} does not hold the cam, which has a greatest radius of {:.3f} mm and lies "
            "between {:g} mm and 0",
            words_of(blank), greatest / units::millimetre, -options.thickness / units::millimetre));
    return blank;
}

}  // namespace

NcWork disk_nc_work(const ProfileShape& shape, const DiskNcOptions& options) {
    check_closed(shape);
    require(std::isfinite(options.thickness) && options.thickness > 0.0, "the thickness must be > 0 m",
            options.thickness);
    require(std::isfinite(options.tip_beyond) && options.tip_beyond >= 0.0,
            "the tip must reach to the cam's underside or beyond, by >= 0 m", options.tip_beyond);
    const double depth = options.thickness + options.tip_beyond;
    NcWork work;
    NcJob& job = work.job;
    job.title = options.title;
    job.tool = fmt::format("cylindrical end mill, diameter {:g} mm, working length {:g} mm or more",
                           options.cutter_diameter / units::millimetre, depth / units::millimetre);
    job.remarks = {"origin: the centre of the cam, on its upper face",
                   "the cam as it lies at its cam angle 0"};
    job.feed = options.feed;
    job.spindle_rpm = options.spindle_rpm;
    job.blank = blank_of(shape, options);
    job.clearance = options.clearance;
    job.safe_distance = options.safe_distance;
    set_words(job, options.milling);

    CuttingTask& task = work.task;
    const PlaneContour around = [&shape](double theta) {
        const ProfilePoint point = shape.at(theta);
        return ContourPoint{point.contact, point.normal};
    };
    task.finished = plane_finished_cam({around, shape.knots});
    PlanePasses milled = plane_passes({around,
                                       shape.knots,
                                       {options.cutter_diameter, options.stock, -depth},
                                       job.blank,
                                       options.safe_distance,
                                       options.chord_tolerance,
                                       task.finished.get(),
                                       options.milling});
    task.passes = std::move(milled.passes);
    job.remarks.insert(job.remarks.end(), milled.remarks.begin(), milled.remarks.end());
    task.knots = shape.knots;
    task.blocks.chord_tolerance = options.chord_tolerance;
    task.cutter = {options.cutter_diameter, depth};
    task.gouge_tolerance = options.gouge_tolerance;
    WantedSurface surface{"the cam's contour", {}};
    for (const Eigen::Vector2d& point : contour(shape, checked_points))
        surface.points.emplace_back(point.x(), point.y(), -0.5 * options.thickness);
    task.surfaces.push_back(std::move(surface));
    return work;
}

CheckedProgram disk_nc(const ProfileShape& shape, const Machine& machine, const PostProcessor& post,
                       const DiskNcOptions& options) {
    return checked_program(machine, post, disk_nc_work(shape, options));
}

}  // namespace camopt
