// SPDX-License-Identifier: MIT
#include "studies/inspect/inspection.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "profiles/sampling.hpp"
#include "studies/delivered/delivered.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>

#include <set>

namespace camopt {

namespace {

using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

constexpr double at_rest = 1e-9;  // lifts: a smaller displacement, and slope by x, is that of the dwell
constexpr int foot_steps = 5;     // each leaves some hundredths of the way: far below 1 nm of distance
constexpr double neighbourhood = 2.5 * units::degree;   // to either side: below the width of a form error
constexpr double shared_errors = 10.0 * units::degree;  // rows this far apart share form errors
constexpr double least_half = 2.0, most_half = 50.0;    // rows of a neighbourhood, to either side
constexpr double biweight = 4.685;                      // 95 % efficiency with normal errors (J. W. Tukey)
constexpr double normal_mad = 1.4826;  // standard deviation over median of magnitudes, normal errors
constexpr double outlying = 5.0;       // robust standard deviations
constexpr double least_spread = 1e-9, settled = 1e-13;  // m, rad: of round-off; of a last step
constexpr int plain_steps = 5, most_steps = 60, search_steps = 180;
constexpr std::size_t search_rows = 120, most_worst = 5;
constexpr double clearly_better = 0.9;  // of two offsets the smaller one unless the other is this good

/// Fills in a row under an alignment.
using CompareRow = std::function<void(InspectedRow& row, const Vector4d& alignment)>;

/// The nominal motion around the revolution: beyond an open one it rests.
struct NominalMotion {
    MotionChain chain;
    MotionScale scale;
    bool closed = false;

