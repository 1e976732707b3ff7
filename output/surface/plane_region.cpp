// SPDX-License-Identifier: MIT
#include "output/surface/plane_region.hpp"

#include "core/errors.hpp"

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using Eigen::Vector2d;

double turn_of(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    const Vector2d u = b - a, v = c - b;
    return u.x() * v.y() - u.y() * v.x();
}

/// The open segments have a point in common.
bool segments_cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    return turn_of(a, b, c) * turn_of(a, b, d) < 0.0 && turn_of(c, d, a) * turn_of(c, d, b) < 0.0;
}

bool crosses(const Vector2d& from, const Vector2d& to, std::span<const Vector2d> polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        if (segments_cross(from, to, polygon[i], polygon[(i + 1) % polygon.size()])) return true;
    return false;
}

class EarCutter {
 public:
    EarCutter(std::span<const Vector2d> outline, std::span<const Vector2d> hole) {
        for (const std::span<const Vector2d> part : {outline, hole})
            points_.insert(points_.end(), part.begin(), part.end());
        area_ = polygon_area(outline);
        const int count = static_cast<int>(outline.size());
        for (int i = 0; i < count; ++i) ring_.push_back(i);
        if (!hole.empty()) join(outline, hole);
    }

    [[nodiscard]] std::vector<std::array<int, 3>> cut() {
        std::vector<std::array<int, 3>> triangles;
        std::size_t at = 0, since = 0;
        while (ring_.size() > 3) {
            const std::size_t count = ring_.size();
            at %= count;
            if (is_ear(at)) {
                triangles.push_back({corner(at + count - 1), corner(at), corner(at + 1)});
                ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
                since = 0;
                at += 1;  // the next but one: fewer slivers than a fan
                continue;
            }
            if (++since > count) {
                at = flattest();
                triangles.push_back({corner(at + count - 1), corner(at), corner(at + 1)});
                ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
                since = 0;
            }
            ++at;
        }
        triangles.push_back({ring_[0], ring_[1], ring_[2]});
        return triangles;
    }

 private:
    static constexpr double flat_ = 1e-7;  // of the outline's area

    std::vector<Vector2d> points_;
    std::vector<int> ring_;
    double area_ = 0.0;

    [[nodiscard]] int corner(std::size_t at) const { return ring_[at % ring_.size()]; }
    [[nodiscard]] const Vector2d& place(int index) const { return points_[static_cast<std::size_t>(index)]; }

    /// Where lines lie on each other but for rounding no corner is an ear: the flattest goes.
    [[nodiscard]] std::size_t flattest() const {
        const std::size_t count = ring_.size();
        std::size_t best = 0;
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < count; ++i)
            if (const double turn =
                    std::abs(turn_of(place(corner(i + count - 1)), place(corner(i)), place(corner(i + 1))));
                turn < least) {
                least = turn;
                best = i;
            }
        if (least > flat_ * area_) throw InputError("a plane region has lines that cross each other");
        return best;
    }

    /// The ring runs along the outline, over the bridge, against the sense of the hole around it, and back.
    void join(std::span<const Vector2d> outline, std::span<const Vector2d> hole) {
        struct Bridge {
            double length;
            int outer, inner;
        };
        std::vector<Bridge> bridges;
        for (std::size_t k = 0; k < hole.size(); ++k) {
            Bridge best{HUGE_VAL, 0, static_cast<int>(k)};
            for (std::size_t i = 0; i < outline.size(); ++i)
                if (const double length = (outline[i] - hole[k]).norm(); length < best.length)
                    best = {length, static_cast<int>(i), static_cast<int>(k)};
            bridges.push_back(best);
        }
        std::ranges::sort(bridges, {}, &Bridge::length);
        for (const Bridge& bridge : bridges) {
            const Vector2d &from = outline[static_cast<std::size_t>(bridge.outer)],
                           &to = hole[static_cast<std::size_t>(bridge.inner)];
            if (crosses(from, to, outline) || crosses(from, to, hole)) continue;
            const int first = static_cast<int>(outline.size()), count = static_cast<int>(hole.size());
            std::vector<int> around;
            for (int k = 0; k <= count; ++k) around.push_back(first + (bridge.inner - k + 2 * count) % count);
            around.push_back(bridge.outer);
            ring_.insert(ring_.begin() + bridge.outer + 1, around.begin(), around.end());
            return;
        }
        throw InputError("a plane region's hole cannot be joined to its outline");
    }

    [[nodiscard]] bool is_ear(std::size_t at) const {
        const std::size_t count = ring_.size();
        const Vector2d &a = place(corner(at + count - 1)), &b = place(corner(at)), &c = place(corner(at + 1));
        if (!(turn_of(a, b, c) > 0.0)) return false;
        const Vector2d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        return std::ranges::none_of(ring_, [&](int index) {
            const Vector2d& point = place(index);
            if (point.x() < low.x() || point.x() > high.x() || point.y() < low.y() || point.y() > high.y())
                return false;
            if (point == a || point == b || point == c) return false;
            return turn_of(a, b, point) >= 0.0 && turn_of(b, c, point) >= 0.0 && turn_of(c, a, point) >= 0.0;
        });
    }
};

}  // namespace

double polygon_area(std::span<const Vector2d> polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

std::vector<std::array<int, 3>> plane_triangles(std::span<const Vector2d> outline,
                                                std::span<const Vector2d> hole) {
    const auto is_line = [](std::span<const Vector2d> part) {
        return part.size() >= 3 && polygon_area(part) > 0.0;
    };
    if (!is_line(outline) || !(hole.empty() || is_line(hole)))
        throw InputError("a plane region needs lines of three corners or more that turn to the left");
    return EarCutter(outline, hole).cut();
}

}  // namespace camopt
