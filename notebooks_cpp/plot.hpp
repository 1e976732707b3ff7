// SPDX-License-Identifier: MIT
// Curves over a common axis as one SVG picture, in the style of camopt's own pictures.
//
//     notebook::Plot plot("Velocity", "x", "y'");
//     plot.line(xs, ys, "modified sine").dashes(xs, zs, "optimum").points(px, py, "").level(1.8, "limit");
//     display_svg(plot.svg());
//
// Values that are not finite break a line. Nothing throws.
#pragma once

#include "report/chart/svg_canvas.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace notebook {

/// `count` values from `begin` to `end`, evenly, both included.
inline std::vector<double> evenly(double begin, double end, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(begin + (end - begin) * i / (count - 1));
    return values;
}

/// f of each value.
template <class Function>
std::vector<double> each(const std::vector<double>& values, Function f) {
    std::vector<double> results;
    for (const double value : values) results.push_back(f(value));
    return results;
}

class Plot {
 public:
    Plot(std::string title, std::string across, std::string up)
        : title_(std::move(title)), across_(std::move(across)), up_(std::move(up)) {}

    /// A name that is empty has no place in the legend.
    Plot& line(std::vector<double> x, std::vector<double> y, std::string name) {
        return add({Kind::line, std::move(x), std::move(y), std::move(name)});
    }
    Plot& dashes(std::vector<double> x, std::vector<double> y, std::string name) {
        return add({Kind::dashes, std::move(x), std::move(y), std::move(name)});
    }
    Plot& points(std::vector<double> x, std::vector<double> y, std::string name) {
        return add({Kind::points, std::move(x), std::move(y), std::move(name)});
    }
    /// A dotted line across the whole picture, a limit, with its words on it.
    Plot& level(double value, std::string words) {
        levels_.emplace_back(value, std::move(words));
        return *this;
    }
    /// Words at a point.
    Plot& label(double x, double y, std::string words) {
        labels_.push_back({x, y, std::move(words)});
        return *this;
    }
    /// The range shown upwards, instead of that of the values.
    Plot& range(double lower, double upper) {
        lower_ = lower;
        upper_ = upper;
        return *this;
    }
    Plot& size(double width, double height) {
        width_ = width;
        height_ = height;
        return *this;
    }

    [[nodiscard]] std::string svg() const {
        camopt::SvgCanvas canvas(width_, height_, style(), title_);
        canvas.rectangle(0, 0, width_, height_, "page");
        canvas.text(16, 26, title_, "caption");
        const double left = 72, top = 44 + 18 * legend_lines(), right = width_ - 20, bottom = height_ - 52;
        camopt::PlotFrame frame;
        frame.horizontal = {across_range().lower, across_range().upper, left, right};
        const camopt::ValueRange up = up_range();
        frame.vertical = {up.lower, up.upper, bottom, top};
        frame.horizontal_ticks = camopt::labelled_ticks(frame.horizontal.lower, frame.horizontal.upper, 8);
        frame.vertical_ticks = camopt::labelled_ticks(up.lower, up.upper, 6);
        frame.horizontal_title = across_;
        frame.vertical_title = up_;
        camopt::draw_plot_frame(canvas, frame);
        if (up.lower < 0 && up.upper > 0)
            canvas.line(left, frame.vertical.place(0), right, frame.vertical.place(0), "zero");
        for (const auto& [value, words] : levels_) {
            canvas.line(left, frame.vertical.place(value), right, frame.vertical.place(value), "level");
            canvas.text(right - 6, frame.vertical.place(value) - 5, words, "value right");
        }
        for (std::size_t i = 0; i < series_.size(); ++i) draw(canvas, frame, i);
        draw_legend(canvas, right);
        for (const auto& [x, y, words] : labels_)
            canvas.text(frame.horizontal.place(x) + 7, frame.vertical.place(y) - 6, words, "value");
        return canvas.finish();
    }

 private:
    enum class Kind { line, dashes, points };
    struct Series {
        Kind kind;
        std::vector<double> x, y;
        std::string name;
    };
    struct Label {
        double x, y;
        std::string words;
    };

