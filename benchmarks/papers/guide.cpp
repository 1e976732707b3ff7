// SPDX-License-Identifier: MIT
#include "benchmarks/papers/guide.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

// Relative to the guide's size: tolerance for joints of a guide given in micrometres.
constexpr double meeting_tolerance = 1e-6;
// cos mu below this (mu above 89.9 deg) counts as a guide along which L does not grow.
constexpr double least_growth = 2e-3;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Vector2d at_angle(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

Vector2d turned_left(const Vector2d& a) {
    return {-a.y(), a.x()};
}

/// From position, tangent and curvature to the polar form.
GuidePoint point_of(double distance, const Vector2d& position, const Vector2d& tangent, double curvature) {
    const Vector2d radial = position / position.norm();
    const double sine = cross(radial, tangent), cosine = radial.dot(tangent);
    GuidePoint point;
    point.distance = distance;
    point.angle = std::atan2(position.y(), position.x());
    point.slope = sine / (cosine * distance);
    point.bend = (curvature - sine / distance) / (distance * cosine * cosine * cosine) -
                 sine / (cosine * distance * distance);
    point.pressure_angle = std::atan2(sine, cosine);
    point.curvature = curvature;
    point.position = position;
    point.tangent = tangent;
    return point;
}

GuidePoint point_at(const GuideLine& line, double distance) {
    const Vector2d along = (line.end - line.begin).normalized();
    const Vector2d foot = line.begin - line.begin.dot(along) * along;
    const double run = std::sqrt(std::max(0.0, distance * distance - foot.squaredNorm()));
    return point_of(distance, foot + run * along, along, 0.0);
}

GuidePoint point_at(const GuideArc& arc, double distance) {
    const double to_center = arc.center.norm(), radius = (arc.begin - arc.center).norm();
    const double cosine =
        (distance * distance + to_center * to_center - radius * radius) / (2.0 * distance * to_center);
    const double side = cross(arc.center, 0.5 * (arc.begin + arc.end)) > 0.0 ? 1.0 : -1.0;
    const double angle =
        std::atan2(arc.center.y(), arc.center.x()) + side * std::acos(std::clamp(cosine, -1.0, 1.0));
    const Vector2d position = distance * at_angle(angle);
    const double turn = cross(arc.begin - arc.center, arc.end - arc.center) > 0.0 ? 1.0 : -1.0;
    const Vector2d tangent = turn * turned_left((position - arc.center) / radius);
    return point_of(distance, position, tangent, turn / radius);
}

/// The quintic between two nodes with its first two derivatives, by Hermite's form over t in [0, 1].
PolarNode between(const PolarNode& a, const PolarNode& b, double distance) {
    const double h = b.distance - a.distance, t = (distance - a.distance) / h;
    const double c0 = a.angle, c1 = h * a.slope, c2 = 0.5 * h * h * a.bend;
    const double rest = b.angle - c0 - c1 - c2, rest_slope = h * b.slope - c1 - 2.0 * c2,
                 rest_bend = h * h * b.bend - 2.0 * c2;
    const double c3 = 10.0 * rest - 4.0 * rest_slope + 0.5 * rest_bend,
                 c4 = -15.0 * rest + 7.0 * rest_slope - rest_bend,
                 c5 = 6.0 * rest - 3.0 * rest_slope + 0.5 * rest_bend;
    return {distance, c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * c5)))),
            (c1 + t * (2.0 * c2 + t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5)))) / h,
            (2.0 * c2 + t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5))) / (h * h)};
}

GuidePoint point_at(const GuidePolarSpline& spline, double distance) {
    const auto& nodes = spline.nodes;
    const auto above = std::ranges::upper_bound(nodes, distance, {}, &PolarNode::distance);
    const std::size_t right =
        std::clamp<std::size_t>(static_cast<std::size_t>(above - nodes.begin()), 1, nodes.size() - 1);
    const PolarNode node = between(nodes[right - 1], nodes[right], distance);
    GuidePoint point;
    point.distance = distance;
    point.angle = node.angle;
    point.slope = node.slope;
    point.bend = node.bend;
    const double tangent = distance * node.slope, secant = std::sqrt(1.0 + tangent * tangent);
    point.pressure_angle = std::atan(tangent);
    point.curvature =
        (distance * node.bend + node.slope * (2.0 + tangent * tangent)) / (secant * secant * secant);
    point.position = distance * at_angle(node.angle);
    point.tangent = at_angle(node.angle + point.pressure_angle);
    return point;
}

