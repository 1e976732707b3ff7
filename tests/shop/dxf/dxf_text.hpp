// SPDX-License-Identifier: MIT
// A small reader of DXF text for tests: tags, and the polylines with their bulges. mm.
#pragma once

#include <Eigen/Core>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace camopt::test {

struct DxfTag {
    int code = 0;
    std::string value;
};

inline std::vector<DxfTag> dxf_tags(const std::string& text) {
    std::vector<DxfTag> tags;
    std::istringstream lines(text);
    for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);)
        tags.push_back({std::atoi(code.c_str()), value});
    return tags;
}

struct DxfArc {
    Eigen::Vector2d from, to;
    double bulge = 0.0;
    /// To the circle, or the line, the arc lies on. Center by the formula of the DXF reference.
    [[nodiscard]] double distance(const Eigen::Vector2d& point) const {
        const Eigen::Vector2d chord = to - from, left(-chord.y(), chord.x());
        if (std::abs(bulge) < 1e-12) return std::abs(left.normalized().dot(point - from));
        const Eigen::Vector2d center = 0.5 * (from + to) + left * (1.0 - bulge * bulge) / (4.0 * bulge);
        return std::abs((point - center).norm() - (from - center).norm());
    }
    /// Whether the point lies beside the arc: the normal through it meets the arc, with a little to spare.
    [[nodiscard]] bool is_beside(const Eigen::Vector2d& point) const {
        const double along = (to - from).dot(point - from) / (to - from).squaredNorm();
        return along > -0.02 && along < 1.02 && (point - from).norm() < 2.0 * (to - from).norm();
    }
};

struct DxfPolyline {
    std::string layer;
    bool closed = false;
    std::vector<DxfArc> arcs;
    [[nodiscard]] double distance(const Eigen::Vector2d& point) const {
        double least = 1e9;
        for (const DxfArc& arc : arcs)
            if (arc.is_beside(point)) least = std::min(least, arc.distance(point));
        return least;
    }
};

inline std::vector<DxfPolyline> dxf_polylines(const std::string& text) {
    std::vector<DxfPolyline> polylines;
    std::vector<Eigen::Vector2d> places;
    std::vector<double> bulges;
    bool inside = false;
    const auto finish = [&] {
        if (!inside) return;
        DxfPolyline& line = polylines.back();
        for (std::size_t i = 0; i + (line.closed ? 0 : 1) < places.size(); ++i)
            line.arcs.push_back({places[i], places[(i + 1) % places.size()], bulges[i]});
        places.clear();
        bulges.clear();
    };
    for (const DxfTag& tag : dxf_tags(text)) {
        if (tag.code == 0) {
            finish();
            inside = tag.value == "LWPOLYLINE";
            if (inside) polylines.emplace_back();
        }
        if (!inside) continue;
        const double number = std::strtod(tag.value.c_str(), nullptr);
        if (tag.code == 8) polylines.back().layer = tag.value;
        if (tag.code == 70) polylines.back().closed = tag.value == "1";
        if (tag.code == 10) places.emplace_back(number, 0.0);
        if (tag.code == 20) places.back().y() = number;
        if (tag.code == 42) bulges.push_back(number);
    }
    return polylines;
}

}  // namespace camopt::test
