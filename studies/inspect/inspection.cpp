// SPDX-License-Identifier: MIT
#include "studies/inspect/inspection.hpp"

#include "input/keys/scene_keys.hpp"
#include "scene/unit_fault.hpp"
#include "studies/delivered/delivered.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

constexpr int foot_steps = 5;  // each leaves some hundredths of the way: far below 1 nm of distance
constexpr std::size_t most_worst = 5;

using input::CompareRow, input::neighbourhood, input::shared_errors, input::resting;

/// The nominal motion around the revolution: beyond an open one it rests.
struct NominalMotion {
    MotionChain chain;
    MotionScale scale;
    bool closed = false;

    explicit NominalMotion(const Solution& nominal)
        : chain(nominal.whole_turn()), scale(motion_scale(nominal.scene)) {
        const double first = chain.at(chain.begin()).derivative[0];
        closed = is_whole_turn(scale.unit_angle * (chain.end() - chain.begin())) &&
                 std::abs(chain.at(chain.end(), Side::left).derivative[0] - first) < resting;
    }
    /// The state at x; whether it is the dwell at 0 goes to the row.
    [[nodiscard]] MotionPoint at(double x, InspectedRow* row = nullptr) const {
        const double length = chain.end() - chain.begin();
        if (closed) x -= length * std::floor((x - chain.begin()) / length);
        const MotionPoint point = motion_at(chain, std::clamp(x, chain.begin(), chain.end()));
        if (row) row->base = std::max(std::abs(point.derivative[0]), std::abs(point.derivative[1])) < resting;
        return point;
    }
};

void compare_lift(const NominalMotion& motion, InspectedRow& row, const Vector4d& alignment) {
    const double angle = row.given.x() - alignment[1], cosine = std::cos(angle), sine = std::sin(angle);
    const FollowerState state = state_of(motion.at(angle / motion.scale.unit_angle, &row), motion.scale);
    row.angle = row.given.x();
    row.measured = row.given.y();
    row.nominal = state.s;
    row.aligned = row.follower =
        row.measured - state.s - alignment[0] - alignment[2] * cosine - alignment[3] * sine;
    row.slope = {-1.0, state.velocity - alignment[2] * sine + alignment[3] * cosine, -cosine, -sine};
}

/// The surface of a closed disk cam, side 0 of one that drives both ways.
struct NominalSurface {
    DrivenMechanism cam;
    NominalMotion motion;
    double probe_radius = 0.0;
    std::vector<MechanismPoint> samples;

    void compare(InspectedRow& row, const Vector4d& alignment) const {
        const Eigen::Rotation2Dd turn(alignment[1]);
        const Vector2d place = turn.inverse() * Vector2d(row.given - alignment.tail<2>());
        const MotionPoint at = motion.at(foot_of(place), &row);
        const MechanismPoint foot = mechanism_point(cam, at, motion.scale);
        const Vector2d normal = foot.normal.head<2>(), contact = foot.contact.head<2>();
        const MechanismState state{cam.dimensions, state_of(at, motion.scale), foot.theta};
        row.angle = foot.theta;
        row.measured = row.given.norm();
        row.nominal = (contact + probe_radius * normal).norm();
        row.aligned = normal.dot(place - contact) - probe_radius - alignment[0];
        row.follower =
            row.aligned / cam.formulas->quantity(MechanismQuantity::normal_lever, state, 0, {}).value;
        row.slope << -1.0, normal.x() * place.y() - normal.y() * place.x(), -(turn * normal);
    }

    /// x of the nearest point: from the nearest sample by steps along the surface.
    [[nodiscard]] double foot_of(const Vector2d& place) const {
        const auto nearest = std::ranges::min_element(samples, {}, [&](const MechanismPoint& sample) {
            return (sample.contact.head<2>() - place).squaredNorm();
        });
        const MechanismPoint &before = nearest == samples.begin() ? *nearest : *(nearest - 1),
                             &after = nearest + 1 == samples.end() ? *nearest : *(nearest + 1);
        const double first = nearest->theta / motion.scale.unit_angle,
                     widest = (after.theta - before.theta) / motion.scale.unit_angle;
        const double per_length =
            sense_of(cam.formulas->rotation()) * widest / (after.contact - before.contact).norm();
        double x = first;
        for (int i = 0; i < foot_steps; ++i) {
            const MechanismPoint point = mechanism_point(cam, motion.at(x), motion.scale);
            const Vector2d forward(point.normal.y(), -point.normal.x());
            x += per_length * forward.dot(place - point.contact.head<2>());
            if (!(std::abs(x - first) <= widest)) return first;  // a corner
        }
        return x;
    }
};

