// SPDX-License-Identifier: MIT
#include "report/drawing/cam_svg.hpp"

#include "report/drawing/picture_page.hpp"
#include "report/drawing/plane_cam.hpp"
#include "report/view/cam_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Kind = MechanismShape::Kind;

constexpr int steps = 1440;  // a quarter of a degree
constexpr double label_font = 12, mark_font = 11;
constexpr double least_for_angles = 60;  // px: of a base circle that has room for them

// What lies lower comes first.
constexpr std::array<PictureStyle, 29> styles = {
    {{"rim", "fill:#d9e8f2;stroke:#0072b2;stroke-width:2.2"},
     {"slot", "fill:#d9e8f2;stroke:none"},
     {"groove", "fill:#fff;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round"},
     {"second", "fill:#e6daf0;fill-opacity:.7;stroke:#7b3fa0;stroke-width:2.2;stroke-linejoin:round"},
     {"second-pitch", "fill:none;stroke:#9a6fb5;stroke-width:1.1;stroke-dasharray:7 4"},
     {"ghost", "fill:none;stroke:#e0a060;stroke-width:1.1;stroke-linejoin:round"},
     {"plate", "fill:#fff;fill-opacity:.75;stroke:#b35900;stroke-width:1.8;stroke-linejoin:round"},
     {"face", "fill:none;stroke:#b35900;stroke-width:1.8"},
     {"cam", "fill:#d9e8f2;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round"},
     {"wall-left", "fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round"},
     {"wall-right", "fill:none;stroke:#d55e00;stroke-width:2.2;stroke-linejoin:round"},
     {"open", "stroke:#d00000;stroke-width:1.4;stroke-dasharray:6 4"},
     {"circle", "fill:none;stroke:#8a8a8a;stroke-width:1"},
     {"prime", "fill:none;stroke:#8a8a8a;stroke-width:1;stroke-dasharray:2 3"},
     {"pitch", "fill:none;stroke:#555;stroke-width:1.2;stroke-dasharray:7 4"},
     {"undercut", "fill:none;stroke:#d00000;stroke-width:3.2"},
     {"ring", "fill:none;stroke:#d00000;stroke-width:1.2"},
     {"mark", "stroke:#0072b2;stroke-width:1.4"},
     {"center", "stroke:#444;stroke-width:1"},
     {"arrow", "fill:none;stroke:#222;stroke-width:1.6"},
     {"arrow-head", "fill:#222"},
     {"guide", "stroke:#009e73;stroke-width:9;stroke-opacity:.35;stroke-linecap:round"},
     {"link", "fill:none;stroke:#444;stroke-width:5;stroke-linecap:round;stroke-linejoin:round"},
     {"roller", "fill:#fff;fill-opacity:.75;stroke:#b35900;stroke-width:2"},
     {"joint", "fill:#fff;stroke:#444;stroke-width:1.6"},
     {"dot", "fill:#b35900"},
     {"ground", "fill:#ddd;stroke:#444;stroke-width:1.2"},
     {"pivot", "fill:#fff;stroke:#444;stroke-width:1.8"},
     {"slider", "fill:#009e73"}}};
constexpr const char* label_style =
    ".label{paint-order:stroke;stroke:#fff;stroke-width:4px}.mark-label{font-size:11px;fill:#005a8c;paint-"
    "order:stroke;stroke:#d9e8f2;stroke-width:3px}.bare{stroke:#fff}";
constexpr std::array<std::string_view, 13> crossed = {
    "cam",       "circle",     "prime", "pitch",  "second", "second-pitch", "groove",
    "wall-left", "wall-right", "arrow", "center", "link",   "ghost"};

/// From 0 to 360: a dwell arc may lie before the motion.
double turned_degrees(double theta) {
    const double turns = std::floor(theta / units::turn + 1e-9);
    return theta == 0.0 ? 0.0 : std::abs(degrees_shown.of(theta - turns * units::turn));
}

class CamPicture {
 public:
    CamPicture(const View& view, const ProfileShape& shape) : view_(view), shape_(shape) {
        if (shape.parts(shape.start).empty()) throw InputError("this mechanism cannot be drawn");
        drawing_ = cam_outlines(shape, sampled_curve(steps));
        add_mechanism(drawing_, shape);
        DrawingBox box = drawing_.box();
        box.add(shape.parts(shape.start).front().points.front());
        place_ = fitted_place(box);
        add_marks(drawing_, shape, place_.px(1));
    }

    [[nodiscard]] std::string drawn() const {
        SvgCanvas canvas = new_picture(css_of(styles) + label_style, view_.title(shape_.picture.untitled));
        draw_length_frame(canvas, place_, shape_.length,
                          fmt::format("x, y in {} ({})", shape_.length.name, shape_.picture.frame));
        draw(canvas, drawing_, place_, styles);
        draw_labels(canvas);
        draw_legend(canvas);
        return canvas.finish();
    }

 private:
    const View& view_;
    const ProfileShape& shape_;
    Drawing drawing_;
    PicturePlace place_;

