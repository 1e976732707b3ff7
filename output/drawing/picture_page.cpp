// SPDX-License-Identifier: MIT
#include "output/drawing/picture_page.hpp"

#include "output/chart/plot_frame.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/number_text.hpp"
#include "studies/check/check_cam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double picture_margin = 0.05;                  // of the picture's size, on each side
constexpr double entry_height = 21, least_entry = 15.5;  // px
constexpr double heading_room = 8, sample_length = 30, sample_words = 40, number_right = 215;

}  // namespace

PictureBox PictureBox::with_room() const {
    const Vector2d room = Vector2d::Constant(picture_margin * (most - least).maxCoeff());
    PictureBox larger;
    larger.least = least - room;
    larger.most = most + room;
    return larger;
}

ProfileCanvas fitted_canvas(SvgCanvas& canvas, const PictureBox& box) {
    const Vector2d size = box.most - box.least, middle = 0.5 * (box.least + box.most);
    const double scale = std::min(picture_frame_width / size.x(), picture_frame_height / size.y());
    return {canvas,
            {picture_left + 0.5 * picture_frame_width - scale * middle.x(),
             picture_top + 0.5 * picture_frame_height + scale * middle.y()},
            scale};
}

void draw_length_frame(const ProfileCanvas& drawing, const ShownUnit& length, std::string_view words) {
    const double one = drawing.scale / length.factor;
    const double right = picture_left + picture_frame_width, bottom = picture_top + picture_frame_height;
    PlotFrame frame;
    frame.horizontal = {(picture_left - drawing.origin.x()) / one, (right - drawing.origin.x()) / one,
                        picture_left, right};
    frame.vertical = {(drawing.origin.y() - bottom) / one, (drawing.origin.y() - picture_top) / one, bottom,
                      picture_top};
    frame.horizontal_ticks = labelled_ticks(frame.horizontal.lower, frame.horizontal.upper, 8);
    frame.vertical_ticks = labelled_ticks(frame.vertical.lower, frame.vertical.upper, 8);
    frame.horizontal_title = words;
    draw_plot_frame(drawing.canvas, frame);
}

LegendColumn::LegendColumn(SvgCanvas& canvas, ShownUnit length, int entries)
    : canvas_(canvas),
      step_(std::clamp((picture_frame_height - 20.0) / std::max(entries, 1), least_entry, entry_height)),
      length_(std::move(length)) {}

void LegendColumn::heading(std::string_view words) {
    y_ += heading_room;
    canvas_.text(picture_legend_left, y_, words, "heading");
    y_ += step_;
}

void LegendColumn::sample(const char* css_class, std::string_view words) {
    canvas_.line(picture_legend_left, y_ - 4, picture_legend_left + sample_length, y_ - 4, css_class);
    canvas_.text(picture_legend_left + sample_words, y_, words, "entry");
    y_ += step_;
}

void LegendColumn::value(std::string_view name, double length) {
    value(name, std::string_view(length_.text(length)));
}

void LegendColumn::value(std::string_view name, std::string_view shown) {
    canvas_.text(picture_legend_left, y_, name, "entry");
    canvas_.text(picture_legend_left + number_right, y_, shown, "entry number");
    y_ += step_;
}

void LegendColumn::words(std::string_view text, const char* css_class) {
    canvas_.text(picture_legend_left, y_, text, css_class);
    y_ += step_;
}

void add_dimensions(LegendColumn& column, const Solution& solution) {
    for (const DimensionValue& dimension : cam_dimensions(solution))
        column.value(words_of(dimension.name), std::string_view(dimension.text));
}

void add_figures(LegendColumn& column, const Solution& solution) {
    for (const CamFigure& figure : cam_figures(solution)) {
        column.words(figure.name);
        column.value("", std::string_view(figure.degrees.empty()
                                              ? figure.value
                                              : fmt::format("{} at {}°", figure.value, figure.degrees)));
    }
}

void add_opening(LegendColumn& column, const Solution& solution) {
    const std::string why = open_because(solution);
    column.words("OPEN: nothing closes the cam", "warning");
    column.words(why.substr(0, why.find(": ")));
}

int dimension_entries(const Solution& solution) {
    return static_cast<int>(cam_dimensions(solution).size());
}

int figure_entries(const Solution& solution) {
    return 2 * static_cast<int>(cam_figures(solution).size());
}

std::string_view picture_style() {
    return ".heading{font-size:13px;font-weight:600}.number{text-anchor:end}.warning{fill:#d00000;font-"
           "weight:600}";
}

}  // namespace camopt
