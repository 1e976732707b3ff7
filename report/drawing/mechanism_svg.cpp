// SPDX-License-Identifier: MIT
#include "report/drawing/cam_svg.hpp"
#include "report/drawing/picture_page.hpp"
#include "report/view/cam_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr int profile_points = 1440;
constexpr int motion_samples = 720;
constexpr double same_end = 1e-9;  // of the largest radius
constexpr double arrow_part = 0.45;
constexpr double label_font = 12;

const char* const mechanism_style =
    ".cam{fill:#d9e8f2;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round;fill-rule:nonzero}.sector{fill:"
    "none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}.open{stroke:#d00000;stroke-width:1.4;stroke-"
    "dasharray:6 "
    "4}.pitch{fill:none;stroke:#555;stroke-width:1.2;stroke-dasharray:7 "
    "4}.link{fill:none;stroke:#444;stroke-width:5;stroke-linecap:round;stroke-linejoin:round}.ghost{fill:"
    "none;stroke:#9a9a9a;stroke-width:1.4;stroke-linejoin:round}.roller{fill:#fff;fill-opacity:.75;stroke:#"
    "b35900;stroke-width:2}.joint{fill:#fff;stroke:#444;stroke-width:2}.pivot{fill:#222;stroke:#fff;stroke-"
    "width:1.5}.guide{stroke:#009e73;stroke-width:9;stroke-opacity:.35;stroke-linecap:round}.slider{fill:#"
    "009e73;stroke:#009e73;stroke-width:9;stroke-linecap:round}.center{stroke:#444;stroke-width:1}.arrow{"
    "fill:none;stroke:#222;stroke-width:1.6}.arrow-head{fill:#222}.label{paint-order:stroke;stroke:#fff;"
    "stroke-width:4px}";

const char* const guide_style =
    ".slot{fill:#d9e8f2;stroke:none}.wall-left{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:"
    "round}.wall-right{fill:none;stroke:#d55e00;stroke-width:2.2;stroke-linejoin:round}.pitch{fill:none;"
    "stroke:#555;stroke-width:1.2;stroke-dasharray:7 "
    "4}.roller{fill:#fff;fill-opacity:.75;stroke:#b35900;stroke-width:1.8}.pivot{fill:#222;stroke:#222;"
    "stroke-width:6}.label{paint-order:stroke;stroke:#fff;stroke-width:4px}";

std::vector<Vector2d> line_of(const std::vector<DeliveredRow>& rows, Eigen::Vector3d MechanismPoint::*place) {
    std::vector<Vector2d> line;
    line.reserve(rows.size());
    for (const DeliveredRow& row : rows) line.emplace_back((row.cam.front().*place).head<2>());
    return line;
}

class MechanismPage {
 public:
    explicit MechanismPage(const View& view)
        : view_(view), solution_(view.solution), points_(*view.delivered.cam), mechanism_(points_.cam()) {
        const Motion& motion = points_.motion();
        std::tie(least_, most_) = ends();
        start_ = output_at(std::clamp(0.0, motion.begin(), motion.end()));
        now_ = shapes_at(start_);
        if (now_.empty()) throw InputError("this mechanism cannot be drawn");
        center_ = now_.front().points.front();
        for (const double x : even_places(motion.breakpoints(), profile_points)) {
            const MechanismPoint& point = points_.at(x);
            cam_.emplace_back(center_ + point.contact.head<2>());
            pitch_.emplace_back(center_ + point.pitch.head<2>());
            box_.add(pitch_.back());
            box_.add(cam_.back());
            radius_ = std::max(radius_, point.contact.norm());
        }
        closed_ = is_whole_turn((motion.end() - motion.begin()) * points_.scale().unit_angle) &&
                  (cam_.front() - cam_.back()).norm() < same_end * radius_;
        for (const double s : {least_, most_, start_})
            for (const MechanismShape& shape : shapes_at(s))
                for (const Vector2d& point : shape.points) box_.add(point, shape.radius);
    }

    [[nodiscard]] std::string drawn() const {
        SvgCanvas canvas = new_picture(mechanism_style, view_.title("Cam and linkage"));
        const ProfileCanvas on = fitted_canvas(canvas, box_.with_room());
        const ShownUnit& length = view_.units.length;
        draw_length_frame(on, length, "x, y in " + length.name + " (fixed frame)");
        on.polyline(cam_, closed_, closed_ ? "cam" : "sector");
        on.polyline(pitch_, closed_, "pitch");
        if (!closed_) on.line(cam_.front(), cam_.back(), "open");
        draw_turning(on);
        for (const double s : {least_, most_}) draw_ghost(on, s);
        draw_guide(on);
        for (const MechanismShape& shape : now_) draw(on, shape);
        draw_labels(on);
        draw_legend(canvas, length);
        return canvas.finish();
    }

