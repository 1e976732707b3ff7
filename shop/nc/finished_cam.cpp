// SPDX-License-Identifier: MIT
#include "shop/nc/finished_cam.hpp"

#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <span>

namespace camopt {

namespace {

constexpr int least_poses = 16;
constexpr double centred = 1e-6;  // m: nearer to the roller's axis a cutter has no flank of its own
constexpr int sections = 24;      // from a quarter of a degree down to 1e-7 rad

struct Line {
    Eigen::Vector3d foot, direction;  // of the roller: station 0, unit
};

/// Where a ray leaves the blank that is `by` larger for good; 0: it is not in it.
double way_out(const Blank& blank, double by, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    const double radius = blank.radius + by;
    const double a = direction.head<2>().squaredNorm(), b = direction.head<2>().dot(from.head<2>());
    const double c = from.head<2>().squaredNorm() - radius * radius;
    double way = HUGE_VAL;
    if (a > 0.0) {
        const double root = b * b - a * c;
        if (root < 0.0) return 0.0;
        way = (std::sqrt(root) - b) / a;
    } else if (c > 0.0) {
        return 0.0;
    }
    const double up = direction.z();
    if (up > 0.0) way = std::min(way, (blank.upper + by - from.z()) / up);
    if (up < 0.0) way = std::min(way, (blank.lower - by - from.z()) / up);
    return std::max(way, 0.0);
}

class GroovedCam final : public FinishedCam {
 public:
    explicit GroovedCam(const GroovedBody& body) : body_(body) {
        for (int i = 0; i < body.poses; ++i) lines_.push_back(line_at(angle(i)));
    }

    double depth(const ToolPose& pose, double cutter_radius) override {
        const double outside = distance_to_blank(body_.blank, pose, cutter_radius);
        if (outside > 0.0) return -outside;
        const Stand stand{pose, cutter_radius,
                          way_out(body_.blank, 2.0 * cutter_radius, pose.tip, -pose.axis)};
        last_ = descended(stand, last_);
        const double near = depth_around(stand, last_);
        if (near <= body_.enough) return near;
        const std::size_t best = index_of_least([&](const Line& line) { return depth_in(stand, line); });
        const double anywhere = depth_around(stand, best);
        if (anywhere < near) last_ = best;
        return std::min(near, anywhere);
    }

    Eigen::Vector3d towards_flank(const ToolPose& pose) override {
        // The roller on the other side of the cam points here too: its floor lies before it comes so far.
        const auto square = [&](const Line& line) {
            const bool beyond = (pose.tip - line.foot).dot(line.direction) > body_.floor + body_.radius;
            return beyond ? HUGE_VAL : across(line, pose.tip).squaredNorm();
        };
        const int place = static_cast<int>(index_of_least(square));
        const int last = static_cast<int>(lines_.size()) - 1;
        const GoldenSection found =
            golden_maximum([&](double theta) { return -square(line_at(theta)); },
                           angle(std::max(place - 1, 0)), angle(std::min(place + 1, last)), sections);
        const Eigen::Vector3d way = across(line_at(found.place()), pose.tip);
        return way.norm() < centred ? Eigen::Vector3d::Zero() : Eigen::Vector3d(way.normalized());
    }

 private:
    [[nodiscard]] static Eigen::Vector3d across(const Line& line, const Eigen::Vector3d& point) {
        const Eigen::Vector3d from = point - line.foot;
        return from - from.dot(line.direction) * line.direction;
    }
    struct Stand {
        const ToolPose& pose;
        double radius, way;  // of the cutter; up to where it has left the blank
    };

