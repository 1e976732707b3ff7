// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "output/nc/finished_cam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace camopt {

namespace {

constexpr double axis_rounding = 1e-9;  // of a unit vector
constexpr int least_points = 16;
// Between two corners the contour is farthest from its chord near the middle; looked at in these places.
constexpr double looked_at[] = {0.25, 0.5, 0.75};
constexpr double arc_share = 1.1;  // the largest of those three against the largest of all, with room

struct Edge {
    Eigen::Vector2d from, along;
    double inverse_square;  // of its length
};

class PlaneCam final : public FinishedCam {
 public:
    explicit PlaneCam(const PlaneBody& body) : upper_(body.upper) {
        const double length = body.knots.back() - body.knots.front();
        for (std::size_t k = 1; k < body.knots.size(); ++k) {
            const double begin = body.knots[k - 1], width = body.knots[k] - begin;
            const int pieces = std::max(1, static_cast<int>(std::ceil(body.points * width / length)));
            for (int i = 0; i < pieces; ++i)
                add_edge(body.contour, begin + width * i / pieces, begin + width * (i + 1) / pieces);
        }
        const Eigen::Vector2d first = edges_.front().from, last = body.contour(body.knots.back()).position;
        add_chord(last, first);  // of no length where the contour closes
    }

    double depth(const ToolPose& pose, double cutter_radius) override {
        if (!((pose.axis + Eigen::Vector3d::UnitZ()).norm() <= axis_rounding)) return HUGE_VAL;
        const double under = upper_ - pose.tip.z();
        if (under <= 0.0) return under;
        return std::min(under, cutter_radius + error_ - distance(pose.tip.head<2>()));
    }

    Eigen::Vector3d towards_flank(const ToolPose& pose) override {
        const Eigen::Vector2d tip = pose.tip.head<2>();
        const Edge& nearest =
            *std::ranges::min_element(edges_, {}, [&](const Edge& edge) { return square_to(edge, tip); });
        const Eigen::Vector2d from = tip - nearest.from;
        const double share = std::clamp(from.dot(nearest.along) * nearest.inverse_square, 0.0, 1.0);
        const Eigen::Vector2d way = share * nearest.along - from;
        if (way.isZero(0.0)) return Eigen::Vector3d::Zero();
        return {way.x() / way.norm(), way.y() / way.norm(), 0.0};
    }

 private:
    void add_chord(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        const double square = (to - from).squaredNorm();
        if (square > 0.0) edges_.push_back({from, to - from, 1.0 / square});
    }
    void add_edge(const PlaneContour& contour, double begin, double end) {
        const Eigen::Vector2d from = contour(begin).position, to = contour(end).position;
        add_chord(from, to);
        for (const double share : looked_at) {
            const Eigen::Vector2d point = contour(begin + share * (end - begin)).position;
            error_ = std::max(error_, arc_share * std::sqrt(square_to(edges_.back(), point)));
        }
    }
    [[nodiscard]] static double square_to(const Edge& edge, const Eigen::Vector2d& point) {
        const Eigen::Vector2d from = point - edge.from;
        const double share = std::clamp(from.dot(edge.along) * edge.inverse_square, 0.0, 1.0);
        return (from - share * edge.along).squaredNorm();
    }
    /// To the cam, less than 0 inside it.
    [[nodiscard]] double distance(const Eigen::Vector2d& point) const {
        double least = std::numeric_limits<double>::infinity();
        int turns = 0;  // of the contour around the point
        for (const Edge& edge : edges_) {
            least = std::min(least, square_to(edge, point));
            const double begin = edge.from.y() - point.y(), end = begin + edge.along.y();
            if ((begin <= 0.0) == (end <= 0.0)) continue;
            const double side = edge.along.x() * -begin - edge.along.y() * (point.x() - edge.from.x());
            if (begin <= 0.0 && side > 0.0) ++turns;
            if (begin > 0.0 && side < 0.0) --turns;
        }
        return turns == 0 ? std::sqrt(least) : -std::sqrt(least);
    }

    double upper_, error_ = 0.0;
    std::vector<Edge> edges_;
};

}  // namespace

std::unique_ptr<FinishedCam> plane_finished_cam(const PlaneBody& body) {
    if (body.knots.size() < 2 || !(body.knots.back() > body.knots.front()))
        throw InputError("finished cam: its contour needs two knots or more, ascending");
    if (body.points < least_points)
        throw InputError(
            fmt::format("finished cam: it needs {} points or more, found {}", least_points, body.points));
    return std::make_unique<PlaneCam>(body);
}

}  // namespace camopt