 private:
    const View& view_;
    const Solution& solution_;
    const CamPoints& points_;
    const DrivenMechanism& mechanism_;
    double least_ = 0.0, most_ = 0.0, start_ = 0.0, radius_ = 0.0;
    bool closed_ = true;
    Vector2d center_;
    std::vector<MechanismShape> now_;
    std::vector<Vector2d> cam_, pitch_;
    PictureBox box_;

    [[nodiscard]] double output_at(double x) const {
        return points_.scale().lift * points_.motion_at(x).derivative[0];
    }
    /// The outputs between which the mechanism moves.
    [[nodiscard]] std::pair<double, double> ends() const {
        const Motion& motion = points_.motion();
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (int i = 0; i <= motion_samples; ++i) {
            const double s = output_at(motion.begin() + (motion.end() - motion.begin()) * i / motion_samples);
            least = std::min(least, s);
            most = std::max(most, s);
        }
        return {least, most};
    }
    [[nodiscard]] std::vector<MechanismShape> shapes_at(double s) const {
        return mechanism_.formulas->shapes({mechanism_.dimensions, {s, 0.0, 0.0}});
    }
    void draw_turning(const ProfileCanvas& on) const {
        double least = radius_;
        for (const Vector2d& point : cam_) least = std::min(least, (point - center_).norm());
        draw_rotation(on, center_, arrow_part * least, mechanism_.formulas->rotation());
    }
    void draw_ghost(const ProfileCanvas& on, double s) const {
        for (const MechanismShape& shape : shapes_at(s)) {
            if (shape.kind == MechanismShape::Kind::link) on.polyline(shape.points, false, "ghost");
            if (shape.kind == MechanismShape::Kind::circle)
                on.circle(shape.points.front(), shape.radius, "ghost");
        }
    }
    void draw_guide(const ProfileCanvas& on) const {
        for (const MechanismShape& low : shapes_at(least_))
            for (const MechanismShape& high : shapes_at(most_))
                if (low.kind == MechanismShape::Kind::guide && high.kind == low.kind)
                    on.line(low.points.back(), high.points.back(), "guide");
    }
    static void draw(const ProfileCanvas& on, const MechanismShape& shape) {
        switch (shape.kind) {
            case MechanismShape::Kind::link:
                on.polyline(shape.points, false, "link");
                for (const Vector2d& point : shape.points) on.circle(point, on.px(4.5), "joint");
                return;
            case MechanismShape::Kind::face:
                return;  // a disk cam's, which has its own picture
            case MechanismShape::Kind::circle:
                return on.circle(shape.points.front(), shape.radius, "roller");
            case MechanismShape::Kind::pivot:
                return on.circle(shape.points.front(), on.px(6.5), "pivot");
            case MechanismShape::Kind::guide:
                return on.circle(shape.points.back(), on.px(5), "slider");
        }
    }

    void draw_labels(const ProfileCanvas& on) const {
        PlacedTexts labels(picture_left + 4, picture_top + 4, picture_left + picture_frame_width - 4,
                           picture_top + picture_frame_height - 4);
        for (const MechanismShape& shape : now_) {
            if (shape.kind == MechanismShape::Kind::pivot) {
                draw(on, shape);  // above the links that meet there
                continue;
            }
            labels.draw(on.canvas, words_of(shape.name), places_of(on, shape), "label", label_font);
        }
    }
    /// Inside a roller; beside a slider; to either side of a link, along it.
    static std::vector<TextPlace> places_of(const ProfileCanvas& on, const MechanismShape& shape) {
        std::vector<TextPlace> places;
        const auto around = [&](const Vector2d& px, double distance) {
            places.push_back({px.x() + distance, px.y() + 4, TextSide::start});
            places.push_back({px.x() - distance, px.y() + 4, TextSide::end});
            places.push_back({px.x(), px.y() + distance + 8, TextSide::middle});
            places.push_back({px.x(), px.y() - distance, TextSide::middle});
        };
        if (shape.kind == MechanismShape::Kind::circle) {
            const Vector2d px = on.place(shape.points.front());
            places.push_back({px.x(), px.y() + 4, TextSide::middle});
            around(px, on.scale * shape.radius + 5);
            return places;
        }
        if (shape.kind == MechanismShape::Kind::guide) {
            around(on.place(shape.points.back()), 13);
            return places;
        }
        for (std::size_t i = shape.points.size() - 1; i > 0; --i)
            for (const double part : {0.5, 0.35, 0.65, 0.2, 0.8})
                around(on.place(shape.points[i - 1] + part * (shape.points[i] - shape.points[i - 1])), 12);
        return places;
    }