    explicit NominalMotion(const Solution& nominal)
        : chain(nominal.whole_turn()), scale(motion_scale(nominal.scene)) {
        const double first = chain.at(chain.begin()).derivative[0];
        closed = is_whole_turn(scale.unit_angle * (chain.end() - chain.begin())) &&
                 std::abs(chain.at(chain.end(), Side::left).derivative[0] - first) < at_rest;
    }
    /// The state at x; whether it is the dwell at 0 goes to the row.
    [[nodiscard]] MotionPoint at(double x, InspectedRow* row = nullptr) const {
        const double length = chain.end() - chain.begin();
        if (closed) x -= length * std::floor((x - chain.begin()) / length);
        const MotionPoint point = motion_at(chain, std::clamp(x, chain.begin(), chain.end()));
        if (row) row->base = std::max(std::abs(point.derivative[0]), std::abs(point.derivative[1])) < at_rest;
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
    const char* const lifts = turns ? "displacements s_deg or s_rad" : "displacements s_mm, s_in or s_m";
    const auto refuse = [&](bool wrong, const std::string& found) {
        if (wrong) throw InputError(fmt::format("{}: found {}; allowed: {}", table.file, found, lifts));
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
    refuse(!nominal.cam->cam.formulas->is_direct(),
           fmt::format("points of a cam of type \"{}\", not \"disk\"", nominal.scene.cam->type));
    refuse(!motion.closed, fmt::format("points of an open cam ({})", open_because(nominal)));
    const DrivenMechanism& cam = nominal.cam->cam;
    return [surface = NominalSurface{cam, motion, probe_radius,
                                     sampled_profile(cam, motion.chain, motion.scale, {})}](
               InspectedRow& row, const Vector4d& alignment) { surface.compare(row, alignment); };
}

double median_of(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double spread_of(std::vector<double> values) {
    for (double& value : values) value = std::abs(value);
    return std::max(normal_mad * median_of(std::move(values)), least_spread);
}

/// The angle offset nearest to 0 at which the rows agree best up to a constant.
double searched_offset(std::vector<InspectedRow> rows, const CompareRow& compare) {
    double best = infinity, offset = 0.0;
    for (int i = 0; i <= search_steps; ++i) {
        const int from_zero = i % 2 == 0 ? -i / 2 : (i + 1) / 2;
        const double tried = units::turn * from_zero / search_steps;
        std::vector<double> seen;
        for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / search_rows) {
            compare(rows[k], {0.0, tried, 0.0, 0.0});
            seen.push_back(rows[k].aligned);
        }
        double sum = 0.0;
        for (const double middle = median_of(seen); const double one : seen) sum += std::abs(one - middle);
        if (sum < clearly_better * best) std::tie(best, offset) = std::tie(sum, tried);
    }
    return offset;
}

/// In each twelfth of the revolution a row; the first one counts twice where one is at its very end.
bool covers_revolution(const std::vector<InspectedRow>& rows) {
    std::set<double> twelfths;
    for (const InspectedRow& row : rows)
        twelfths.insert(std::floor(12.0 * std::remainder(row.angle, units::turn) / units::turn));
    return twelfths.size() >= 12;
}

double rows_within(double angle, const std::vector<InspectedRow>& rows) {
    return static_cast<double>(rows.size()) * angle / std::max(rows.back().angle - rows.front().angle, angle);
}

/// Medians of neighbours, outliers and weights of the rows.
void judge(Inspection& found) {
    std::ranges::stable_sort(found.rows, {}, &InspectedRow::angle);
    const std::size_t count = found.rows.size();
    const auto half =
        static_cast<std::size_t>(std::clamp(rows_within(neighbourhood, found.rows), least_half, most_half));
    std::array<std::vector<double>, 2> parts;  // lobe, base circle
    std::vector<double> from_neighbours;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> values;
        for (std::size_t k = i - std::min(i, half); k < std::min(i + half + 1, count); ++k)
            if (k != i) values.push_back(found.rows[k].aligned);
        InspectedRow& row = found.rows[i];
        row.around = median_of(std::move(values));
        from_neighbours.push_back(row.aligned - row.around);
        parts[row.base ? 1 : 0].push_back(row.around);
    }
    found.noise = spread_of(std::move(from_neighbours));
    const std::array<double, 2> spreads = {spread_of(parts[0]), spread_of(parts[1])};
    for (InspectedRow& row : found.rows) {
        row.outlier = std::abs(row.aligned - row.around) > outlying * found.noise;
        const double u = std::min(1.0, std::abs(row.around) / (biweight * spreads[row.base ? 1 : 0]));
        row.weight = row.outlier ? 0.0 : std::pow(1.0 - u * u, 2);
    }
}

void fit(Inspection& found, const CompareRow& compare) {
    Matrix4d inverse;
    std::vector<Vector4d> scores;
    double weights = 0.0, squares = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        for (InspectedRow& row : found.rows) compare(row, found.alignment);
        if (step > plain_steps) judge(found);
        Matrix4d normal = Matrix4d::Zero();
        Vector4d right = Vector4d::Zero();
        scores.clear();
        weights = squares = 0.0;
        for (InspectedRow& row : found.rows) {
            if (found.fitted == 2) row.slope.tail<2>().setZero();
            normal += row.weight * row.slope * row.slope.transpose();
            right += scores.emplace_back(row.weight * row.aligned * row.slope);
            weights += row.weight;
            squares += row.weight * row.aligned * row.aligned;
        }
        inverse = normal.completeOrthogonalDecomposition().pseudoInverse();  // a round part keeps its angle
        const Vector4d change = inverse * right;
        if (step > plain_steps && !(change.cwiseAbs().maxCoeff() > settled)) break;
        found.alignment -= change;
    }
    const auto lags =
        std::min(static_cast<std::size_t>(rows_within(shared_errors, found.rows)), scores.size() / 8);
    Matrix4d shared = Matrix4d::Zero();
    for (std::size_t i = 0; i < scores.size(); ++i)
        for (std::size_t lag = 0; lag <= std::min(lags, i); ++lag) {
            const double taper =
                lag == 0 ? 0.5 : 1.0 - static_cast<double>(lag) / static_cast<double>(lags + 1);
            const Matrix4d product = taper * scores[i] * scores[i - lag].transpose();
            shared += product + product.transpose();
        }
    const double free_rows = std::max(1.0, weights - found.fitted);
    const Vector4d usual = inverse.diagonal() * (squares / free_rows),
                   wider = (inverse * shared * inverse).diagonal() * (weights / free_rows);
    found.error = usual.cwiseMax(wider).cwiseSqrt();
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

/// The worst rows, and the stretches out of tolerance: those closer than a neighbourhood are one.
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
        if (!found.tolerance || std::abs(row.aligned) <= *found.tolerance) continue;
        if (found.out.empty() || row.angle - found.out.back()[1] > neighbourhood)
            found.out.push_back({row.angle, row.angle, row.aligned});
        found.out.back()[1] = row.angle;
        if (std::abs(row.aligned) > std::abs(found.out.back()[2])) found.out.back()[2] = row.aligned;
    }
}

}  // namespace

Inspection inspect_cam(const Solution& nominal, const input::InspectedTable& table, double probe_radius,
                       std::optional<double> tolerance) {
    const CompareRow compare = row_comparison(nominal, table, probe_radius);
    Inspection found;
    found.points = table.points;
    found.is_angle = nominal.scene.motion.lift_is_angle;
    found.tolerance = tolerance;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        found.rows.emplace_back().line = table.lines[i];
        found.rows.back().given = table.rows[i];
    }
    found.alignment[1] = searched_offset(found.rows, compare);
    for (InspectedRow& row : found.rows) {
        compare(row, Vector4d::Zero());
        row.raw = row.aligned;
        compare(row, found.alignment);
    }
    if (covers_revolution(found.rows)) found.fitted = 4;
    fit(found, compare);
    found.raw = figures_of(found.rows, &InspectedRow::raw);
    found.all = figures_of(found.rows, &InspectedRow::aligned);
    found.base = figures_of(found.rows, &InspectedRow::aligned, true);
    found.lobe = figures_of(found.rows, &InspectedRow::aligned, false);
    name_worst(found);
    return found;
}

}  // namespace camopt