    /// Of lines_; each value is taken once, as std::ranges::min_element would not.
    template <class Value>
    [[nodiscard]] std::size_t index_of_least(const Value& value) const {
        std::size_t best = 0;
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (const double found = value(lines_[i]); found < least) {
                least = found;
                best = i;
            }
        return best;
    }
    [[nodiscard]] double angle(int i) const {
        return body_.begin + (body_.end - body_.begin) * i / (body_.poses - 1);
    }
    [[nodiscard]] Line line_at(double theta) const {
        const RollerPose roller = body_.roller(theta, 0.0);
        return {roller.center, roller.axis};
    }
    /// How far the cutter reaches out of the roller there. Its axis is farthest from the roller's at an end.
    [[nodiscard]] double depth_in(const Stand& stand, const Line& line) const {
        const Eigen::Vector3d tip = stand.pose.tip - line.foot;
        const Eigen::Vector3d back = tip - stand.way * stand.pose.axis;
        const auto beside = [&](const Eigen::Vector3d& p) {
            return (p - p.dot(line.direction) * line.direction).norm();
        };
        const double side = std::max(beside(tip), beside(back)) + stand.radius - body_.radius;
        const double lean = beside(stand.pose.axis);
        const double under = tip.dot(line.direction) + stand.radius * lean - body_.floor;
        return side > 0.0 && under > 0.0 ? std::sqrt(side * side + under * under) : std::max(side, under);
    }
    /// From pose i downhill to where the roller's line is nearest.
    [[nodiscard]] std::size_t descended(const Stand& stand, std::size_t i) const {
        double here = depth_in(stand, lines_[i]);
        while (true) {
            const double before = i > 0 ? depth_in(stand, lines_[i - 1]) : HUGE_VAL;
            const double after = i + 1 < lines_.size() ? depth_in(stand, lines_[i + 1]) : HUGE_VAL;
            if (!(std::min(before, after) < here)) return i;
            i = before < after ? i - 1 : i + 1;
            here = std::min(before, after);
        }
    }
    /// The least depth between the neighbours of pose i. It falls and rises once there: golden sections.
    [[nodiscard]] double depth_around(const Stand& stand, std::size_t i) const {
        const double low = angle(static_cast<int>(i > 0 ? i - 1 : i));
        const double high = angle(static_cast<int>(std::min(i + 1, lines_.size() - 1)));
        const GoldenSection found = golden_maximum(
            [&](double theta) { return -depth_in(stand, line_at(theta)); }, low, high, sections,
            [&](const GoldenSection& section) { return -section.value() <= body_.enough; });
        return std::min(depth_in(stand, lines_[i]), -found.value());
    }

    GroovedBody body_;
    std::vector<Line> lines_;
    std::size_t last_ = 0;
};

constexpr double axis_rounding = 1e-9;  // of a unit vector
constexpr int least_points = 16;
// Between two corners the contour is farthest from its chord near the middle; looked at in these places.
constexpr double looked_at[] = {0.25, 0.5, 0.75};
constexpr double arc_share = 1.1;      // the largest of those three against the largest of all, with room
constexpr double wanted_error = 2e-7;  // m, of an edge: below what lines of roughing are allowed
constexpr int halvings_of_edge = 6;

constexpr std::size_t run_size = 32;     // edges that one circle encloses
constexpr double rounding_room = 1e-12;  // of the size and the place of that circle

struct Edge {
    Eigen::Vector2d from, along;
    double inverse_square;  // of its length

    /// To its nearest point.
    [[nodiscard]] Eigen::Vector2d way_from(const Eigen::Vector2d& point) const {
        const Eigen::Vector2d away = point - from;
        const double share = std::clamp(away.dot(along) * inverse_square, 0.0, 1.0);
        return share * along - away;
    }
};

/// Edges one after the other, with a circle about them.
struct Run {
    std::span<const Edge> edges;
    Eigen::Vector2d center;
    double radius, lower, upper;  // lower, upper: of y

    explicit Run(std::span<const Edge> of) : edges(of) {
        Eigen::AlignedBox2d box;
        for (const Edge& edge : edges) box.extend(edge.from).extend(edge.from + edge.along);
        const double size = box.diagonal().norm(), room = rounding_room * (size + box.center().norm());
        center = box.center();
        radius = 0.5 * size + room;
        lower = box.min().y() - room;
        upper = box.max().y() + room;
    }
    [[nodiscard]] bool may_be_within(double square, const Eigen::Vector2d& point) const {
        const double gap = (point - center).norm() - radius;
        return gap <= 0.0 || gap * gap <= square;
    }
};

class PlaneCam final : public FinishedCam {
 public:
    explicit PlaneCam(const PlaneBody& body) : upper_(body.upper) {
        const double length = body.knots.back() - body.knots.front();
        for (std::size_t k = 1; k < body.knots.size(); ++k) {
            const double begin = body.knots[k - 1], width = body.knots[k] - begin;
            const int pieces = std::max(1, static_cast<int>(std::ceil(body.points * width / length)));
            for (int i = 0; i < pieces; ++i)
                add_edge(body.contour, begin + width * i / pieces, begin + width * (i + 1) / pieces,
                         halvings_of_edge);
        }
        const Eigen::Vector2d first = edges_.front().from, last = body.contour(body.knots.back()).position;
        if (const double square = (first - last).squaredNorm(); square > 0.0)  // the contour does not close
            edges_.push_back({last, first - last, 1.0 / square});
        for (std::size_t i = 0; i < edges_.size(); i += run_size)
            runs_.emplace_back(
                std::span<const Edge>(edges_).subspan(i, std::min(run_size, edges_.size() - i)));
    }

