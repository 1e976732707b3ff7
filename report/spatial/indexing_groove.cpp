// SPDX-License-Identifier: MIT
#include "report/spatial/indexing_body.hpp"
#include "report/view/shown_units.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector3d;

constexpr double same_end = 1e-9;  // rad
constexpr double scan_step = 0.5 * units::degree;
constexpr double most_turns = 3.0;                   // of the way through the body, to either side
constexpr double most_swing = 80.0 * units::degree;  // of the follower where the roller leaves
constexpr double wall = 1.25, way_beyond = 0.05;     // of the roller's radius: see the header
constexpr int halvings = 30, outside_samples = 90;
// Where else the roller is searched for, and how far it must reach to count.
constexpr double window_step = 2.0 * units::degree, least_way = 1e-7, near_roller = 1e-3;
constexpr int window_steps = 30, most_rounds = 12, sections = 20;

}  // namespace

bool indexes(const CamFlanks& cam, const FollowerMotion& motion) {
    const bool turn = is_whole_turn(motion.end() - motion.begin());
    const double advance = motion.state(motion.end()).s - motion.state(motion.begin()).s;
    return turn && cam.swings && std::abs(advance) > same_end;
}

FollowerMotion rollers_as_one(const FollowerMotion& motion, double from, double to) {
    const double begin = motion.begin(), end = motion.end();
    const double pitch = motion.state(end).s - motion.state(begin).s;
    FollowerMotion all;
    all.state = [motion, begin, end, pitch](double phi) {
        const double turns = std::floor((phi - begin) / units::turn);
        FollowerState state = motion.state(std::clamp(phi - turns * units::turn, begin, end));
        state.s += turns * pitch;
        return state;
    };
    all.breakpoints = {from};
    const int first = static_cast<int>(std::floor((from - begin) / units::turn));
    const int last = static_cast<int>(std::floor((to - begin) / units::turn));
    for (int turn = first; turn <= last; ++turn)
        for (const double angle : motion.breakpoints) {
            const double phi = angle + turn * units::turn;
            if (phi > all.breakpoints.back() + same_end && phi < to - same_end)
                all.breakpoints.push_back(phi);
        }
    all.breakpoints.push_back(to);
    return all;
}

/// How far from the point along the unit direction the roller at φ reaches; 0: it does not hold the point.
double IndexingGroove::way_out_of_roller(const Vector3d& point, const Vector3d& direction, double phi) const {
    const RollerAxis axis = cam_.axis(phi, path_.state(phi).s);
    const Vector3d from = point - axis.foot;
    const double along = from.dot(axis.direction), under = floor_ - along, r = cam_.roller_radius;
    const Vector3d beside = from - along * axis.direction;
    const double room = r * r - beside.squaredNorm();
    if (!(under > 0.0 && room > 0.0)) return 0.0;
    const double rise = direction.dot(axis.direction);
    const Vector3d across = direction - rise * axis.direction;
    const double a = across.squaredNorm(), b = beside.dot(across);
    const double to_end = rise > 0.0 ? under / rise : HUGE_VAL;
    const double to_side = a > 0.0 ? (std::sqrt(b * b + a * room) - b) / a : HUGE_VAL;
    return std::min(to_end, to_side);
}

/// How deep the point lies in the roller at φ; below 0: outside of it.
double IndexingGroove::depth_in_roller(const Vector3d& point, double phi) const {
    const RollerAxis axis = cam_.axis(phi, path_.state(phi).s);
    const Vector3d from = point - axis.foot;
    const double along = from.dot(axis.direction);
    return std::min(cam_.roller_radius - (from - along * axis.direction).norm(), floor_ - along);
}