/// Where a piece begins and ends.
struct PieceEnds {
    Vector2d begin, end;
};

PieceEnds ends_of(const GuideLine& line) {
    return {line.begin, line.end};
}
PieceEnds ends_of(const GuideArc& arc) {
    return {arc.begin, arc.end};
}
PieceEnds ends_of(const GuidePolarSpline& spline) {
    const auto place = [](const PolarNode& node) -> Vector2d { return node.distance * at_angle(node.angle); };
    return {place(spline.nodes.front()), place(spline.nodes.back())};
}

std::string fault_of(const GuideLine& line) {
    const Vector2d run = line.end - line.begin;
    if (!(run.norm() > 0.0)) return "a line of length 0";
    return {};
}

std::string fault_of(const GuideArc& arc) {
    const double radius = (arc.begin - arc.center).norm(), other = (arc.end - arc.center).norm();
    if (!(radius > 0.0)) return "an arc of radius 0";
    if (!(std::abs(radius - other) <= meeting_tolerance * radius))
        return fmt::format("an arc whose ends are {} and {} m from its center; both must be its radius",
                           radius, other);
    if (!(arc.center.norm() > 0.0)) return "an arc about the pivot: L does not grow along it (branch)";
    return {};
}

std::string fault_of(const GuidePolarSpline& spline) {
    if (spline.nodes.size() < 2) return "a polar spline of fewer than 2 nodes";
    for (std::size_t i = 0; i + 1 < spline.nodes.size(); ++i)
        if (!(spline.nodes[i + 1].distance > spline.nodes[i].distance))
            return fmt::format(
                "a polar spline whose node {} does not lie further from the pivot than node {}", i + 2,
                i + 1);
    return {};
}

/// cos mu at the ends of a piece, as it is drawn.
struct Growth {
    double begin = 1.0, end = 1.0;
};

Growth growth_of(const GuideLine& line) {
    const Vector2d along = (line.end - line.begin).normalized();
    return {line.begin.normalized().dot(along), line.end.normalized().dot(along)};
}

Growth growth_of(const GuideArc& arc) {
    const Vector2d from = arc.begin - arc.center, to = arc.end - arc.center;
    const double turn = cross(from, to) > 0.0 ? 1.0 : -1.0;
    const auto growth = [&](const Vector2d& position, const Vector2d& arm) {
        return turn * position.normalized().dot(turned_left(arm.normalized()));
    };
    return {growth(arc.begin, from), growth(arc.end, to)};
}

Growth growth_of(const GuidePolarSpline&) {
    return {};  // L grows from node to node
}

/// L must grow at both ends; then it does in between: cos mu changes its sign at most once on a line or an
/// arc of less than half a circle.
std::string growth_fault(const GuidePiece& piece, double begin, double end) {
    if (!(begin > 0.0)) return "begins at the pivot; the least distance must be > 0";
    if (!(end > begin))
        return fmt::format("runs from L = {} to {} m; L must grow along the guide (branch)", begin, end);
    const Growth growth = std::visit([](const auto& one) { return growth_of(one); }, piece);
    if (growth.begin > least_growth && growth.end > least_growth) return {};
    return fmt::format("turns back near L = {} m, where its pressure angle reaches 90 deg (branch)",
                       growth.begin > least_growth ? end : begin);
}

PieceEnds ends_of_piece(const GuidePiece& piece) {
    return std::visit([](const auto& one) { return ends_of(one); }, piece);
}

std::string fault_of_piece(const GuidePiece& piece) {
    const std::string own = std::visit([](const auto& one) { return fault_of(one); }, piece);
    if (!own.empty()) return own;
    const PieceEnds ends = ends_of_piece(piece);
    return growth_fault(piece, ends.begin.norm(), ends.end.norm());
}

}  // namespace

