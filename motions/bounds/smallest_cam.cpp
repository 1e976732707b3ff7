// SPDX-License-Identifier: MIT
#include "motions/bounds/smallest_cam.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

void require_positive(const char* name, double found) {
    if (found > 0.0 && std::isfinite(found)) return;
    throw InputError(fmt::format("smallest cam: {} = {} found, allowed a number above 0", name, found));
}

void require_stroke(const CamStroke& stroke) {
    require_positive("lift", stroke.lift);
    if (!std::isfinite(stroke.offset))
        throw InputError(
            fmt::format("smallest cam: offset = {} found, allowed a finite number", stroke.offset));
}

double tangent_of(double pressure_angle) {
    if (!(pressure_angle > 0.0 && pressure_angle < 0.5 * std::numbers::pi))
        throw InputError(fmt::format(
            "smallest cam: pressure angle = {} found, allowed 0 < pressure angle < π/2", pressure_angle));
    return std::tan(pressure_angle);
}

/// σe: positive where the offset helps the stroke.
double helping_offset(const CamStroke& stroke) {
    return stroke.stroke == Stroke::rise ? stroke.offset : -stroke.offset;
}

/// The cam angle of the steepest stroke, regardless of the pressure angle at rest.
double steepest_angle(const CamStroke& stroke, double prime_coordinate, double tangent) {
    const double slope = helping_offset(stroke) + tangent * prime_coordinate;
    if (!(slope > 0.0)) return std::numeric_limits<double>::infinity();
    return std::log1p(tangent * stroke.lift / slope) / tangent;
}

}  // namespace

double SteepestStroke::displacement(double theta) const {
    return scale * std::expm1(growth * theta);
}

double SteepestStroke::slope(double theta) const {
    return scale * growth * std::exp(growth * theta);
}

double least_stroke_coordinate(const CamStroke& stroke, double angle, double pressure_angle) {
    require_stroke(stroke);
    require_positive("angle", angle);
    const double tangent = tangent_of(pressure_angle);
    return stroke.lift / std::expm1(angle * tangent) - helping_offset(stroke) / tangent;
}

SmallestCam smallest_cam(const CamStroke& stroke, double angle, double pressure_angle) {
    require_stroke(stroke);
    require_positive("angle", angle);
    const double tangent = tangent_of(pressure_angle);
    const double scale = stroke.lift / std::expm1(angle * tangent);
    const double rest = std::abs(stroke.offset) / tangent;
    const double helped = helping_offset(stroke) / tangent;
    SmallestCam cam;
    cam.prime_coordinate = scale - helped;
    cam.motion = {scale, tangent, angle};
    if (cam.prime_coordinate < rest) {
        cam.limit = SmallestCamLimit::rest;
        cam.prime_coordinate = rest;
        cam.motion = {rest + helped, tangent, steepest_angle(stroke, rest, tangent)};
    }
    cam.prime_radius = std::hypot(cam.prime_coordinate, stroke.offset);
    return cam;
}

}  // namespace camopt