    void draw_labels(SvgCanvas& canvas) const {
        PlacedTexts labels = labels_of(drawing_, place_, crossed);
        if (shape_.picture.outline == CamOutline::slot) return label_guide(canvas, labels);
        const std::vector<MechanismShape> parts = placed_parts(shape_, shape_.start, shape_.start);
        for (const MechanismShape& part : parts)
            if (part.kind == Kind::circle) {
                const Vector2d px = place_(part.points.front());
                labels.keep_free(px.x(), px.y(), 0.75 * place_.scale.x() * part.radius);
            }
        if (place_.scale.x() * shape_.base_radius() > least_for_angles)
            for (const AngleMark& mark : angle_marks(shape_)) draw_angle(canvas, labels, mark);
        if (shape_.direct) return;
        for (const MechanismShape& part : parts)
            if (part.kind != Kind::pivot)
                labels.draw(canvas, words_of(part.name), places_of(part), "label", label_font);
    }
    void label_guide(SvgCanvas& canvas, PlacedTexts& labels) const {
        label(canvas, labels, {0.0, 0.0}, 14, "body's pivot");
        for (const double theta : {shape_.begin(), shape_.end()})
            label(canvas, labels, in_plane(shape_.at(theta).pitch),
                  place_.scale.x() * shape_.roller_radius() + 3,
                  fmt::format("θ = {}°", short_text(degrees_shown.of(theta), 5)));
    }
    /// Inside the cam, or beside a mark outside of it.
    void draw_angle(SvgCanvas& canvas, PlacedTexts& labels, const AngleMark& mark) const {
        constexpr double distance = 19, room = 9;  // px: beside a flat mark a label needs its width
        const Vector2d px = place_(mark.at), inwards(mark.inwards.x(), -mark.inwards.y());
        std::vector<TextPlace> places;
        for (const double further : {0.0, 6.0, -2.0 * distance - room}) {
            const double side = distance + room * std::abs(inwards.x()) + further;
            places.push_back(
                {px.x() + side * inwards.x(), px.y() + side * inwards.y() + 4, TextSide::middle});
        }
        const double angle = shape_.is_plate() ? degrees_shown.of(mark.theta) : turned_degrees(mark.theta);
        labels.draw(canvas, fmt::format("{:.0f}°", angle), places,
                    shape_.closed ? "mark-label" : "mark-label bare", mark_font);
    }
    static void add_places(std::vector<TextPlace>& places, const Vector2d& px, double distance) {
        places.push_back({px.x() + distance, px.y() + 4, TextSide::start});
        places.push_back({px.x() - distance, px.y() + 4, TextSide::end});
        places.push_back({px.x(), px.y() + distance + 8, TextSide::middle});
        places.push_back({px.x(), px.y() - distance, TextSide::middle});
    }
    void label(SvgCanvas& canvas, PlacedTexts& labels, const Vector2d& at, double distance,
               std::string_view words) const {
        std::vector<TextPlace> places;
        for (const double more : {0.0, 8.0, 16.0}) add_places(places, place_(at), distance + more);
        labels.draw(canvas, words, places, "label", label_font);
    }
    /// Inside a roller; beside a slider; to either side of a link, along it.
    [[nodiscard]] std::vector<TextPlace> places_of(const MechanismShape& part) const {
        std::vector<TextPlace> places;
        if (part.kind == Kind::circle) {
            const Vector2d px = place_(part.points.front());
            places.push_back({px.x(), px.y() + 4, TextSide::middle});
            add_places(places, px, place_.scale.x() * part.radius + 5);
        } else if (part.kind == Kind::guide) {
            add_places(places, place_(part.points.back()), 13);
        } else {
            for (std::size_t i = part.points.size() - 1; i > 0; --i)
                for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8})
                    add_places(places,
                               place_(part.points[i - 1] + share * (part.points[i] - part.points[i - 1])),
                               12);
        }
        return places;
    }

    /// What a style stands for; empty: nothing is said of it.
    [[nodiscard]] std::string words_of_style(std::string_view style) const {
        const std::string start = short_text(degrees_shown.of(shape_.start));
        if (style == "link") return fmt::format("{} at θ = {}°", shape_.picture.links, start);
        if (style == "face") return "flat face";
        if (style == "roller") return shape_.picture.roller;
        if (style == "guide") return shape_.picture.guide;
        if (style == "ghost") return shape_.picture.ghost;
        if (style == "mark") return "contact every 30°";
        return style == "undercut" ? "undercut" : outline_words(shape_, style);
    }
    void draw_legend(SvgCanvas& canvas) const {
        const Solution& solution = view_.solution;
        const std::optional<DirectCamDrawing>& direct = shape_.direct;
        LegendColumn column(canvas, direct ? 26 : 16 + figure_entries(solution));
        for (const char* const style :
             {"cam", "second", "groove", "wall-left", "wall-right", "pitch", "circle", "prime", "link",
              "face", "roller", "guide", "ghost", "mark", "open", "undercut"})
            if (drawing_.has(style)) column.sample(style, words_of_style(style));
        column.heading(direct ? words_of(direct->follower) : "dimensions");
        if (direct && !direct->form.empty()) column.words(fmt::format("form: {}", direct->form));
        add_dimensions(column, solution);
        if (shape_.has_pushed_face() && shape_.face_half_width)
            column.value("face half width", shape_.length.text(*shape_.face_half_width));
        else if (shape_.has_pushed_face())
            column.words("face: no width given, drawn as needed");
        const bool turns = shape_.picture.outline == CamOutline::round;
        if (turns) column.words(fmt::format("turns {}", name_of(shape_.formulas().rotation())));
        if (!direct) add_figures(column, solution);
        if (!shape_.open_because.empty())
            add_opening(column, solution);
        else if (!shape_.closed && turns)
            column.words(fmt::format("open: θ from {}° to {}°", short_text(degrees_shown.of(shape_.begin())),
                                     short_text(degrees_shown.of(shape_.end()))));
        if (!drawing_.has("undercut")) return;
        column.words("UNDERCUT where it is red:", "warning");
        column.words("the follower cannot move as", "warning");
        column.words("designed there.", "warning");
    }
};

}  // namespace

std::string cam_svg(const View& view) {
    const std::optional<ProfileShape> shape = plane_shape(view);
    if (!shape) throw InputError("a picture of a plane cam needs one, and this solution has none");
    return CamPicture(view, *shape).drawn();
}

}  // namespace camopt
