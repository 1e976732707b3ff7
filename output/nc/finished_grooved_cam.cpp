// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/numbers/scalar_search.hpp"
#include "output/nc/finished_cam.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
        std::size_t best = 0;
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (const double found = depth_in(stand, lines_[i]); found < least) {
                least = found;
                best = i;
            }
        const double anywhere = std::min(least, depth_around(stand, best));
        if (anywhere < near) last_ = best;
        return std::min(near, anywhere);
    }

    Eigen::Vector3d towards_flank(const ToolPose& pose) override {
        // The roller on the other side of the cam points here too: its floor lies before it comes so far.
        const auto square = [&](const Line& line) {
            const bool beyond = (pose.tip - line.foot).dot(line.direction) > body_.floor + body_.radius;
            return beyond ? HUGE_VAL : across(line, pose.tip).squaredNorm();
        };
        std::size_t best = 0;
        for (std::size_t i = 1; i < lines_.size(); ++i)
            if (square(lines_[i]) < square(lines_[best])) best = i;
        const int place = static_cast<int>(best), last = static_cast<int>(lines_.size()) - 1;
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
        return side > 0.0 && under > 0.0 ? std::hypot(side, under) : std::max(side, under);
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

}  // namespace camopt
