// SPDX-License-Identifier: MIT
#include "studies/delivered/delivered.hpp"

#include "scene/cam_flanks.hpp"

#include <set>

namespace camopt {

namespace {

constexpr double least_dwell = 1e-6;  // rad: a shorter rest of the revolution is rounding
constexpr int closing_steps = 24;     // rows over the dwell that closes a cam
constexpr double same_row = 1e-9;     // of the motion: places closer than this are one
constexpr int uniform_steps = 360;
constexpr double points_a_turn = 3600.0;
constexpr double same_angle = 1e-12;   // relative to the motion's length: angles this close are one row
constexpr double jump_of_jerk = 1e-9;  // relative to the peak jerk: a smaller difference is round-off

bool jerk_jumps(const Motion& motion, double x, double peak) {
    if (x <= motion.begin() || x >= motion.end()) return false;
    const double left = motion.at(x, Side::left).derivative[3];
    const double right = motion.at(x, Side::right).derivative[3];
    if (!std::isfinite(left) || !std::isfinite(right)) return true;
    return std::abs(right - left) > jump_of_jerk * peak;
}

}  // namespace

MotionScale motion_scale(const Scene& scene) {
    return {scene.motion.lift, scene.motion.unit_angle()};
}

MotionChain whole_turn(const Solution& solution) {
    return solution.whole_turn();
}

MotionChain cam_motion(const Solution& solution) {
    const bool rests = solution.scene.motion.type == MotionType::rr;
    return rests || !solution.motion ? whole_turn(solution) : *solution.motion;
}

MotionChain drawn_motion(const Solution& solution) {
    MotionChain motion = cam_motion(solution);
    const bool turns = solution.cam && !solution.cam->cam.formulas->guide(solution.cam->cam.dimensions);
    const double unit_angle = solution.scene.motion.unit_angle();
    const double rest = 0.5 * (units::turn / unit_angle - (motion.end() - motion.begin()));
    if (!turns || solution.scene.motion.type != MotionType::drd || !(rest > least_dwell / unit_angle))
        return motion;
    std::vector<ChainPart> parts = motion.parts();
    const auto dwell = [&](double begin, double end, double height) {
        ChainPart part;
        part.begin = begin;
        part.end = end;
        part.y0 = height;
        return part;
    };
    const double first = motion.at(motion.begin()).derivative[0],
                 last = motion.at(motion.end(), Side::left).derivative[0];
    parts.insert(parts.begin(), dwell(motion.begin() - rest, motion.begin(), first));
    parts.push_back(dwell(motion.end(), motion.end() + rest, last));
    return MotionChain(std::move(parts));
}

std::string open_because(const Solution& solution) {
    const MotionSpec& motion = solution.scene.motion;
    if (motion.type == MotionType::drd) return "no return is given: motion.type is \"DRD\"";
    if (motion.relative)
        return "the next revolution goes on from where this one ends: motion.closed is \"relative\"";
    if (motion.type == MotionType::program && !motion.closed)
        return "the program is not closed: motion.closed is false";
    return "";
}

std::optional<MotionPoint> output_at(const Solution& solution, double x, Side side) {
    if (!solution.output) return {};
    const Motion& output = *solution.output;
    if (x <= output.end()) return output.at(x, side);
    return MotionPoint{x, {output.at(output.end(), Side::left).derivative[0], 0.0, 0.0, 0.0}};
}

std::vector<MotionRow> motion_rows(const Motion& motion, const Peaks& peaks,
                                   const std::vector<double>& also) {
    const double begin = motion.begin(), end = motion.end();
    const double near = same_angle * (end - begin);
    const std::vector<double> breakpoints = motion.breakpoints();
    // Breakpoints first: an angle that agrees with one to round-off must not stand in its place.
    std::set<double> angles(breakpoints.begin(), breakpoints.end());
    const auto add = [&](double x) {
        const auto next = angles.lower_bound(x - near);
        if (x >= begin && x <= end && (next == angles.end() || *next > x + near)) angles.insert(x);
    };
    for (const Extremum* peak : {&peaks.velocity, &peaks.acceleration, &peaks.jerk, &peaks.torque})
        add(peak->at);
    for (const double x : also) add(x);
    for (int i = 0; i <= uniform_steps; ++i) add(begin + (end - begin) * i / uniform_steps);
    std::vector<MotionRow> rows;
    for (const double x : angles) {
        if (jerk_jumps(motion, x, peaks.jerk.value)) rows.push_back({x, Side::left});
        rows.push_back({x, x >= end ? Side::left : Side::right});
    }
    return rows;
}

std::size_t Delivered::index_at(double x) const {
    const double near = same_row * (end() - begin());
    const auto found = std::ranges::lower_bound(rows, x - near, {}, &DeliveredRow::x);
    return static_cast<std::size_t>(std::min(found, rows.end() - 1) - rows.begin());
}

Delivered sample_delivered(const Solution& solution) {
    Delivered all;
    all.scale = motion_scale(solution.scene);
    if (!solution.motion) return all;
    const auto add = [&](const Motion& motion, const MotionRow& row, bool closing) {
        all.rows.push_back({row.x, row.side, motion.at(row.x, row.side), closing, {}, {}});
        all.rows.back().output = output_at(solution, row.x, row.side);
    };
    std::vector<double> also = {solution.scene.motion.own_place(0.0)};
    if (solution.output)  // whose peaks are stated too
        for (const Extremum* peak : {&solution.motion_peaks.velocity, &solution.motion_peaks.acceleration,
                                     &solution.motion_peaks.jerk})
            also.push_back(peak->at);
    for (const MotionRow& row : motion_rows(*solution.motion, solution.cam_peaks, also))
        add(*solution.motion, row, false);
    if (solution.drive) {
        const DriveAlong along(solution.scene);
        for (DeliveredRow& row : all.rows)
            row.drive = along.at(row.motion, row.side, row.output ? &*row.output : nullptr);
    }
    if (!solution.cam) return all;
    all.whole = cam_motion(solution);
    all.cam = std::make_shared<CamPoints>(solution.cam->cam, drawn_motion(solution), all.scale);
    const double begin = solution.motion->end(), end = all.whole->end();
    if (end > begin) {
        add(*all.whole, {begin, Side::right}, true);
        for (int i = 1; i <= closing_steps; ++i)
            add(*all.whole,
                {begin + (end - begin) * i / closing_steps, i < closing_steps ? Side::right : Side::left},
                true);
    }
    const LoadsAt loads = delivered_loads(solution);
    const int stations = solution.cam->cam.formulas->stations();
    for (DeliveredRow& row : all.rows) {
        for (int station = 0; station < stations; ++station)
            row.cam.push_back(all.cam->at(row.motion, station));
        if (loads) row.loads = loads(row.motion, *all.cam);
    }
    return all;
}

std::vector<DeliveredRow> profile_rows(const Solution& solution, const Delivered& delivered,
                                       const ProfileSampling& sampling, int station) {
    const CamPoints& cam = *delivered.cam;
    const CamPointAt at = [&](double x) { return cam.at(x, station); };
    const LoadsAt loads = delivered_loads(solution);
    std::vector<DeliveredRow> rows;
    for (const double x :
         profile_places(at, cam.motion().breakpoints(), delivered.scale.unit_angle, sampling)) {
        DeliveredRow& row = rows.emplace_back();
        row.x = x;
        row.side = x < cam.motion().end() ? Side::right : Side::left;
        row.motion = cam.motion_at(x);
        row.cam = {cam.at(row.motion, station)};
        if (!loads) continue;
        row.loads = loads(row.motion, cam);
        if (row.loads->side == station || solution.cam->summary.no_contact) continue;
        row.loads->normal_force = 0.0;
        if (row.loads->hertz_pressure) row.loads->hertz_pressure = 0.0;
    }
    return rows;
}

ProfileSampling default_sampling(const CamPoints& cam) {
    if (cam.cam().formulas->direct() != nullptr) return {};
    const double turns = (cam.motion().end() - cam.motion().begin()) * cam.scale().unit_angle / units::turn;
    return {.count = 1 + static_cast<int>(std::ceil(points_a_turn * turns))};
}

}  // namespace camopt
