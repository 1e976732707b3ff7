// SPDX-License-Identifier: MIT
#include "core/motion.hpp"

#include "bindings/c/handles.hpp"
#include "core/units.hpp"
#include "profiles/sampling.hpp"
#include "studies/delivered/delivered.hpp"

#include <fmt/format.h>

namespace camopt::c {
namespace {

using units::degree, units::millimetre;

/// A slip of the keyboard is told before it fills the memory.
constexpr std::size_t most_profile_points = 10'000'000;

void store(const Eigen::Vector3d& place, double unit, double (&target)[3]) {
    for (int i = 0; i < 3; ++i) target[i] = place[i] / unit;
}

camopt_profile_point point_of(const MechanismPoint& point) {
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
    const CamPoints cam(solution.cam->cam, cam_motion(solution), motion_scale(solution.scene));
    ProfileSampling sampling = default_sampling(cam);
    if (points > 0) sampling.count = static_cast<int>(points);
    std::vector<camopt_profile_point> all;
    for (const MechanismPoint& point :
         sampled_profile(cam.cam(), cam.motion(), cam.scale(), sampling, static_cast<int>(station)))
        all.push_back(point_of(point));
    return all;
}

/// Where the samples go: x, y, y', y'', y'''; any may be NULL.
using SampleBuffers = std::array<double*, 5>;

MotionPoint point_at(const Motion& motion, double x) {
    if (!(x >= motion.begin() && x <= motion.end()))
        throw Failure(CAMOPT_ERROR_ARGUMENT,
                      fmt::format("x: found {}; allowed: {} to {}", x, motion.begin(), motion.end()));
    return motion.at(x, x == motion.end() ? Side::left : Side::right);
}

void store(const MotionPoint& point, std::size_t index, const SampleBuffers& buffers) {
    if (buffers[0] != nullptr) buffers[0][index] = point.x;
    for (std::size_t order = 0; order < point.derivative.size(); ++order)
        if (buffers[order + 1] != nullptr) buffers[order + 1][index] = point.derivative[order];
}

/// The splines of a solution, in order.
std::vector<const SplineCurve*> splines_of(const Solution& solution) {
    std::vector<const SplineCurve*> all;
    if (solution.curve) all.push_back(&*solution.curve);
    for (const SegmentReport& segment : solution.segments)
        if (segment.curve) all.push_back(&*segment.curve);
    return all;
}

const SplineCurve& spline_of(const camopt_solution* solution, std::size_t index) {
    require(solution, "solution");
    const std::vector<const SplineCurve*> all = splines_of(solution->solution);
    check_index(index, all.size(), "index");
    return *all[index];
}

/// A list of a spline's numbers into the caller's buffer.
template <class List>
camopt_error hand_out_numbers(const camopt_solution* solution, std::size_t index, List list, double* buffer,
                              std::size_t capacity, std::size_t* count) {
    return guarded([&] {
        const auto numbers = list(spline_of(solution, index));
        hand_out(numbers.data(), static_cast<std::size_t>(numbers.size()), buffer, capacity, count);
    });
}

}  // namespace
}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

camopt_error camopt_motion_at(const camopt_solution* solution, double x, double derivatives[4]) {
    return guarded([&] {
        const camopt::Motion& motion = motion_of(solution);
        require(derivatives, "derivatives");
        std::ranges::copy(point_at(motion, x).derivative, derivatives);
    });
}

camopt_error camopt_output_at(const camopt_solution* solution, double x, double derivatives[4]) {
    return guarded([&] {
        const camopt::Motion& motion = motion_of(solution);
        require(derivatives, "derivatives");
        const auto& output = solution->solution.output;
        std::ranges::copy(point_at(output ? *output : motion, x).derivative, derivatives);
    });
}

camopt_error camopt_motion_at_all(const camopt_solution* solution, const double* x, size_t count, double* y,
                                  double* dy, double* d2y, double* d3y) {
    return guarded([&] {
        const camopt::Motion& motion = motion_of(solution);
        if (count > 0) require(x, "x");
        std::vector<camopt::MotionPoint> points;
        points.reserve(count);
        for (std::size_t i = 0; i < count; ++i) points.push_back(point_at(motion, x[i]));
        for (std::size_t i = 0; i < count; ++i) store(points[i], i, {nullptr, y, dy, d2y, d3y});
    });
}

camopt_error camopt_motion_samples(const camopt_solution* solution, size_t count, double* x, double* y,
                                   double* dy, double* d2y, double* d3y) {
    return guarded([&] {
        const camopt::Motion& motion = motion_of(solution);
        if (count < 2)
            throw Failure(CAMOPT_ERROR_ARGUMENT, fmt::format("count: found {}; allowed: 2 or more", count));
        const double begin = motion.begin(), end = motion.end();
        for (std::size_t i = 0; i < count; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(count - 1);
            store(point_at(motion, i == count - 1 ? end : begin + (end - begin) * part), i,
                  {x, y, dy, d2y, d3y});
        }
    });
}

camopt_error camopt_spline_count(const camopt_solution* solution, size_t* count) {
    return guarded([&] {
        require(solution, "solution");
        require(count, "count");
        *count = splines_of(solution->solution).size();
    });
}

camopt_error camopt_spline_at(const camopt_solution* solution, size_t index, camopt_spline* spline) {
    return guarded([&] {
        const camopt::SplineCurve& curve = spline_of(solution, index);
        const camopt_spline numbers{
            sizeof(camopt_spline), curve.degree(),
            curve.continuity(),    curve.begin(),
            curve.end(),           curve.breakpoints().size(),
            curve.knots().size(),  static_cast<std::size_t>(curve.coefficients().size())};
        fill(spline, numbers, "spline");
    });
}

camopt_error camopt_spline_breakpoints(const camopt_solution* solution, size_t index, double* buffer,
                                       size_t capacity, size_t* count) {
    const auto list = [](const camopt::SplineCurve& curve) { return curve.breakpoints(); };
    return hand_out_numbers(solution, index, list, buffer, capacity, count);
}

camopt_error camopt_spline_knots(const camopt_solution* solution, size_t index, double* buffer,
                                 size_t capacity, size_t* count) {
    const auto list = [](const camopt::SplineCurve& curve) { return curve.knots(); };
    return hand_out_numbers(solution, index, list, buffer, capacity, count);
}

camopt_error camopt_spline_coefficients(const camopt_solution* solution, size_t index, double* buffer,
                                        size_t capacity, size_t* count) {
    const auto list = [](const camopt::SplineCurve& curve) { return curve.coefficients(); };
    return hand_out_numbers(solution, index, list, buffer, capacity, count);
}

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
