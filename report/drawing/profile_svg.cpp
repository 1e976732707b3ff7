// SPDX-License-Identifier: MIT
#include "report/drawing/cam_svg.hpp"
#include "report/drawing/picture_page.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using units::degree;

// The follower of the cam in the cam frame: where the motion begins, whole; at other cam angles, as a ghost.

// Of the size, below.
constexpr double stem_length = 1.2, stem_half_width = 0.07, guide_begin = 0.6, guide_end = 1.0;
constexpr double ghost_length = 0.45, plate = 0.07, face_margin = 0.12, pivot_radius = 0.06;

Vector2d turned_left(const Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

/// CSS rules of the follower: guide, pivot, ghost.
constexpr const char* follower_style =
    ".follower{fill:#fff;fill-opacity:.75;stroke:#b35900;stroke-width:1.8;stroke-linejoin:round}"
    ".arm{stroke:#b35900;stroke-width:5;stroke-linecap:round}.guide{stroke:#444;stroke-width:4}.pivot{"
    "fill:#b35900}.ground{fill:#ddd;stroke:#444;stroke-width:1.2}.bearing{fill:#fff;stroke:#444;"
    "stroke-width:1.8}.ghost{fill:none;stroke:#e0a060;stroke-width:1.1}";

/// The parts of the follower as the drawing shows them, m.
class FollowerDrawing {
 public:
    /// Least and largest contact offset over the cam: a flat face reaches a little beyond, unless the shape
    /// says how wide it is.
    FollowerDrawing(const ProfileShape& shape, double least_offset, double largest_offset)
        : shape_(shape),
          start_(shape.at(shape.start)),
          pitch_(in_plane(start_.pitch)),
          contact_(in_plane(start_.contact)),
          normal_(in_plane(start_.normal)),
          pose_(follower_pose(shape.cam, start_)),
          size_(std::max(shape.base_radius(), shape.roller_radius())),
          least_(least_offset - face_margin * size_),
          largest_(largest_offset + face_margin * size_) {
        if (const std::optional<double> half = pushed_face(); half) least_ = -*half, largest_ = *half;
    }

    /// Points that the whole follower reaches, for the extent of the drawing.
    [[nodiscard]] std::vector<Vector2d> reach() const {
        if (shape_.formulas().swings()) {
            const Vector2d around = Vector2d::Constant(2.5 * pivot_radius * size_);
            return {pose_.pivot + around, pose_.pivot - around, pitch_};
        }
        std::vector<Vector2d> reach = {
            pitch_ + std::max(1.2 * shape_.roller_radius(), (stem_length + plate) * size_) * pose_.lift};
        if (shape_.has_face()) {
            const Vector2d along = along_face(pose_), foot = contact_ - start_.contact_offset * along;
            reach.emplace_back(foot + least_ * along);
            reach.emplace_back(foot + largest_ * along);
        }
        return reach;
    }
    [[nodiscard]] std::vector<Vector2d> ghost_reach(double theta) const {
        const Ghost ghost = ghost_at(theta);
        const Vector2d around = Vector2d::Constant(shape_.roller_radius());
        return {ghost.center - around, ghost.center + around, ghost.from, ghost.to};
    }
    void draw_whole(const ProfileCanvas& canvas) const {
        if (shape_.formulas().swings()) return draw_swinging(canvas);
        if (shape_.has_face()) {
            const Vector2d along = along_face(pose_), foot = contact_ - start_.contact_offset * along;
            const Vector2d up = plate * size_ * pose_.lift;
            canvas.polyline(std::array<Vector2d, 4>{foot + least_ * along, foot + largest_ * along,
                                                    foot + largest_ * along + up, foot + least_ * along + up},
                            true, "follower");
            return draw_stem(canvas, foot + up, 0.0);
        }
        draw_stem(canvas, pitch_, shape_.has_roller() ? 0.0 : 2.0 * stem_half_width);
        if (!shape_.has_roller()) return;
        canvas.circle(pitch_, shape_.roller_radius(), "follower");
        canvas.circle(pitch_, canvas.px(2.0), "pivot");
    }
    void draw_ghost(const ProfileCanvas& canvas, double theta) const {
        const Ghost ghost = ghost_at(theta);
        canvas.line(ghost.from, ghost.to, "ghost");
        if (shape_.has_roller()) canvas.circle(ghost.center, shape_.roller_radius(), "ghost");
    }

 private:
    struct Ghost {
        Vector2d center, from, to;
    };

    /// Half the width of a flat face that is pushed straight, where it is given.
    [[nodiscard]] std::optional<double> pushed_face() const {
        if (!shape_.has_pushed_face()) return std::nullopt;
        return shape_.face_half_width;
    }
    [[nodiscard]] Ghost ghost_at(double theta) const {
        const MechanismPoint point = shape_.at(theta);
        const Vector2d pitch = in_plane(point.pitch), contact = in_plane(point.contact);
        const FollowerPose pose = follower_pose(shape_.cam, point);
        const double length = ghost_length * size_;
        if (shape_.has_face()) {
            if (pushed_face()) {
                const Vector2d direction = along_face(pose),
                               foot = contact - point.contact_offset * direction;
                return {contact, foot + least_ * direction, foot + largest_ * direction};
            }
            const Vector2d along = length * turned_left(in_plane(point.normal));
            return {contact, contact - along, contact + along};
        }
        const bool swings = shape_.formulas().swings();
        const Vector2d away = swings ? Vector2d((pose.pivot - pitch).normalized()) : pose.lift;
        return {pitch, pitch, pitch + std::max(length, 1.2 * shape_.roller_radius()) * away};
    }
    /// Direction of growing contact offset, which is that of x (from the pivot) in the fixed frame.
    [[nodiscard]] Vector2d along_face(const FollowerPose& pose) const { return -turned_left(pose.lift); }
    /// A stem in its guide; with a gap it ends in an edge at the foot.
    void draw_stem(const ProfileCanvas& canvas, const Vector2d& foot, double gap) const {
        const Vector2d side = stem_half_width * size_ * turned_left(pose_.lift);
        const auto at = [&](double height) -> Vector2d { return foot + height * size_ * pose_.lift; };
        std::vector<Vector2d> stem = {at(stem_length) + side, at(gap) + side};
        if (gap > 0.0) stem.push_back(foot);
        stem.emplace_back(at(gap) - side);
        stem.emplace_back(at(stem_length) - side);
        canvas.polyline(stem, false, "follower");
        for (const double sign : {-1.5, 1.5})
            canvas.line(at(guide_begin) + sign * side, at(guide_end) + sign * side, "guide");
    }
    void draw_swinging(const ProfileCanvas& canvas) const {
        if (shape_.has_roller()) {
            canvas.line(pose_.pivot, pitch_, "arm");
            canvas.circle(pitch_, shape_.roller_radius(), "follower");
            canvas.circle(pitch_, canvas.px(2.0), "pivot");
        } else {
            const Vector2d along = (contact_ - pose_.foot).normalized(), up = plate * size_ * normal_;
            canvas.polyline(std::array<Vector2d, 5>{pose_.pivot, pose_.foot + std::max(least_, 0.0) * along,
                                                    pose_.foot + largest_ * along,
                                                    pose_.foot + largest_ * along + up, pose_.pivot + up},
                            true, "follower");
        }
        draw_pivot(canvas, pose_.pivot);
    }
    void draw_pivot(const ProfileCanvas& canvas, const Vector2d& pivot) const {
        const double radius = pivot_radius * size_;
        canvas.polyline(std::array<Vector2d, 3>{pivot, pivot + 2.4 * radius * Vector2d(-0.6, -1.0),
                                                pivot + 2.4 * radius * Vector2d(0.6, -1.0)},
                        true, "ground");
        canvas.circle(pivot, radius, "bearing");
    }

    const ProfileShape& shape_;
    MechanismPoint start_;
    Vector2d pitch_, contact_, normal_;  ///< of start_
    FollowerPose pose_;
    double size_;  ///< what the parts without a dimension are measured by
    double least_, largest_;
};

// Layout, px.
constexpr int steps = 1440;  // a quarter of a degree
constexpr double mark_step = 30 * degree, ghost_step = 60 * degree;
constexpr double mark_length = 8, mark_distance = 19, mark_room = 9;  // px
constexpr double label_width = 28, label_height = 12;                 // px
constexpr double arrow_radius = 0.42;                                 // of the base circle's
constexpr double undercut_ring = 14;                                  // px

const char* page_style =
    ".cam{fill:#d9e8f2;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round;fill-rule:nonzero}.groove{fill:#"
    "fff;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}.second{fill:#e6daf0;fill-opacity:.7;stroke:#"
    "7b3fa0;stroke-width:2.2;stroke-linejoin:round}.second-sector{fill:none;stroke:#7b3fa0;stroke-width:2.2;"
    "stroke-linejoin:round}.second-pitch{fill:none;stroke:#9a6fb5;stroke-width:1.1;stroke-dasharray:7 "
    "4}.sector{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}.pitch{fill:none;stroke:#555;"
    "stroke-width:1.2;stroke-dasharray:7 "
    "4}.circle{fill:none;stroke:#8a8a8a;stroke-width:1}.prime{fill:none;stroke:#8a8a8a;stroke-width:1;stroke-"
    "dasharray:2 "
    "3}.center{stroke:#444;stroke-width:1}.mark{stroke:#0072b2;stroke-width:1.4}.mark-label{font-size:11px;"
    "fill:#005a8c;text-anchor:middle;paint-order:stroke;stroke:#d9e8f2;stroke-width:3px}.yoke{stroke:#b35900;"
    "stroke-width:5;stroke-opacity:.45;stroke-linecap:round}.bare{stroke:#fff}.open{stroke:#d00000;stroke-"
    "width:1.4;stroke-dasharray:6 "
    "4}.arrow{fill:none;stroke:#222;stroke-width:1.6}.arrow-head{fill:#222}.ring{fill:none;stroke:#d00000;"
    "stroke-width:1.2}.undercut{fill:none;stroke:#d00000;stroke-width:3.2}";

using Pieces = std::vector<std::vector<MechanismPoint>>;

template <class Use>
void for_each_angle(const ProfileShape& shape, double step, Use use) {
    const double rounding = 1e-6 * step;
    const bool turn = shape.closed;  // the end is the beginning
    for (double k = std::ceil((shape.begin() - rounding) / step);
         k * step < shape.end() + (turn ? -rounding : rounding); ++k)
        use(std::clamp(k * step, shape.begin(), shape.end()));
}

/// The points of all pieces, of the cam and of its pitch curve.
struct Outlines {
    std::vector<Vector2d> contact, pitch;
};

Outlines outlines_of(const Pieces& pieces) {
    Outlines lines;
    for (const std::vector<MechanismPoint>& piece : pieces)
        for (const MechanismPoint& point : piece) {
            lines.contact.push_back(in_plane(point.contact));
            lines.pitch.push_back(in_plane(point.pitch));
        }
    return lines;
}

PictureBox extent_of(const ProfileShape& shape, const Pieces& pieces, const FollowerDrawing& follower) {
    PictureBox extent;
    extent.add({0.0, 0.0}, shape.prime_radius());
    std::vector<Outlines> sides = {outlines_of(pieces)};
    if (shape.other) sides.push_back(outlines_of(profile_pieces(other_side(shape), steps)));
    for (const Outlines& side : sides)
        for (const std::vector<Vector2d>* line : {&side.contact, &side.pitch})
            for (const Vector2d& point : *line) extent.add(point);
    if (const std::optional<double> rim = rim_radius(shape)) extent.add({0.0, 0.0}, *rim);
    if (shape.has_two_disks()) extent.add(in_plane(shape.other(shape.start).pitch), shape.roller_radius(1));
    for (const Vector2d& point : follower.reach()) extent.add(point);
    for_each_angle(shape, ghost_step, [&](double theta) {
        for (const Vector2d& point : follower.ghost_reach(theta)) extent.add(point);
    });
    return extent.with_room();
}

FollowerDrawing follower_drawing(const ProfileShape& shape, const Pieces& pieces) {
    double least = 0.0, largest = 0.0;
    for (const std::vector<MechanismPoint>& piece : pieces)
        for (const MechanismPoint& point : piece) {
            least = std::min(least, point.contact_offset);
            largest = std::max(largest, point.contact_offset);
        }
    return {shape, least, largest};
}

/// What lies below the first side: the disk that a groove is cut into, or the second disk.
void draw_other_side(const ProfileCanvas& drawing, const ProfileShape& shape) {
    if (!shape.other) return;
    const auto [outline, pitch] = outlines_of(profile_pieces(other_side(shape), steps));
    if (const std::optional<double> rim = rim_radius(shape)) {
        if (shape.closed) drawing.circle({0.0, 0.0}, *rim, "cam");
        drawing.polyline(outline, shape.closed, shape.closed ? "groove" : "sector");
        return;
    }
    drawing.polyline(outline, shape.closed, shape.closed ? "second" : "second-sector");
    drawing.polyline(pitch, shape.closed, "second-pitch");
}

/// The second roller where the motion begins, on the follower that carries the first.
void draw_second_roller(const ProfileCanvas& drawing, const ProfileShape& shape) {
    if (!shape.has_two_disks()) return;
    const Vector2d first = in_plane(shape.at(shape.start).pitch),
                   second = in_plane(shape.other(shape.start).pitch);
    const bool swings = shape.formulas().swings();
    drawing.line(swings ? follower_pose(shape.cam, shape.at(shape.start)).pivot : first, second, "yoke");
    drawing.circle(second, shape.roller_radius(1), "follower");
    drawing.circle(second, drawing.px(2.0), "pivot");
}

void draw_cam(const ProfileCanvas& drawing, const ProfileShape& shape, const Pieces& pieces) {
    const auto [outline, pitch] = outlines_of(pieces);
    drawing.polyline(outline, shape.closed, shape.closed ? "cam" : "sector");
    if (!shape.closed && !shape.open_because.empty())
        drawing.line(in_plane(shape.at(shape.begin()).contact), in_plane(shape.at(shape.end()).contact),
                     "open");
    drawing.circle({0.0, 0.0}, shape.base_radius(), "circle");
    if (!shape.has_roller()) return;
    drawing.circle({0.0, 0.0}, shape.prime_radius(), "prime");
    drawing.polyline(pitch, shape.closed, "pitch");
}

/// Whether there is any.
bool draw_undercut(const ProfileCanvas& drawing, const Pieces& pieces) {
    bool found = false;
    for (const std::vector<MechanismPoint>& piece : pieces) {
        std::vector<Vector2d> stretch;
        const auto finish = [&] {
            if (!stretch.empty()) {
                drawing.polyline(stretch, false, "undercut");
                drawing.circle(stretch[stretch.size() / 2], drawing.px(undercut_ring), "ring");
            }
            found = found || !stretch.empty();
            stretch.clear();
        };
        for (const MechanismPoint& point : piece) {
            if (point.regularity <= 0.0)
                stretch.push_back(in_plane(point.contact));
            else
                finish();
        }
        finish();
    }
    return found;
}

/// From 0 to 360: a dwell arc may lie before the motion.
double turned_degrees(double theta) {
    const double turns = std::floor(theta / units::turn + 1e-9);
    return theta == 0.0 ? 0.0 : std::abs(degrees_shown.of(theta - turns * units::turn));
}

/// Where marks crowd, on a sharp nose, the later labels stay away.
void draw_marks(const ProfileCanvas& drawing, const ProfileShape& shape) {
    std::vector<Vector2d> labels;
    for_each_angle(shape, mark_step, [&](double theta) {
        const MechanismPoint point = shape.at(theta);
        const Vector2d contact = in_plane(point.contact), normal = in_plane(point.normal);
        drawing.line(contact, contact - drawing.px(mark_length) * normal, "mark");
        // Beside a mark that lies flat the label needs room for its width, else the mark looks like a minus.
        const double distance = mark_distance + mark_room * std::abs(normal.x());
        const Vector2d place = contact - drawing.px(distance) * normal;
        const auto covers = [&](const Vector2d& other) {
            return std::abs(other.x() - place.x()) < drawing.px(label_width) &&
                   std::abs(other.y() - place.y()) < drawing.px(label_height);
        };
        if (std::ranges::any_of(labels, covers)) return;
        labels.push_back(place);
        drawing.text(place, fmt::format("{:.0f}°", turned_degrees(theta)),
                     shape.closed ? "mark-label" : "mark-label bare");
    });
}

}  // namespace

