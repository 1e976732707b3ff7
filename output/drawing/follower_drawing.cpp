// SPDX-License-Identifier: MIT
#include "output/drawing/follower_drawing.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

// Of the size, below.
constexpr double stem_length = 1.2, stem_half_width = 0.07, guide_begin = 0.6, guide_end = 1.0;
constexpr double ghost_length = 0.45, plate = 0.07, face_margin = 0.12, pivot_radius = 0.06;

Vector2d turned_left(const Vector2d& direction) {
    return {-direction.y(), direction.x()};
}

}  // namespace

FollowerDrawing::FollowerDrawing(const ProfileShape& shape, double least_offset, double largest_offset)
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

/// Half the width of a flat face that is pushed straight, where it is given.
std::optional<double> FollowerDrawing::pushed_face() const {
    if (!shape_.has_pushed_face()) return std::nullopt;
    return shape_.face_half_width;
}

std::vector<Vector2d> FollowerDrawing::reach() const {
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

/// Direction of growing contact offset, which is that of x (from the pivot) in the fixed frame.
Vector2d FollowerDrawing::along_face(const FollowerPose& pose) const {
    return -turned_left(pose.lift);
}

void FollowerDrawing::draw_whole(const ProfileCanvas& canvas) const {
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

/// A stem in its guide; with a gap it ends in an edge at the foot.
void FollowerDrawing::draw_stem(const ProfileCanvas& canvas, const Vector2d& foot, double gap) const {
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

void FollowerDrawing::draw_swinging(const ProfileCanvas& canvas) const {
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

void FollowerDrawing::draw_pivot(const ProfileCanvas& canvas, const Vector2d& pivot) const {
    const double radius = pivot_radius * size_;
    canvas.polyline(std::array<Vector2d, 3>{pivot, pivot + 2.4 * radius * Vector2d(-0.6, -1.0),
                                            pivot + 2.4 * radius * Vector2d(0.6, -1.0)},
                    true, "ground");
    canvas.circle(pivot, radius, "bearing");
}

FollowerDrawing::Ghost FollowerDrawing::ghost_at(double theta) const {
    const MechanismPoint point = shape_.at(theta);
    const Vector2d pitch = in_plane(point.pitch), contact = in_plane(point.contact);
    const FollowerPose pose = follower_pose(shape_.cam, point);
    const double length = ghost_length * size_;
    if (shape_.has_face()) {
        if (pushed_face()) {
            const Vector2d direction = along_face(pose), foot = contact - point.contact_offset * direction;
            return {contact, foot + least_ * direction, foot + largest_ * direction};
        }
        const Vector2d along = length * turned_left(in_plane(point.normal));
        return {contact, contact - along, contact + along};
    }
    const bool swings = shape_.formulas().swings();
    const Vector2d away = swings ? Vector2d((pose.pivot - pitch).normalized()) : pose.lift;
    return {pitch, pitch, pitch + std::max(length, 1.2 * shape_.roller_radius()) * away};
}

std::vector<Vector2d> FollowerDrawing::ghost_reach(double theta) const {
    const Ghost ghost = ghost_at(theta);
    const Vector2d around = Vector2d::Constant(shape_.roller_radius());
    return {ghost.center - around, ghost.center + around, ghost.from, ghost.to};
}

void FollowerDrawing::draw_ghost(const ProfileCanvas& canvas, double theta) const {
    const Ghost ghost = ghost_at(theta);
    canvas.line(ghost.from, ghost.to, "ghost");
    if (shape_.has_roller()) canvas.circle(ghost.center, shape_.roller_radius(), "ghost");
}

std::string_view follower_style() {
    return ".follower{fill:#fff;fill-opacity:.75;stroke:#b35900;stroke-width:1.8;stroke-linejoin:round}"
           ".arm{stroke:#b35900;stroke-width:5;stroke-linecap:round}.guide{stroke:#444;stroke-width:4}.pivot{"
           "fill:#b35900}.ground{fill:#ddd;stroke:#444;stroke-width:1.2}.bearing{fill:#fff;stroke:#444;"
           "stroke-width:1.8}.ghost{fill:none;stroke:#e0a060;stroke-width:1.1}";
}

}  // namespace camopt
