// SPDX-License-Identifier: MIT
#include "output/chart/plot_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace camopt {

namespace {

constexpr double decade_rounding = 1e-9;  // a power of ten on the end of the axis is inside

std::string raised(int exponent) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += digits[static_cast<std::size_t>(digit - '0')];
    return text;
}

std::string power_words(int exponent) {
    if (exponent == 0) return "1";
    return "10" + (exponent == 1 ? std::string{} : raised(exponent));
}

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

double PlotAxis::place(double value) const {
    const double part =
        logarithmic ? std::log(value / lower) / std::log(upper / lower) : (value - lower) / (upper - lower);
    return begin + part * (end - begin);
}

void draw_plot_frame(SvgCanvas& canvas, const PlotFrame& frame) {
    const PlotAxis &across = frame.horizontal, &up = frame.vertical;
    for (const PlotTick& tick : frame.vertical_ticks) {
        const double y = up.place(tick.value);
        canvas.line(across.begin, y, across.end, y, "grid");
        if (!tick.words.empty()) canvas.text(across.begin - 7, y + 4, tick.words, "tick right");
    }
    for (const PlotTick& tick : frame.horizontal_ticks) {
        const double x = across.place(tick.value);
        canvas.line(x, up.begin, x, up.end, "grid");
        if (!tick.words.empty()) canvas.text(x, up.begin + 16, tick.words, "tick middle");
    }
    canvas.rectangle(across.begin, up.end, across.end - across.begin, up.begin - up.end, "frame");
    if (!frame.horizontal_title.empty())
        canvas.text(0.5 * (across.begin + across.end), up.begin + 36, frame.horizontal_title, "axis-title");
    if (!frame.vertical_title.empty())
        canvas.text(across.begin - 52, 0.5 * (up.begin + up.end), frame.vertical_title, "axis-title", 90.0);
}

std::vector<PlotTick> decade_ticks(double lower, double upper, int stride) {
    std::vector<PlotTick> ticks;
    const int first = static_cast<int>(std::ceil(std::log10(lower) - decade_rounding));
    const int last = static_cast<int>(std::floor(std::log10(upper) + decade_rounding));
    for (int exponent = first; exponent <= last; ++exponent)
        ticks.push_back(
            {std::pow(10.0, exponent), exponent % stride == 0 ? power_words(exponent) : std::string{}});
    return ticks;
}

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