    Plot& add(Series series) {
        series_.push_back(std::move(series));
        return *this;
    }

    /// Colours of Okabe and Ito: told apart by colour-blind readers too.
    static std::string style() {
        std::string rules =
            ".level{stroke:#b00020;stroke-width:1.2;stroke-dasharray:2 4}.dash{stroke-dasharray:7 4}";
        const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#555555"};
        for (int i = 0; i < 7; ++i) {
            const std::string number = std::to_string(i);
            rules += ".c" + number + "{fill:none;stroke-width:2;stroke:" + colours[i] + "}.p" + number +
                     "{fill:" + colours[i] + "}";
        }
        return rules;
    }

    [[nodiscard]] camopt::ValueRange across_range() const {
        camopt::ValueRange range;
        for (const Series& series : series_)
            for (const double x : series.x) range.add(x);
        return range;
    }
    [[nodiscard]] camopt::ValueRange up_range() const {
        camopt::ValueRange range;
        if (upper_ > lower_) {
            range.add(lower_);
            range.add(upper_);
            return range;
        }
        for (const Series& series : series_)
            for (const double y : series.y)
                if (std::isfinite(y)) range.add(y);
        for (const auto& [value, words] : levels_) range.add(value);
        return range.padded(0.05);
    }

    void draw(camopt::SvgCanvas& canvas, const camopt::PlotFrame& frame, std::size_t index) const {
        const Series& series = series_[index];
        const std::string colour = std::to_string(index % 7);
        std::string path;
        bool pen_down = false;
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            const bool shown = std::isfinite(series.y[i]) && frame.vertical.holds(series.y[i]);
            const double across = frame.horizontal.place(series.x[i]), up = frame.vertical.place(series.y[i]);
            if (shown && series.kind == Kind::points) canvas.circle(across, up, 3.5, "p" + colour);
            if (shown) {
                path += pen_down ? 'L' : 'M';
                path += camopt::svg_number(across) + ' ' + camopt::svg_number(up);
            }
            pen_down = shown;
        }
        if (series.kind != Kind::points && !path.empty())
            canvas.path(path, (series.kind == Kind::dashes ? "dash c" : "c") + colour);
    }

    /// Where names stand: how far across, and on which line.
    [[nodiscard]] std::vector<std::pair<double, int>> legend_places() const {
        std::vector<std::pair<double, int>> places;
        double across = 72;
        int line = 0;
        for (const Series& series : series_) {
            const double width = series.name.empty() ? 0 : 52 + 7.2 * static_cast<double>(series.name.size());
            if (across > 72 && across + width > width_ - 20) {
                across = 72;
                ++line;
            }
            places.emplace_back(across, line);
            across += width;
        }
        return places;
    }
    [[nodiscard]] int legend_lines() const {
        bool any = false;
        for (const Series& series : series_) any = any || !series.name.empty();
        return any ? legend_places().back().second + 1 : 0;
    }
    void draw_legend(camopt::SvgCanvas& canvas, double) const {
        const auto places = legend_places();
        for (std::size_t i = 0; i < series_.size(); ++i) {
            const Series& series = series_[i];
            if (series.name.empty()) continue;
            const double x = places[i].first, y = 46 + 18.0 * places[i].second;
            const std::string colour = std::to_string(i % 7);
            if (series.kind == Kind::points)
                canvas.circle(x + 13, y - 4, 3.5, "p" + colour);
            else
                canvas.line(x, y - 4, x + 26, y - 4, (series.kind == Kind::dashes ? "dash c" : "c") + colour);
            canvas.text(x + 32, y, series.name, "value");
        }
    }

    std::string title_, across_, up_;
    std::vector<Series> series_;
    std::vector<std::pair<double, std::string>> levels_;
    std::vector<Label> labels_;
    double lower_ = 0.0, upper_ = 0.0, width_ = 760.0, height_ = 380.0;
};

}  // namespace notebook