Guide::Guide(std::vector<GuidePiece> pieces) : pieces_(std::move(pieces)) {
    if (pieces_.empty()) throw InputError("the guide has no piece; it needs at least one");
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const std::string fault = fault_of_piece(pieces_[i]);
        if (!fault.empty()) throw InputError(fmt::format("piece {} of the guide: {}", i + 1, fault));
        const auto [begin, end] = ends_of_piece(pieces_[i]);
        if (i > 0) {
            const Vector2d before = ends_of_piece(pieces_[i - 1]).end;
            const double gap = (begin - before).norm();
            if (!(gap <= meeting_tolerance * end.norm()))
                throw InputError(fmt::format("pieces {} and {} of the guide are {} m apart; they must meet",
                                             i, i + 1, gap));
        }
        if (i == 0) joints_.push_back(begin.norm());
        joints_.push_back(end.norm());
    }
}

Reach Guide::reach(double distance) const {
    if (distance < begin()) return Reach::before_guide;
    return distance <= end() ? Reach::within : Reach::beyond_guide;
}

GuidePoint Guide::at(double distance, Side side) const {
    if (!(distance >= begin() && distance <= end()))
        throw InputError(fmt::format("the roller at L = {} m is not on the guide, which goes from {} to {} m",
                                     distance, begin(), end()));
    const auto above = side == Side::right ? std::ranges::upper_bound(joints_, distance)
                                           : std::ranges::lower_bound(joints_, distance);
    const std::size_t joint =
        std::clamp<std::size_t>(static_cast<std::size_t>(above - joints_.begin()), 1, pieces_.size());
    return std::visit([&](const auto& one) { return point_at(one, distance); }, pieces_[joint - 1]);
}

double Guide::largest_kink() const {
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < joints_.size(); ++i) {
        const Vector2d before = at(joints_[i], Side::left).tangent,
                       after = at(joints_[i], Side::right).tangent;
        largest = std::max(largest, std::abs(std::atan2(cross(before, after), before.dot(after))));
    }
    return largest;
}

GuidePoints guide_points(const Guide& guide, int count, double offset) {
    if (count < 2)
        throw InputError(fmt::format("{} points of the guide were requested; it needs at least 2", count));
    const double step = (guide.end() - guide.begin()) / (count - 1);
    GuidePoints result;
    const auto add = [&](double distance, Side side) {
        const GuidePoint point = guide.at(distance, side);
        const Eigen::Vector2d normal(-point.tangent.y(), point.tangent.x());
        result.distances.push_back(distance);
        result.points.push_back(point.position + offset * normal);
    };
    const std::vector<double>& joints = guide.joints();
    add(joints.front(), Side::right);
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const double length = joints[i + 1] - joints[i];
        const int steps = std::max(1, static_cast<int>(std::lround(length / step)));
        for (int k = 1; k < steps; ++k) add(joints[i] + length * k / steps, Side::right);
        add(joints[i + 1], Side::left);
        if (i + 2 < joints.size()) result.breaks.push_back(static_cast<int>(result.points.size()) - 1);
    }
    return result;
}

std::string wall_fault(const Guide& guide, double roller_radius) {
    constexpr int points_a_piece = 1000;
    const std::vector<double>& joints = guide.joints();
    double sharpest = 0.0, place = joints.front();
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        for (int k = 0; k <= points_a_piece; ++k) {
            const double distance = k == points_a_piece
                                        ? joints[i + 1]
                                        : joints[i] + (joints[i + 1] - joints[i]) * k / points_a_piece;
            const double curvature =
                std::abs(guide.at(distance, k == 0 ? Side::right : Side::left).curvature);
            if (curvature <= sharpest) continue;
            sharpest = curvature;
            place = distance;
        }
    }
    if (sharpest * roller_radius < 1.0) return {};
    return fmt::format(
        "the guide's radius of curvature is {} m at L = {} m, less than the roller's radius of {} m",
        1.0 / sharpest, place, roller_radius);
}

}  // namespace camopt