    void draw_legend(SvgCanvas& canvas, const ShownUnit& length) const {
        const int lines = 8, words = 6;
        LegendColumn column(canvas, length, lines + words + figure_entries(solution_));
        column.sample(closed_ ? "cam" : "sector", "cam");
        column.sample("pitch", "pitch curve (roller centre)");
        column.sample("roller", "roller");
        column.sample("link", "links at θ = 0");
        column.sample("ghost", "at both ends of the motion");
        if (std::ranges::any_of(
                now_, [](const MechanismShape& s) { return s.kind == MechanismShape::Kind::guide; }))
            column.sample("guide", "path of the slider");
        add_figures(column, solution_, fmt::format("turns {}", name_of(mechanism_.formulas->rotation())));
        if (!closed_) add_opening(column, solution_);
    }
};

}  // namespace

std::string mechanism_svg(const View& view) {
    if (!view.delivered.cam)
        throw InputError("a picture of a mechanism needs one, and this solution has none");
    return MechanismPage(view).drawn();
}

std::string guide_svg(const View& view, const std::vector<DeliveredRow>& left_wall,
                      const std::vector<DeliveredRow>& right_wall) {
    const Solution& solution = view.solution;
    const std::vector<Vector2d> left = line_of(left_wall, &MechanismPoint::contact),
                                right = line_of(right_wall, &MechanismPoint::contact),
                                middle = line_of(left_wall, &MechanismPoint::pitch);
    PictureBox box;
    box.add(Vector2d::Zero());
    const double radius = (left.front() - middle.front()).norm();
    for (const std::vector<Vector2d>* line : {&left, &right, &middle})
        for (const Vector2d& point : *line) box.add(point);
    for (const Vector2d& point : {middle.front(), middle.back()}) box.add(point, radius);
    SvgCanvas canvas = new_picture(guide_style, view.title("Guide"));
    const ProfileCanvas on = fitted_canvas(canvas, box.with_room());
    const ShownUnit& length = view.units.length;
    draw_length_frame(on, length, "x, y in " + length.name + " (frame of the body)");
    std::vector<Vector2d> slot = left;
    slot.insert(slot.end(), right.rbegin(), right.rend());
    on.polyline(slot, true, "slot");
    on.polyline(left, false, "wall-left");
    on.polyline(right, false, "wall-right");
    on.polyline(middle, false, "pitch");
    PlacedTexts labels(picture_left + 4, picture_top + 4, picture_left + picture_frame_width - 4,
                       picture_top + picture_frame_height - 4);
    const auto label = [&](const Vector2d& at, double distance, const std::string& words) {
        const Vector2d px = on.place(at);
        const std::vector<TextPlace> places = {{px.x(), px.y() + distance + 11, TextSide::middle},
                                               {px.x(), px.y() - distance - 3, TextSide::middle},
                                               {px.x() + distance + 3, px.y() + 4, TextSide::start},
                                               {px.x() - distance - 3, px.y() + 4, TextSide::end},
                                               {px.x() + distance, px.y() + distance + 11, TextSide::end}};
        labels.draw(canvas, words, places, "label");
    };
    for (const auto& [point, x] :
         {std::pair{middle.front(), left_wall.front().x}, std::pair{middle.back(), left_wall.back().x}}) {
        on.circle(point, radius, "roller");
        label(point, on.scale * radius, fmt::format("θ = {}°", short_text(view.units.degrees_per_x * x, 5)));
    }
    on.circle({0.0, 0.0}, on.px(5), "pivot");
    label({0.0, 0.0}, 6, "body's pivot");
    LegendColumn column(canvas, length, 8 + figure_entries(solution));
    const CamMechanism& guide = *solution.cam->cam.formulas;
    column.sample("wall-left", guide.station_name(0));
    column.sample("wall-right", guide.station_name(1));
    column.sample("pitch", "path of the roller's centre");
    column.sample("roller", "roller at both ends");
    add_figures(column, solution);
    return canvas.finish();
}

}  // namespace camopt