    double depth(const ToolPose& pose, double cutter_radius) override {
        if (!((pose.axis + Eigen::Vector3d::UnitZ()).norm() <= axis_rounding)) return HUGE_VAL;
        const double under = upper_ - pose.tip.z();
        if (under <= 0.0) return under;
        return std::min(under, cutter_radius + error_ - distance(pose.tip.head<2>()));
    }

    Eigen::Vector3d towards_flank(const ToolPose& pose) override {
        const Eigen::Vector2d way = way_from(pose.tip.head<2>());
        if (way.isZero(0.0)) return Eigen::Vector3d::Zero();
        return {way.x() / way.norm(), way.y() / way.norm(), 0.0};
    }

 private:
    void add_edge(const PlaneContour& contour, double begin, double end, int halvings) {
        const Eigen::Vector2d from = contour(begin).position, to = contour(end).position;
        const double square = (to - from).squaredNorm();
        const Edge edge{from, to - from, square > 0.0 ? 1.0 / square : 0.0};
        double error = 0.0;
        for (const double share : looked_at) {
            const Eigen::Vector2d point = contour(begin + share * (end - begin)).position;
            error = std::max(error, arc_share * edge.way_from(point).norm());
        }
        if (error > wanted_error && halvings > 0) {
            const double middle = 0.5 * (begin + end);
            add_edge(contour, begin, middle, halvings - 1);
            add_edge(contour, middle, end, halvings - 1);
            return;
        }
        if (square > 0.0) edges_.push_back(edge);
        error_ = std::max(error_, error);
    }
    /// To the cam's nearest point. The run of the last point first: points follow one another.
    [[nodiscard]] Eigen::Vector2d way_from(const Eigen::Vector2d& point) {
        Eigen::Vector2d least = Eigen::Vector2d::Zero();
        double square = std::numeric_limits<double>::infinity();
        const auto look_at = [&](std::size_t run) {
            for (const Edge& edge : runs_[run].edges) {
                const Eigen::Vector2d way = edge.way_from(point);
                if (way.squaredNorm() >= square) continue;
                least = way;
                square = way.squaredNorm();
                last_ = run;
            }
        };
        const std::size_t first = last_;
        look_at(first);
        for (std::size_t run = 0; run < runs_.size(); ++run)
            if (run != first && runs_[run].may_be_within(square, point)) look_at(run);
        return least;
    }
    /// Of the contour around the point.
    [[nodiscard]] int turns_around(const Eigen::Vector2d& point) const {
        int turns = 0;
        for (const Run& run : runs_) {
            if (point.y() < run.lower || point.y() > run.upper) continue;
            for (const Edge& edge : run.edges) {
                const double begin = edge.from.y() - point.y(), end = begin + edge.along.y();
                if ((begin <= 0.0) == (end <= 0.0)) continue;
                const double side = edge.along.x() * -begin - edge.along.y() * (point.x() - edge.from.x());
                if (begin <= 0.0 && side > 0.0) ++turns;
                if (begin > 0.0 && side < 0.0) --turns;
            }
        }
        return turns;
    }
    /// To the cam, less than 0 inside it.
    [[nodiscard]] double distance(const Eigen::Vector2d& point) {
        const double away = way_from(point).norm();
        return turns_around(point) == 0 ? away : -away;
    }

    double upper_, error_ = 0.0;
    std::vector<Edge> edges_;
    std::vector<Run> runs_;
    std::size_t last_ = 0;
};

}  // namespace

std::unique_ptr<FinishedCam> grooved_finished_cam(const GroovedBody& body) {
    const auto require = [](bool holds, const char* what, double found) {
        if (!holds) throw InputError(fmt::format("finished cam: {}, found {:g}", what, found));
    };
    body.blank.validate();
    require(std::isfinite(body.end - body.begin) && body.end > body.begin, "the cam angles must ascend",
            body.end - body.begin);
    require(std::isfinite(body.radius) && body.radius > 0.0, "the roller's radius must be > 0 m",
            body.radius);
    require(std::isfinite(body.floor), "the groove's floor must be a finite station", body.floor);
    require(body.poses >= least_poses, "there must be 16 poses or more", body.poses);
    return std::make_unique<GroovedCam>(body);
}

std::unique_ptr<FinishedCam> plane_finished_cam(const PlaneBody& body) {
    if (body.knots.size() < 2 || !(body.knots.back() > body.knots.front()))
        throw InputError("finished cam: its contour needs two knots or more, ascending");
    if (body.points < least_points)
        throw InputError(
            fmt::format("finished cam: it needs {} points or more, found {}", least_points, body.points));
    return std::make_unique<PlaneCam>(body);
}

}  // namespace camopt
