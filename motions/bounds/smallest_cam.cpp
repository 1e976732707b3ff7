// SPDX-License-Identifier: MIT
#include "motions/bounds/smallest_cam.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// How far s0 may lie below |e|/t by rounding of the division.
constexpr double radius_rounding = 1e-14;

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

double least_stroke_angle(const CamStroke& stroke, double prime_coordinate, double pressure_angle) {
    require_stroke(stroke);
    require_positive("prime coordinate", prime_coordinate);
    const double tangent = tangent_of(pressure_angle);
    if (tangent * prime_coordinate < std::abs(stroke.offset) * (1.0 - radius_rounding))
        return std::numeric_limits<double>::infinity();
    return steepest_angle(stroke, prime_coordinate, tangent);
}

double least_pressure_angle(const CamStroke& stroke, double prime_coordinate, double angle) {
    require_stroke(stroke);
    require_positive("prime coordinate", prime_coordinate);
    require_positive("angle", angle);
    const double centred = std::log1p(stroke.lift / prime_coordinate) / angle;
    if (stroke.offset == 0.0) return std::atan(centred);
    // The angle needed falls with the tangent, and the rest asks for `low`. There the answer lies or above;
    // as σe + t (s0 + s) >= (t - low)(s0 + s), it lies below `high`.
    double low = std::abs(stroke.offset) / prime_coordinate, high = low + centred;
    if (steepest_angle(stroke, prime_coordinate, low) <= angle) return std::atan(low);
    for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high))
        (steepest_angle(stroke, prime_coordinate, middle) > angle ? low : high) = middle;
    return std::atan(high);
}

}  // namespace camopt