std::string profile_svg(const ProfileShape& shape, std::string_view title) {
    const Pieces pieces = profile_pieces(shape, steps);
    const FollowerDrawing follower = follower_drawing(shape, pieces);
    SvgCanvas canvas = new_picture(page_style + std::string(follower_style), title);
    const ProfileCanvas drawing = fitted_canvas(canvas, extent_of(shape, pieces, follower));
    draw_length_frame(drawing, shape.length, "x, y in " + shape.length.name + " (cam frame)");
    draw_other_side(drawing, shape);
    for_each_angle(shape, ghost_step, [&](double theta) {
        if (std::abs(theta - shape.start) > 1e-9) follower.draw_ghost(drawing, theta);
    });
    draw_cam(drawing, shape, pieces);
    bool undercut = draw_undercut(drawing, pieces);
    if (shape.other) undercut = draw_undercut(drawing, profile_pieces(other_side(shape), steps)) || undercut;
    draw_marks(drawing, shape);
    draw_rotation(drawing, {0.0, 0.0}, arrow_radius * shape.base_radius(), shape.formulas().rotation());
    draw_second_roller(drawing, shape);
    follower.draw_whole(drawing);
    draw_profile_legend(canvas, shape, undercut);
    return canvas.finish();
}

}  // namespace camopt
