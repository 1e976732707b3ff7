// SPDX-License-Identifier: MIT
// The cam and its mechanism at every cam angle, from what the leaf of its kind says of itself: points, how
// far the cam frame has turned, parts.
#include "core/word_of.hpp"
#include "report/drawing/plane_cam.hpp"
#include "report/page/page_parts.hpp"
#include "report/view/cam_words.hpp"

#include <Eigen/Geometry>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double still = 1e-9;  // m: a part that moves less does not move
constexpr int outline_points = 720;

const char* name_of_kind(MechanismShape::Kind kind) {
    return word_of<MechanismShape::Kind::face>(kind, {"link", "circle", "pivot", "guide", "face"});
}

/// By row where they move.
Json parts_of(const ProfileShape& shape, const std::vector<double>& angles) {
    std::vector<std::vector<MechanismShape>> course;
    const std::pair<double, double> reach = reach_of_face(shape);
    course.reserve(angles.size());
    for (const double theta : angles) course.push_back(drawn_parts(shape, theta, reach));
    Json parts = Json::array();
    for (std::size_t k = 1; k < course.front().size(); ++k) {  // the first is the cam's centre
        std::vector<std::vector<Vector2d>> places;
        places.reserve(course.size());
        bool moves = false;
        for (const std::vector<MechanismShape>& shapes : course) {
            places.push_back(k < shapes.size() ? shapes[k].points : places.back());
            for (std::size_t p = 0; p < places.back().size(); ++p)
                moves = moves || (places.back()[p] - places.front()[p]).norm() > still;
        }
        if (!moves) places.resize(1);
        Json points = Json::array();
        for (const std::vector<Vector2d>& place : places)
            for (const Vector2d& point : place) append(points, shape.length, point);
        const MechanismShape& first = course.front()[k];
        parts.push_back({{"kind", name_of_kind(first.kind)},
                         {"name", words_of(first.name)},
                         {"radius", rounded_json(shape.length.of(first.radius))},
                         {"count", places.front().size()},
                         {"points", std::move(points)}});
    }
    return parts;
}

/// Paths and circles in the cam frame, each with its style and what it is.
Json outlines_of(const ProfileShape& shape) {
    Json all = Json::array();
    for (const DrawnElement& element : cam_outlines(shape, sampled_curve(outline_points)).elements) {
        Json one = {{"style", style_of(element)}, {"name", outline_words(shape, style_of(element))}};
        if (const auto* circle = std::get_if<DrawnCircle>(&element))
            one["radius"] = rounded_json(shape.length.of(circle->radius));
        if (const auto* path = std::get_if<DrawnPath>(&element)) {
            one["closed"] = path->closed;
            one["points"] = Json::array();
            for (const ArcVertex& vertex : path->vertices)
                append(one["points"], shape.length, vertex.position);
        }
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace

void append(Json& list, const ShownUnit& unit, const Eigen::Ref<const Eigen::VectorXd>& point) {
    constexpr double drawn_steps = 1e4;  // of a shown unit: a pixel is larger
    for (const double coordinate : point) {
        const double shown = unit.of(coordinate);
        list.push_back(std::isfinite(shown) ? Json(std::round(shown * drawn_steps) / drawn_steps)
                                            : Json(nullptr));
    }
}

Json plane_drawing(const View& view) {
    std::optional<ProfileShape> shape = plane_shape(view);
    if (!shape || shape->parts(shape->start).empty()) return nullptr;
    const DrivenMechanism& cam = shape->cam;
    const double unit_angle = view.delivered.scale.unit_angle;
    // A disk along its own motion, without the dwells of a DRD cam, whose ends do not meet; a plate with
    // them.
    const std::vector<double> breakpoints = view.delivered.whole->breakpoints();
    if (!cam.formulas->plane()->is_plate() && breakpoints.size() != shape->knots.size()) {
        shape->closed = false;
        shape->knots.clear();
        for (const double x : breakpoints) shape->knots.push_back(unit_angle * x);
    }
    const Vector2d center = shape->parts(shape->start).front().points.front();
    std::vector<double> angles;
    Json turned = Json::array(), shifted = Json::array(), contact = Json::array(), middle = Json::array();
    for (const DeliveredRow& row : view.delivered.rows) {
        angles.push_back(unit_angle * row.x);
        const CamPose pose = cam.formulas->plane()->pose(shape->state(angles.back()));
        turned.push_back(rounded_json(view.units.angle.of(pose.turn)));
        append(shifted, shape->length, pose.shift);
        append(contact, shape->length,
               center + pose.shift + Eigen::Rotation2Dd(pose.turn) * row.cam.front().contact.head<2>());
    }
    append(middle, shape->length, center);
    Json drawing = {{"unit", shape->length.name},       {"rotation", sense_of(cam.formulas->rotation())},
                    {"center", std::move(middle)},      {"outlines", outlines_of(*shape)},
                    {"turned", std::move(turned)},      {"contact", std::move(contact)},
                    {"parts", parts_of(*shape, angles)}};
    if (cam.formulas->plane()->is_plate()) drawing["shifted"] = std::move(shifted);
    return drawing;
}

}  // namespace camopt
