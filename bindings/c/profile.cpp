// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"
#include "bindings/c/structs.hpp"
#include "core/units.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/sampling.hpp"
#include "studies/check/check_cam.hpp"

#include <fmt/format.h>

#include <vector>

namespace camopt::c {
namespace {

using units::degree, units::millimetre;

/// A slip of the keyboard is told before it fills the memory.
constexpr std::size_t most_profile_points = 10'000'000;

template <int dimension>
void store(const Eigen::Matrix<double, dimension, 1>& place, double unit, double (&target)[3]) {
    for (int i = 0; i < 3; ++i) target[i] = i < dimension ? place[i] / unit : 0.0;
}

/// Both kinds of points have these members; `pitch` and `contact` are places in the cam frame.
template <class Point>
camopt_profile_point point_of(const Point& point) {
    camopt_profile_point shown{};
    shown.theta_deg = point.theta / degree;
    store(point.pitch, millimetre, shown.pitch_mm);
    store(point.contact, millimetre, shown.cam_mm);
    store(point.normal, 1.0, shown.normal);
    shown.pressure_angle_deg = point.pressure_angle / degree;
    shown.pitch_radius_mm = 1.0 / (point.pitch_curvature * millimetre);
    shown.cam_radius_mm = point.cam_radius / millimetre;
    shown.regularity = point.regularity;
    return shown;
}

template <class Point>
std::vector<camopt_profile_point> points_of(const std::vector<Point>& points) {
    std::vector<camopt_profile_point> all;
    all.reserve(points.size());
    for (const Point& point : points) all.push_back(point_of(point));
    return all;
}

const std::vector<std::string>& stations_of(const camopt_solution* solution) {
    require(solution, "solution");
    if (solution->stations.empty())
        throw Failure(CAMOPT_ERROR_ABSENT,
                      "the solution has no cam: the scene has none, or no motion was found");
    return solution->stations;
}

std::vector<camopt_profile_point> profile_of(const Solution& solution, std::size_t points,
                                             std::size_t station) {
    if (points == 1 || points > most_profile_points)
        throw Failure(CAMOPT_ERROR_ARGUMENT,
                      fmt::format("points: found {}; allowed: 2 to {}, or 0", points, most_profile_points));
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    if (const std::optional<DiskCam> disk = disk_cam(solution.cam->cam)) {
        ProfileSampling sampling;
        if (points > 0) sampling.count = static_cast<int>(points);
        return points_of(sampled_profile(*disk, motion, scale, sampling, static_cast<int>(station)));
    }
    const int count = points > 0 ? static_cast<int>(points) : default_profile_points(motion, scale);
    return points_of(
        mechanism_profile(solution.cam->cam, motion, scale, count, static_cast<int>(station)).points);
}

}  // namespace
}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

camopt_error camopt_station_count(const camopt_solution* solution, size_t* count) {
    return guarded([&] {
        const std::size_t stations = stations_of(solution).size();
        require(count, "count");
        *count = stations;
    });
}

camopt_error camopt_station_name(const camopt_solution* solution, size_t station, const char** name) {
    return guarded([&] {
        const std::vector<std::string>& names = stations_of(solution);
        require(name, "name");
        check_index(station, names.size(), "station");
        *name = names[station].c_str();
    });
}

camopt_error camopt_profile(const camopt_solution* solution, size_t points, size_t station,
                            camopt_profile_point* buffer, size_t capacity, size_t* count) {
    return guarded([&] {
        check_index(station, stations_of(solution).size(), "station");
        require(count, "count");
        const std::vector<camopt_profile_point> profile = profile_of(solution->solution, points, station);
        hand_out(profile.data(), profile.size(), buffer, capacity, count);
    });
}
}