/// The point moved along the direction out of every place of the roller near φ.
Vector3d IndexingGroove::left_of(Vector3d point, const Vector3d& direction, double phi) const {
    const auto depth_at = [&](double there) { return depth_in_roller(point, there); };
    std::array<double, 2 * window_steps + 1> depths{};
    for (int round = 0; round < most_rounds; ++round) {
        const auto there = [&](std::size_t k) {
            return phi + (static_cast<double>(k) - window_steps) * window_step;
        };
        for (std::size_t k = 0; k < depths.size(); ++k) depths[k] = depth_at(there(k));
        double farthest = 0.0;
        for (std::size_t k = 1; k + 1 < depths.size(); ++k) {
            if (depths[k] < depths[k - 1] || depths[k] < depths[k + 1] || depths[k] < -near_roller) continue;
            const GoldenSection deepest = golden_maximum(depth_at, there(k - 1), there(k + 1), sections);
            if (deepest.value() > least_way)
                farthest = std::max(farthest, way_out_of_roller(point, direction, deepest.place()));
        }
        if (farthest == 0.0) break;
        point += farthest * direction;
    }
    return point;
}

Vector3d IndexingGroove::contact(double phi, double t) const {
    const FollowerState state = path_.state(phi);
    const bool on_flank = t <= 1.0 || t >= 4.0;
    const double height = t <= 1.0 ? floor_ * t : t >= 4.0 ? floor_ * (5.0 - t) : floor_;
    const FlankPoint touched = cam_.point(phi, state, {height, 1});
    // The flank whose side lies where rollers come from.
    const double in = (touched.normal.z() > 0.0) == enters_above_ ? 1.0 : -1.0;
    const double r = cam_.roller_radius;
    const double share = on_flank ? (t <= 1.0 ? 1.0 : -1.0) : std::cos(0.5 * units::turn * (t - 1.0) / 3.0);
    const Vector3d point = touched.center + in * share * r * touched.normal;
    if (on_flank) return left_of(point, in * share * touched.normal, phi);
    return left_of(point, cam_.axis(phi, state.s).direction, phi);
}

double IndexingGroove::outside(double z) const {
    if (!cam_.arc) return radius_;
    const double along = z - cam_.arc->z, arm = cam_.arc->radius;
    return cam_.arc->from_axis - std::sqrt(std::max(arm * arm - along * along, 0.0));
}

double IndexingGroove::depth(const Vector3d& point) const {
    if (!cam_.arc) return radius_ - point.head<2>().norm();
    const double within = cam_.arc->from_axis - point.head<2>().norm();
    return std::copysign(std::hypot(within, point.z() - cam_.arc->z), within) - cam_.arc->radius;
}

std::string IndexingGroove::turned_words() const {
    const std::string ends = fmt::format("from {:.3f} to {:.3f} mm along the axis",
                                         millimetres_shown.of(lower_), millimetres_shown.of(upper_));
    if (!cam_.arc)
        return fmt::format("diameter {:.3f} mm, {}", millimetres_shown.of(2.0 * outside(0.0)), ends);
    return fmt::format("radius {:.3f} - sqrt({:.3f}^2 - (z - {:.3f})^2) mm at z, {}",
                       millimetres_shown.of(cam_.arc->from_axis), millimetres_shown.of(cam_.arc->radius),
                       millimetres_shown.of(cam_.arc->z), ends);
}

/// `from` 0 or 5, inwards +1 or −1. Where the roller's near end lies within the body the groove goes on
/// above.
double IndexingGroove::top(double phi, double from, double inwards) const {
    const auto inside = [&](double way) { return depth(contact(phi, from + inwards * way)) >= 0.0; };
    if (!inside(1.0))
        throw InputError(fmt::format(
            "indexing cam: the roller leaves the cam's outside, not its ends, at a cam angle of {:.1f} deg",
            degrees_shown.of(phi - std::floor(phi / units::turn) * units::turn)));
    double outside = 0.0;
    while (inside(outside)) outside = 2.0 * outside - 1.0;
    return from + inwards * bisected(inside, {1.0, outside}, halvings).with;
}

