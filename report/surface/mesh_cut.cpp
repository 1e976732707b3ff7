// SPDX-License-Identifier: MIT
#include "report/surface/mesh_cut.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace camopt {

namespace {

constexpr double same_vertex = 1e-8;  // m

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Vertices at one place become one; those in no triangle and triangles without an area go.
TriangleMesh welded(const TriangleMesh& mesh) {
    TriangleMesh result;
    std::map<std::array<long long, 3>, int> known;
    for (const auto& t : mesh.triangles) {
        std::array<int, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3d& vertex = mesh.vertices[at(t[i])];
            const auto key = [&](int k) { return std::llround(vertex[k] / same_vertex); };
            const auto [place, is_new] =
                known.emplace(std::array{key(0), key(1), key(2)}, static_cast<int>(result.vertices.size()));
            if (is_new) result.vertices.push_back(vertex);
            corners[i] = place->second;
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            result.triangles.push_back(corners);
    }
    return result;
}

/// What lies at sign · z <= sign · plane. Cut edges get one vertex, so neighbours stay neighbours.
TriangleMesh cut_off(TriangleMesh mesh, double plane, double sign) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        if (std::abs(vertex.z() - plane) < same_vertex) vertex.z() = plane;
    const auto beyond = [&](int i) { return sign * (mesh.vertices[at(i)].z() - plane); };
    std::map<std::pair<int, int>, int> cuts;
    const auto cut = [&](int a, int b) {
        const auto [place, is_new] = cuts.emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
        if (is_new) {
            const auto [low, high] = place->first;
            const double share = beyond(low) / (beyond(low) - beyond(high));
            Eigen::Vector3d vertex =
                mesh.vertices[at(low)] + share * (mesh.vertices[at(high)] - mesh.vertices[at(low)]);
            vertex.z() = plane;
            mesh.vertices.push_back(vertex);
        }
        return place->second;
    };
    std::vector<std::array<int, 3>> kept;
    for (const auto& t : mesh.triangles) {
        std::vector<int> corners;
        bool has_inside = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const int here = t[i], next = t[(i + 1) % 3];
            has_inside = has_inside || beyond(here) < 0.0;
            if (beyond(here) <= 0.0) corners.push_back(here);
            if (beyond(here) * beyond(next) < 0.0) corners.push_back(cut(here, next));
        }
        for (std::size_t i = 2; has_inside && i < corners.size(); ++i)
            kept.push_back({corners[0], corners[i - 1], corners[i]});
    }
    mesh.triangles = std::move(kept);
    return mesh;
}

/// The borders in a plane as closed lines, along the edges that a cap must have.
std::vector<std::vector<int>> borders_in(const TriangleMesh& mesh, double plane) {
    std::set<std::pair<int, int>> open;
    const auto in_plane = [&](int i) { return mesh.vertices[at(i)].z() == plane; };
    for (const auto& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (const int a = t[i], b = t[(i + 1) % 3]; in_plane(a) && in_plane(b) && open.erase({a, b}) == 0)
                open.emplace(b, a);
    std::multimap<int, int> next(open.begin(), open.end());
    std::vector<std::vector<int>> borders;
    std::vector<int> way;
    while (!next.empty()) {
        if (way.empty()) way.push_back(next.begin()->first);
        const auto edge = next.find(way.back());
        if (edge == next.end())
            throw InputError("a surface around an axis is open between the planes that cut it");
        const int corner = edge->second;
        next.erase(edge);
        // A corner that is passed again ends a separate line.
        const auto again = std::ranges::find(way, corner);
        if (again == way.end()) {
            way.push_back(corner);
            continue;
        }
        borders.emplace_back(again, way.end());
        way.erase(again + (again == way.begin() ? 0 : 1), way.end());
    }
    return borders;
}

/// A border as it is seen from outside. sign: +1 the upper plane.
std::vector<Eigen::Vector2d> seen(const TriangleMesh& mesh, const std::vector<int>& border, double sign) {
    std::vector<Eigen::Vector2d> line;
    line.reserve(border.size());
    for (const int i : border) {
        const Eigen::Vector3d& vertex = mesh.vertices[at(i)];
        line.push_back(sign > 0.0 ? Eigen::Vector2d(vertex.x(), vertex.y())
                                  : Eigen::Vector2d(vertex.y(), vertex.x()));
    }
    return line;
}

/// Closes the mesh in a plane, up to the bore whose corners begin at `first`.
void close(TriangleMesh& mesh, const std::vector<std::vector<int>>& borders, int first, int corners,
           double sign) {
    const auto line_of = [&](const std::vector<int>& border) { return seen(mesh, border, sign); };
    std::vector<int> hole;
    hole.reserve(at(corners));
    for (int k = 0; k < corners; ++k) hole.push_back(first + (sign > 0.0 ? k : corners - 1 - k));
    const auto around = std::ranges::max_element(
        borders, {}, [&](const std::vector<int>& border) { return polygon_area(line_of(border)); });
    if (around == borders.end())
        throw InputError("a surface around an axis does not reach the planes that cut it");
    for (auto border = borders.begin(); border != borders.end(); ++border) {
        std::vector<int> indices = *border;
        const std::vector<Eigen::Vector2d> outline = line_of(indices);
        const bool bored = border == around;
        if (bored) indices.insert(indices.end(), hole.begin(), hole.end());
        for (const auto& t : plane_triangles(outline, bored ? line_of(hole) : std::vector<Eigen::Vector2d>{}))
            mesh.triangles.push_back({indices[at(t[0])], indices[at(t[1])], indices[at(t[2])]});
    }
}

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
    [[nodiscard]] const Vector2d& place(int index) const { return points_[index]; }

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
            const Vector2d &from = outline[bridge.outer], &to = hole[bridge.inner];
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

TriangleMesh bored_solid(const TriangleMesh& surface, const Bore& bore) {
    TriangleMesh mesh = welded(surface);
    mesh = cut_off(cut_off(std::move(mesh), bore.upper, 1.0), bore.lower, -1.0);
    auto above = borders_in(mesh, bore.upper);
    double turned = 0.0;
    for (const std::vector<int>& border : above) turned += polygon_area(seen(mesh, border, 1.0));
    if (turned < 0.0) {
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
        for (std::vector<int>& border : above) std::ranges::reverse(border);
    }
    const auto below = borders_in(mesh, bore.lower);
    const int first = static_cast<int>(mesh.vertices.size());
    for (const double z : {bore.lower, bore.upper})
        for (int k = 0; k < bore.corners; ++k) {
            const double angle = units::turn * k / bore.corners;
            mesh.vertices.emplace_back(bore.radius * std::cos(angle), bore.radius * std::sin(angle), z);
        }
    for (int k = 0; k < bore.corners; ++k) {
        const int a = first + k, b = first + (k + 1) % bore.corners;
        mesh.triangles.push_back({a, a + bore.corners, b});
        mesh.triangles.push_back({b, a + bore.corners, b + bore.corners});
    }
    close(mesh, above, first + bore.corners, bore.corners, 1.0);
    close(mesh, below, first, bore.corners, -1.0);
    return welded(mesh);
}

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