CompareRow row_comparison(const Solution& nominal, const input::InspectedTable& table, double probe_radius) {
    const bool turns = nominal.scene.motion.lift_is_angle;
    const std::array lifts = {input::find_row("measured", "s")->names()};
    const auto refuse = [&](bool wrong, const std::string& found) {
        if (wrong)
            throw InputError(fmt::format("{}: found {}; allowed: displacements {}", table.file, found,
                                         fitting_keys(lifts, turns)));
    };
    NominalMotion motion(nominal);
    if (!table.points) {
        refuse(table.is_angle != turns,
               turns ? "lengths where the lift is an angle" : "angles where the lift is a length");
        if (probe_radius > 0.0)
            throw InputError("--probe-radius-mm: found with displacements; allowed: with points of the cam");
        return
            [motion](InspectedRow& row, const Vector4d& alignment) { compare_lift(motion, row, alignment); };
    }
    refuse(!nominal.cam, "points of a cam where the scene has no cam");
    refuse(nominal.cam->cam.formulas->direct() == nullptr,
           fmt::format("points of a cam of type \"{}\", not \"disk\"", nominal.scene.cam->type));
    const DrivenMechanism& direct = nominal.cam->cam;
    refuse(direct.formulas->direct()->slide(direct.dimensions).has_value(), "points of a plate that slides");
    refuse(!motion.closed, fmt::format("points of an open cam ({})", open_because(nominal)));
    const DrivenMechanism& cam = nominal.cam->cam;
    return [surface = NominalSurface{cam, motion, probe_radius,
                                     sampled_profile(cam, motion.chain, motion.scale, {})}](
               InspectedRow& row, const Vector4d& alignment) { surface.compare(row, alignment); };
}

DeviationFigures figures_of(const std::vector<InspectedRow>& rows, double InspectedRow::*deviation,
                            std::optional<bool> base = {}) {
    DeviationFigures figures{-infinity, 0.0, infinity};
    for (const InspectedRow& row : rows) {
        if (base && row.base != *base) continue;
        const double value = row.*deviation;
        if (value > figures.most) std::tie(figures.most, figures.most_at) = std::tie(value, row.angle);
        if (value < figures.least) std::tie(figures.least, figures.least_at) = std::tie(value, row.angle);
        figures.rms = std::hypot(figures.rms, value);
        ++figures.rows;
    }
    figures.rms /= std::sqrt(std::max(1, figures.rows));
    return figures;
}

/// A row out of tolerance joins a stretch that is closer than a neighbourhood.
void add_outside(std::vector<std::array<double, 3>>& out, double angle, double value) {
    if (out.empty() || angle - out.back()[1] > neighbourhood) out.push_back({angle, angle, value});
    out.back()[1] = angle;
    if (std::abs(value) > std::abs(out.back()[2])) out.back()[2] = value;
}

constexpr int least_rows = 5;       // of a parabola
constexpr double surely_out = 2.0;  // standard errors

