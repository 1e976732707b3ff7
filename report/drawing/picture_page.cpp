// SPDX-License-Identifier: MIT
#include "report/drawing/picture_page.hpp"

#include "report/view/cam_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double picture_margin = 0.05;                  // of the picture's size, on each side
constexpr double entry_height = 21, least_entry = 15.5;  // px
constexpr double arrow_begin = 35 * units::degree, arrow_end = 145 * units::degree, arrow_head = 9;
constexpr double heading_room = 8, sample_length = 30, sample_words = 40, number_right = 215;

/// CSS rules of the column.
constexpr const char* column_style =
    ".heading{font-size:13px;font-weight:600}.number{text-anchor:end}.warning{fill:#d00000;font-weight:600}";

void add_lines(LegendColumn& column, const ProfileShape& shape, bool undercut) {
    const CamMechanism& cam = shape.formulas();
    const bool two_disks = shape.has_two_disks();
    column.sample(shape.closed ? "cam" : "sector", two_disks ? cam.station_name(0) : "cam");
    if (two_disks) column.sample(shape.closed ? "second" : "second-sector", cam.station_name(1));
    if (shape.is_grooved()) column.sample(shape.closed ? "groove" : "sector", "groove: inner, outer flank");
    if (shape.has_roller()) column.sample("pitch", "pitch curve (roller centre)");
    column.sample("circle", "base circle");
    if (shape.has_roller()) column.sample("prime", "prime circle");
    column.sample("follower", fmt::format("follower at θ = {}°", short_text(degrees_shown.of(shape.start))));
    column.sample("ghost", "follower every 60°");
    column.sample("mark", "contact every 30°");
    if (!shape.closed && !shape.open_because.empty()) column.sample("open", "open: not given");
    if (undercut) column.sample("undercut", "undercut");
}

void add_named_dimensions(LegendColumn& column, const ProfileShape& shape, bool of_form) {
    for (const NamedDimension& dimension : shape.formulas().named_dimensions(shape.cam.dimensions)) {
        if (dimension.of_form != of_form) continue;
        if (dimension.is_angle)
            column.value(words_of(dimension.name),
                         std::string_view(short_text(degrees_shown.of(dimension.value)) + " deg"));
        else
            column.value(words_of(dimension.name), dimension.value);
    }
}

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
    const double one = drawing.scale * length.size;
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

void LegendColumn::value(std::string_view name, std::string_view shown) {
    canvas_.text(picture_legend_left, y_, name, "entry");
    canvas_.text(picture_legend_left + number_right, y_, shown, "entry number");
    y_ += step_;
}

void LegendColumn::words(std::string_view text, const char* css_class) {
    canvas_.text(picture_legend_left, y_, text, css_class);
    y_ += step_;
}

void add_figures(LegendColumn& column, const Solution& solution, std::string_view between) {
    column.heading("dimensions");
    for (const DimensionValue& dimension : cam_dimensions(solution))
        column.value(words_of(dimension.name), std::string_view(dimension.text));
    if (!between.empty()) column.words(between);
    column.heading("figures");
    for (const CamFigure& figure : cam_figures(solution)) {
        column.words(figure.name);
        column.value("", std::string_view(figure.degrees.empty()
                                              ? figure.value
                                              : fmt::format("{} at {}°", figure.value, figure.degrees)));
    }
}

int figure_entries(const Solution& solution) {
    return static_cast<int>(cam_dimensions(solution).size() + 2 * cam_figures(solution).size());
}

void add_opening(LegendColumn& column, const Solution& solution) {
    const std::string why = open_because(solution);
    column.words("OPEN: the cam is not closed", "warning");
    column.words(why.substr(0, why.find(": ")));
}

SvgCanvas new_picture(std::string_view style, std::string_view title) {
    SvgCanvas canvas(picture_width, picture_height, std::string(style) + column_style, title);
    canvas.rectangle(0, 0, picture_width, picture_height, "page");
    canvas.text(picture_left, 38, title, "title");
    return canvas;
}

