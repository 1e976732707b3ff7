// SPDX-License-Identifier: MIT
#include "output/drawing/mechanism_svg.hpp"

#include "core/errors.hpp"
#include "output/drawing/profile_canvas.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr int profile_points = 1440;
constexpr int motion_samples = 720;
constexpr double page = 900.0, margin = 46.0, head = 56.0;

const char* const style =
    "text{font-size:13px}.cam{fill:#d9e8f2;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}"
    ".pitch{fill:none;stroke:#0072b2;stroke-width:1;stroke-dasharray:6 4}"
    ".link{fill:none;stroke:#444;stroke-width:5;stroke-linecap:round;stroke-linejoin:round}"
    ".ghost{fill:none;stroke:#9a9a9a;stroke-width:1.4;stroke-linejoin:round}"
    ".roller{fill:#fff;fill-opacity:.75;stroke:#d55e00;stroke-width:2.2}"
    ".joint{fill:#fff;stroke:#444;stroke-width:2}.pivot{fill:#222;stroke:#fff;stroke-width:1.5}"
    ".guide{stroke:#009e73;stroke-width:9;stroke-opacity:.35;stroke-linecap:round}"
    ".slider{fill:#009e73}"
    ".label{text-anchor:middle;paint-order:stroke;stroke:#fff;stroke-width:4px}"
    ".beside{paint-order:stroke;stroke:#fff;stroke-width:4px}";

/// The outputs between which the mechanism moves.
std::pair<double, double> ends_of(const MechanismDrawing& drawing) {
    double least = 1e300, most = -1e300;
    for (int i = 0; i <= motion_samples; ++i) {
        const Motion& motion = drawing.motion;
        const double x = motion.begin() + (motion.end() - motion.begin()) * i / motion_samples;
        const double s = drawing.scale.lift * motion.at(x, i == 0 ? Side::right : Side::left).derivative[0];
        least = std::min(least, s);
        most = std::max(most, s);
    }
    return {least, most};
}

class Page {
 public:
    explicit Page(const MechanismDrawing& drawing) : drawing_(drawing) {
        std::tie(least_, most_) = ends_of(drawing);
        const double start = drawing.scale.lift * drawing.motion.at(drawing.motion.begin()).derivative[0];
        now_ = shapes_at(start);
        if (now_.empty()) throw InputError("this mechanism cannot be drawn");
        center_ = now_.front().points.front();
        for (const MechanismPoint& point :
             mechanism_profile(drawing.mechanism, drawing.motion, drawing.scale, profile_points).points) {
            cam_.push_back(center_ + point.contact.head<2>());
            pitch_.push_back(center_ + point.pitch.head<2>());
        }
        for (const Vector2d& point : pitch_) see(point);
        for (const double s : {least_, most_, start})
            for (const MechanismShape& shape : shapes_at(s))
                for (const Vector2d& point : shape.points) {
                    see(point - Vector2d::Constant(shape.radius));
                    see(point + Vector2d::Constant(shape.radius));
                }
    }

    [[nodiscard]] std::string drawn(std::string_view title) const {
        const Vector2d size = high_ - low_;
        const double scale = (page - 2.0 * margin) / std::max(size.x(), size.y());
        const double width = scale * size.x() + 2.0 * margin;
        const double height = scale * size.y() + 2.0 * margin + head;
        SvgCanvas canvas(std::max(width, 480.0), height, style, title);
        canvas.rectangle(0, 0, std::max(width, 480.0), height, "page");
        canvas.text(margin, 34, title, "title");
        const ProfileCanvas on{
            canvas, {margin - scale * low_.x(), height - margin + scale * low_.y()}, scale};
        on.polyline(cam_, true, "cam");
        on.polyline(pitch_, true, "pitch");
        for (const double s : {least_, most_}) draw_ghost(on, s);
        draw_guide(on);
        for (const MechanismShape& shape : now_) draw(on, shape);
        draw_labels(on);
        return canvas.finish();
    }

 private:
    const MechanismDrawing& drawing_;
    double least_ = 0.0, most_ = 0.0;
    Vector2d center_;
    std::vector<MechanismShape> now_;
    std::vector<Vector2d> cam_, pitch_;
    Vector2d low_ = Vector2d::Constant(1e300), high_ = Vector2d::Constant(-1e300);

    void see(const Vector2d& point) {
        low_ = low_.cwiseMin(point);
        high_ = high_.cwiseMax(point);
    }
    [[nodiscard]] std::vector<MechanismShape> shapes_at(double s) const {
        return drawing_.mechanism.formulas->shapes({drawing_.mechanism.dimensions, {s, 0.0, 0.0}});
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
            case MechanismShape::Kind::circle:
                return on.circle(shape.points.front(), shape.radius, "roller");
            case MechanismShape::Kind::pivot:
                return on.circle(shape.points.front(), on.px(6.5), "pivot");
            case MechanismShape::Kind::guide:
                return on.circle(shape.points.back(), on.px(9), "slider");
            case MechanismShape::Kind::face:
                return;  // a disk cam's, which has a drawing of its own
        }
    }
    void draw_labels(const ProfileCanvas& on) const {
        for (const MechanismShape& shape : now_) {
            if (shape.kind == MechanismShape::Kind::pivot) {
                draw(on, shape);  // above the links that meet there
                continue;
            }
            const std::string words = words_of(shape.name);
            if (shape.kind == MechanismShape::Kind::guide)
                on.text(shape.points.back() + Vector2d(on.px(16), 0.0), words, "beside");
            if (shape.kind == MechanismShape::Kind::circle) on.text(shape.points.front(), words, "label");
            if (shape.kind == MechanismShape::Kind::link) {
                const bool bent = shape.points.size() > 2;  // its arms leave no room between them
                const Vector2d &from = shape.points[shape.points.size() - 2], &to = shape.points.back();
                const Vector2d beside = bent ? Vector2d(0.0, -on.px(20)) : Vector2d(on.px(10), on.px(8));
                on.text(from + (bent ? 0.3 : 0.5) * (to - from) + beside, words, "beside");
            }
        }
    }
};

}  // namespace

std::string mechanism_svg(const MechanismDrawing& drawing, std::string_view title) {
    return Page(drawing).drawn(title);
}

}  // namespace camopt
