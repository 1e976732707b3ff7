// SPDX-License-Identifier: MIT
#include "output/chart/curve_path.hpp"

#include "output/chart/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace camopt {

namespace {

constexpr std::size_t most_pieces = 1500;  // more than a picture of 1000 px can show
constexpr double points_over_all = 360;    // points a curve gets at least, spread over its pieces by length

std::vector<double> drawn_breakpoints(const Motion& motion) {
    std::vector<double> all = motion.breakpoints();
    if (all.size() <= most_pieces) return all;
    std::vector<double> some;
    for (std::size_t i = 0; i <= most_pieces; ++i) some.push_back(all[i * (all.size() - 1) / most_pieces]);
    return some;
}

/// Calls back with the points of each piece: both ends seen from inside.
void for_each_piece(const Motion& motion, const std::function<void(const std::vector<MotionPoint>&)>& use) {
    const std::vector<double> breakpoints = drawn_breakpoints(motion);
    const double length = motion.end() - motion.begin();
    std::vector<MotionPoint> points;
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        const double left = breakpoints[i], right = breakpoints[i + 1];
        const int steps = std::max(2, static_cast<int>(std::ceil(points_over_all * (right - left) / length)));
        points.clear();
        points.push_back(motion.at(left, Side::right));
        for (int k = 1; k < steps; ++k) points.push_back(motion.at(left + (right - left) * k / steps));
        points.push_back(motion.at(right, Side::left));
        use(points);
    }
}

/// A piece whose jerk is constant needs its ends only.
bool is_constant(const std::vector<MotionPoint>& points, std::size_t order) {
    const double first = points.front().derivative[order];
    return std::all_of(points.begin(), points.end(), [&](const MotionPoint& point) {
        return std::abs(point.derivative[order] - first) <= 1e-9 * std::abs(first);
    });
}

class PathWriter {
 public:
    PathWriter(const PlotMap& map, std::size_t order) : map_(map), order_(order) {}

    void piece(const std::vector<MotionPoint>& points) {
        const std::size_t stride = order_ == 3 && is_constant(points, order_) ? points.size() - 1 : 1;
        for (std::size_t k = 0; k < points.size(); k += stride) {
            const bool smooth = k > 0 && order_ < 3;
            if (!std::isfinite(points[k].derivative[order_]))
                pen_down_ = false;
            else if (pen_down_ && smooth && std::isfinite(points[k - 1].derivative[order_ + 1]) &&
                     std::isfinite(points[k].derivative[order_ + 1]))
                curve_to(points[k - 1], points[k]);
            else
                line_to(points[k]);
        }
    }
    [[nodiscard]] const std::string& data() const { return data_; }

 private:
    [[nodiscard]] std::string place(double x, double value) const {
        return svg_number(map_.horizontal(x)) + " " + svg_number(map_.vertical(value));
    }
    void line_to(const MotionPoint& point) {
        data_ += pen_down_ ? 'L' : 'M';
        data_ += place(point.x, point.derivative[order_]);
        pen_down_ = true;
    }
    void curve_to(const MotionPoint& from, const MotionPoint& to) {
        const double third = (to.x - from.x) / 3.0;
        data_ += fmt::format(
            "C{} {} {}", place(from.x + third, from.derivative[order_] + third * from.derivative[order_ + 1]),
            place(to.x - third, to.derivative[order_] - third * to.derivative[order_ + 1]),
            place(to.x, to.derivative[order_]));
    }

    const PlotMap& map_;
    std::size_t order_;
    std::string data_;
    bool pen_down_ = false;
};

}  // namespace

std::string curve_path(const Motion& motion, int order, const PlotMap& map) {
    PathWriter writer(map, static_cast<std::size_t>(order));
    for_each_piece(motion, [&](const std::vector<MotionPoint>& points) { writer.piece(points); });
    return writer.data();
}

ValueRange value_range(const Motion& motion, int order) {
    ValueRange range;
    range.add(0.0);
    for_each_piece(motion, [&](const std::vector<MotionPoint>& points) {
        for (const MotionPoint& point : points) range.add(point.derivative[static_cast<std::size_t>(order)]);
    });
    return range;
}

}  // namespace camopt