void IndexingGroove::choose_ends(double middle, double pitch) {
    const double r = cam_.roller_radius;
    double shortest = -HUGE_VAL, longest = HUGE_VAL;  // what either end may be moved out by
    // Where the roller's axis lies along the cam: of its two ends that nearer to the cam's middle, or not.
    const auto z_at = [&](double q, bool near_middle, double sign) {
        const RollerAxis axis = cam_.axis_at(0.0, q);
        const double a = axis.foot.z(), b = a + floor_ * axis.direction.z();
        return (sign * a < sign * b) == near_middle ? a : b;
    };
    const auto end_at = [&](double q, double sign) {
        const double farthest = z_at(std::copysign(most_swing, q - middle), true, sign);
        const double most = sign * farthest - (1.0 + way_beyond) * r, least = sign * z_at(q, true, sign) - r;
        const double end = std::min(sign * z_at(q, false, sign) + wall * r, most);
        if (!(end > least))
            throw InputError(
                fmt::format("indexing cam: {:g} stops leave no room between the roller in the dwell and "
                            "where it leaves the cam",
                            units::turn / std::abs(pitch)));
        shortest = std::max(shortest, least - end);
        longest = std::min(longest, most - end);
        return sign * end;
    };
    const double in = middle - 0.5 * pitch, out = middle + 0.5 * pitch;
    enters_above_ = z_at(in, true, 1.0) > z_at(out, true, 1.0);
    upper_ = end_at(enters_above_ ? in : out, 1.0);
    lower_ = end_at(enters_above_ ? out : in, -1.0);
    if (!cam_.body.length) return;
    const double length = upper_ - lower_, beyond = 0.5 * (*cam_.body.length - length);
    if (!(beyond > shortest && beyond <= longest))
        throw InputError(fmt::format(
            "cam.body_length: found {:.6g} mm; allowed: above {:.6g} and at most {:.6g} mm, so that a roller "
            "in the dwell is held and others leave by the ends",
            millimetres_shown.of(*cam_.body.length), millimetres_shown.of(length + 2.0 * shortest),
            millimetres_shown.of(length + 2.0 * longest)));
    upper_ += beyond;
    lower_ -= beyond;
}

/// The φ where the whole line of contact is beyond that end; towards: +1 where rollers leave.
double IndexingGroove::way_out(double towards) const {
    const bool above = (towards > 0.0) != enters_above_;
    const double sign = above ? 1.0 : -1.0,
                 end = sign * (above ? upper_ : lower_) + way_beyond * cam_.roller_radius;
    for (int k = 1; k * scan_step < most_turns * units::turn; ++k) {
        const double phi = begin_ + towards * k * scan_step;
        const auto is_out = [&](double t) { return sign * contact(phi, t).z() > end; };
        if (!std::ranges::all_of(std::array{0.5, 4.5, 1.0, 2.0, 2.5, 3.0, 4.0}, is_out)) continue;
        // The flank on the inner side passes last. Its end is searched for, which takes longest.
        if (is_out(towards > 0.0 ? first(phi) : last(phi))) return phi;
    }
    throw InputError("indexing cam: a roller does not leave the cam within three turns");
}

IndexingGroove::IndexingGroove(const CamFlanks& cam, const FollowerMotion& motion, double floor)
    : cam_(cam), begin_(motion.begin()), floor_(floor) {
    if (!is_whole_turn(motion.end() - motion.begin()))
        throw InputError(fmt::format("indexing cam: the motion must take one turn, it takes {:g} deg",
                                     degrees_shown.of(motion.end() - motion.begin())));
    const double before = motion.state(motion.begin()).s, pitch = motion.state(motion.end()).s - before;
    if (!(std::abs(pitch) > same_end))
        throw InputError("indexing cam: the motion must end one pitch from where it begins");
    path_ =
        rollers_as_one(motion, begin_ - most_turns * units::turn, begin_ + (most_turns + 1.0) * units::turn);
    const double first = cam.start + before;
    for (int k = 0; k <= outside_samples; ++k) {
        const RollerAxis axis = cam.axis_at(0.0, first + pitch * k / outside_samples);
        radius_ = std::max(radius_, axis.foot.head<2>().norm());
    }
    if (cam.body.diameter) radius_ = 0.5 * *cam.body.diameter;
    choose_ends(first + 0.5 * pitch, pitch);
    path_ = rollers_as_one(motion, way_out(-1.0), way_out(1.0));
}

}  // namespace camopt