void draw_rotation(const ProfileCanvas& drawing, const Vector2d& center, double radius, Rotation rotation) {
    const double arm = drawing.px(9.0), sense = sense_of(rotation);
    for (const Vector2d& reach : {Vector2d(arm, 0.0), Vector2d(0.0, arm)})
        drawing.line(center - reach, center + reach, "center");
    std::vector<Vector2d> arc;
    for (int i = 0; i <= 40; ++i) {
        const double angle = arrow_begin + (arrow_end - arrow_begin) * i / 40;
        arc.emplace_back(center + radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
    if (sense < 0.0) std::ranges::reverse(arc);
    drawing.polyline(arc, false, "arrow");
    const Vector2d tip = arc.back(), out = (tip - center).normalized();
    const Vector2d head = sense * drawing.px(arrow_head) * Vector2d(-out.y(), out.x()),
                   side = 0.45 * drawing.px(arrow_head) * out;
    drawing.polyline(std::array<Vector2d, 3>{tip + head, tip + side, tip - side}, true, "arrow-head");
}

void ProfileCanvas::line(const Vector2d& from, const Vector2d& to, std::string_view css_class) const {
    const Vector2d a = place(from), b = place(to);
    canvas.line(a.x(), a.y(), b.x(), b.y(), css_class);
}

void ProfileCanvas::circle(const Vector2d& center, double radius, std::string_view css_class) const {
    const Vector2d middle = place(center);
    canvas.circle(middle.x(), middle.y(), scale * radius, css_class);
}

void ProfileCanvas::polyline(std::span<const Vector2d> points, bool closed,
                             std::string_view css_class) const {
    std::string data;
    for (const Vector2d& point : points) {
        const Vector2d at = place(point);
        data += (data.empty() ? "M" : "L") + svg_number(at.x()) + " " + svg_number(at.y());
    }
    canvas.path(closed ? data + "Z" : data, css_class);
}

void ProfileCanvas::text(const Vector2d& middle, std::string_view words, std::string_view css_class) const {
    const Vector2d at = place(middle);
    canvas.text(at.x(), at.y() + 4.0, words, css_class);
}

void draw_profile_legend(SvgCanvas& canvas, const ProfileShape& shape, bool undercut) {
    LegendColumn column(canvas, shape.length);
    add_lines(column, shape, undercut);
    const CamMechanism& cam = shape.formulas();
    column.heading(words_of(cam.follower_name()));
    if (!cam.form_name().empty()) column.words(fmt::format("form: {}", cam.form_name()));
    add_named_dimensions(column, shape, false);
    if (shape.has_roller()) column.value("prime radius", shape.prime_radius());
    add_named_dimensions(column, shape, true);
    if (shape.has_pushed_face()) {
        if (shape.face_half_width)
            column.value("face half width", *shape.face_half_width);
        else
            column.words("face: no width given, drawn as needed");
    }
    column.words(fmt::format("turns {}", name_of(cam.rotation())));
    if (!shape.closed && shape.open_because.empty())
        column.words(fmt::format("open: θ from {}° to {}°", short_text(degrees_shown.of(shape.begin())),
                                 short_text(degrees_shown.of(shape.end()))));
    if (!shape.closed && !shape.open_because.empty()) {
        column.words(fmt::format("OPEN: θ = {}° … {}°", short_text(degrees_shown.of(shape.begin())),
                                 short_text(degrees_shown.of(shape.end()))),
                     "warning");
        const std::string& why = shape.open_because;
        const std::size_t colon = why.find(": ");
        column.words(why.substr(0, colon));
        if (colon != std::string::npos) column.words("(" + why.substr(colon + 2) + ")");
    }
    if (!undercut) return;
    column.words("UNDERCUT where it is red:", "warning");
    column.words("the follower cannot move as", "warning");
    column.words("designed there.", "warning");
}

}  // namespace camopt