/// Derivative `order` of the parabola through what lies within a neighbourhood of row i, and its standard
/// error; NaN: too few rows.
std::array<double, 2> local_derivative(const Inspection& found, std::size_t i, int order) {
    const double centre = found.rows[i].angle;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    int rows = 0;
    const auto count = static_cast<std::ptrdiff_t>(found.rows.size());
    const auto take = [&](std::ptrdiff_t k) {  // around the revolution, too
        const InspectedRow& row = found.rows[static_cast<std::size_t>((k % count + count) % count)];
        const double t = std::remainder(row.angle - centre, units::turn) / neighbourhood;
        if (std::abs(t) > 1.0) return false;
        if (row.outlier) return true;
        const Eigen::Vector3d terms(1.0, t, t * t);
        normal += terms * terms.transpose();
        right += row.follower * terms;
        ++rows;
        return true;
    };
    const auto own = static_cast<std::ptrdiff_t>(i);
    take(own);
    for (const int way : {1, -1})
        for (std::ptrdiff_t step = 1; step <= count / 2 && take(own + way * step);) ++step;
    if (rows < least_rows) return {std::nan(""), std::nan("")};
    const Eigen::Matrix3d inverse = normal.completeOrthogonalDecomposition().pseudoInverse();
    const double unit = (order == 2 ? 2.0 : 1.0) / std::pow(neighbourhood, order);
    const double per_deviation =  // of the follower for the noise of a row
        found.rows[i].aligned != 0.0 ? std::abs(found.rows[i].follower / found.rows[i].aligned) : 1.0;
    return {unit * inverse.row(order).dot(right),
            unit * per_deviation * found.noise * std::sqrt(inverse(order, order))};
}

ErrorDerivative error_derivative(const Inspection& found, int order, double tolerance) {
    ErrorDerivative own{order, tolerance};
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const auto [value, error] = local_derivative(found, i, order);
        own.values.push_back(value);
        own.errors.push_back(error);
        if (std::abs(value) > std::abs(own.worst)) {
            own.worst = value;
            own.worst_at = found.rows[i].angle;
            own.worst_error = error;
        }
        if (std::abs(value) - surely_out * error > tolerance)
            add_outside(own.out, found.rows[i].angle, value);
    }
    return own;
}

/// The worst rows, and the stretches out of tolerance.
void name_worst(Inspection& found) {
    std::vector<InspectedRow> order = found.rows;
    std::ranges::stable_sort(order, std::greater(), [](const auto& row) { return std::abs(row.around); });
    for (const InspectedRow& row : order) {
        const auto near = [&](const InspectedRow& other) {
            return std::abs(std::remainder(row.angle - other.angle, units::turn)) < shared_errors;
        };
        if (found.worst.size() < most_worst && std::ranges::none_of(found.worst, near))
            found.worst.push_back(row);
    }
    for (const InspectedRow& row : found.rows) {
        if (found.tolerance && std::abs(found.judged(row)) > *found.tolerance)
            add_outside(found.out, row.angle, found.judged(row));
    }
}

}  // namespace

InspectionTolerance inspection_tolerance(const Scene& scene) {
    if (!scene.tolerance) return {};
    const auto& [profile, slope, acceleration] = scene.tolerance->motion;
    return {profile, true, {slope, acceleration}};
}

Inspection inspect_cam(const Solution& nominal, const input::InspectedTable& table, double probe_radius,
                       const InspectionTolerance& tolerance) {
    const CompareRow compare = row_comparison(nominal, table, probe_radius);
    Inspection found;
    found.points = table.points;
    found.is_angle = nominal.scene.motion.lift_is_angle;
    found.tolerance = tolerance.deviation;
    found.of_follower = tolerance.of_follower;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        found.rows.emplace_back().line = table.lines[i];
        found.rows.back().given = table.rows[i];
    }
    found.alignment[1] = input::searched_offset(found.rows, compare);
    for (InspectedRow& row : found.rows) {
        compare(row, Vector4d::Zero());
        row.raw = row.aligned;
        compare(row, found.alignment);
    }
    if (input::covers_revolution(found.rows)) found.fitted = 4;
    input::align(found, compare);
    found.raw = figures_of(found.rows, &InspectedRow::raw);
    found.all = figures_of(found.rows, &InspectedRow::aligned);
    found.base = figures_of(found.rows, &InspectedRow::aligned, true);
    found.lobe = figures_of(found.rows, &InspectedRow::aligned, false);
    name_worst(found);
    for (std::size_t k = 0; k < tolerance.derivatives.size(); ++k)
        if (const auto& own = tolerance.derivatives[k])
            found.derivatives.push_back(error_derivative(found, static_cast<int>(k) + 1, *own));
    return found;
}

}  // namespace camopt
