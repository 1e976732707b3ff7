// SPDX-License-Identifier: MIT
#include "shop/nc/milling/offset_line.hpp"

namespace camopt {

namespace {

constexpr double kept_within = 1e-6;      // m: what a line may be nearer to the cam than d
constexpr double far_below = -1e3;        // m
constexpr double step_of_surface = 1e-6;  // of the surface

}  // namespace

double depth_in_plane(FinishedCam& cam, const Eigen::Vector2d& center, double radius) {
    return cam.depth({{center.x(), center.y(), far_below}, -Eigen::Vector3d::UnitZ()}, radius);
}

std::function<bool(double)> ends_of_offset(PlaneContour surface, double d, double span, FinishedCam* cam) {
    return [surface = std::move(surface), d, step = step_of_surface * span, cam](double v) {
        const ContourPoint here = surface(v);
        if (depth_in_plane(*cam, here.position + d * here.normal, d) > kept_within) return false;
        const ContourPoint before = surface(v - step), after = surface(v + step);
        const Eigen::Vector2d way = after.position - before.position;
        return way.dot(way + d * (after.normal - before.normal)) > 0.0;
    };
}

}  // namespace camopt
