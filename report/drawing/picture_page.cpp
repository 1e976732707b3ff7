// SPDX-License-Identifier: MIT
#include "report/drawing/picture_page.hpp"

#include "report/view/cam_words.hpp"
#include "studies/delivered/delivered.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double picture_margin = 0.05;                  // of the picture's size, on each side
constexpr double entry_height = 21, least_entry = 15.5;  // px
constexpr double heading_room = 8, sample_length = 30, sample_words = 40, number_right = 215;

/// CSS rules of the column.
constexpr const char* column_style =
    ".heading{font-size:13px;font-weight:600}.number{text-anchor:end}.warning{fill:#d00000;font-weight:600}";

}  // namespace

PicturePlace fitted_place(const DrawingBox& box) {
    const Vector2d size = box.size() + Vector2d::Constant(2.0 * picture_margin * box.size().maxCoeff()),
                   middle = 0.5 * (box.least + box.most);
    const double scale = std::min(picture_frame_width / size.x(), picture_frame_height / size.y());
    return {{picture_left + 0.5 * picture_frame_width - scale * middle.x(),
             picture_top + 0.5 * picture_frame_height + scale * middle.y()},
            Vector2d::Constant(scale)};
}

PlotFrame frame_around(const PicturePlace& place, double top, double height, double along, double across,
                       int ticks_up) {
    const double right = picture_left + picture_frame_width, bottom = top + height,
                 kx = place.scale.x() * along, ky = place.scale.y() * across;
    PlotFrame frame;
    frame.horizontal = {(picture_left - place.origin.x()) / kx, (right - place.origin.x()) / kx, picture_left,
                        right};
    frame.vertical = {(place.origin.y() - bottom) / ky, (place.origin.y() - top) / ky, bottom, top};
    frame.horizontal_ticks = labelled_ticks(frame.horizontal.lower, frame.horizontal.upper, 8);
    frame.vertical_ticks = labelled_ticks(frame.vertical.lower, frame.vertical.upper, ticks_up);
    return frame;
}

void draw_length_frame(SvgCanvas& canvas, const PicturePlace& place, const ShownUnit& length,
                       std::string_view words) {
    PlotFrame frame = frame_around(place, picture_top, picture_frame_height, length.size, length.size);
    frame.horizontal_title = words;
    draw_plot_frame(canvas, frame);
}

PlacedTexts labels_of(const Drawing& drawing, const PicturePlace& place,
                      std::span<const std::string_view> avoided) {
    constexpr double inside = 4;  // px
    constexpr int corners = 90;   // of a circle
    PlacedTexts labels(picture_left + inside, picture_top + inside,
                       picture_left + picture_frame_width - inside,
                       picture_top + picture_frame_height - inside);
    const auto avoid = [&](const Vector2d& from, const Vector2d& to) {
        const Vector2d a = place(from), b = place(to);
        labels.avoid({a.x(), a.y()}, {b.x(), b.y()});
    };
    for (const DrawnElement& element : drawing.elements) {
        if (std::ranges::find(avoided, style_of(element)) == avoided.end()) continue;
        if (const auto* path = std::get_if<DrawnPath>(&element))
            for (std::size_t i = 1; i < path->vertices.size(); ++i)
                avoid(path->vertices[i - 1].position, path->vertices[i].position);
        if (const auto* circle = std::get_if<DrawnCircle>(&element)) {
            const auto at = [&](int corner) -> Vector2d {
                const double angle = units::turn * corner / corners;
                return circle->center + circle->radius * Vector2d(std::cos(angle), std::sin(angle));
            };
            for (int corner = 0; corner < corners; ++corner) avoid(at(corner), at(corner + 1));
        }
    }
    return labels;
}

LegendColumn::LegendColumn(SvgCanvas& canvas, int entries)
    : canvas_(canvas),
      step_(std::clamp((picture_frame_height - 20.0) / std::max(entries, 1), least_entry, entry_height)) {}

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
        column.value(words_of(dimension.name), dimension.text);
}

namespace {

std::vector<CamFigure> drawn_figures(const Solution& solution, DrawnFigures which) {
    std::vector<CamFigure> figures = cam_figures(solution);
    if (which == DrawnFigures::of_whole_cam)  // those of a side begin with its name
        std::erase_if(figures, [](const CamFigure& one) { return one.name.find(": ") != std::string::npos; });
    return figures;
}

}  // namespace

void add_figures(LegendColumn& column, const Solution& solution, DrawnFigures which) {
    column.heading("figures");
    for (const CamFigure& figure : drawn_figures(solution, which)) {
        column.words(figure.name);
        column.value("", figure.degrees.empty() ? figure.value
                                                : fmt::format("{} at {}°", figure.value, figure.degrees));
    }
}

int figure_entries(const Solution& solution, DrawnFigures which) {
    return static_cast<int>(cam_dimensions(solution).size() + 2 * drawn_figures(solution, which).size());
}

void add_opening(LegendColumn& column, const Solution& solution) {
    const std::string why = open_because(solution);
    column.words("OPEN: the cam is not closed", "warning");
    column.words(why.substr(0, why.find(": ")));
}

SvgCanvas new_picture(std::string_view style, std::string_view title, double height) {
    SvgCanvas canvas(picture_width, height, std::string(style) + column_style, title);
    canvas.rectangle(0, 0, picture_width, height, "page");
    canvas.text(picture_left, 38, title, "title");
    return canvas;
}

}  // namespace camopt
