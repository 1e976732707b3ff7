// SPDX-License-Identifier: MIT
// The cam and its mechanism at every cam angle, from what the leaf of its kind says of itself: points, how
// far the cam frame has turned, parts.
#include "core/word_of.hpp"
#include "report/drawing/profile_shape.hpp"
#include "report/page/page_parts.hpp"
#include "report/view/cam_words.hpp"

#include <Eigen/Geometry>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double still = 1e-9;        // m: a part that moves less does not move
constexpr double face_beyond = 0.12;  // of the cam's length: a face reaches so far beyond the contact
constexpr int outline_points = 720;

/// The plane mechanism by rows.
struct PlaneCourse {
    const View& view;
    ShownUnit length;
    std::vector<std::vector<MechanismShape>> shapes;  ///< by row
    std::vector<double> turned;                       ///< rad
    double least_offset = 0.0, largest_offset = 0.0;  ///< of the contact on a face

    [[nodiscard]] const CamReport& report() const { return *view.solution.cam; }
    [[nodiscard]] const DrivenMechanism& cam() const { return report().cam; }
};

PlaneCourse plane_course(const View& view) {
    PlaneCourse course{view, view.units.length, {}, {}};
    const DrivenMechanism& cam = course.cam();
    const MotionScale& scale = view.delivered.scale;
    for (const DeliveredRow& row : view.delivered.rows) {
        const MechanismState state{cam.dimensions, state_of(row.motion, scale), scale.unit_angle * row.x};
        const bool first = course.turned.empty();
        course.shapes.push_back(cam.formulas->shapes(state));
        course.turned.push_back(cam.formulas->turned(state));
        const double offset = row.cam.front().contact_offset;
        if (!std::isfinite(offset)) continue;
        course.least_offset = first ? offset : std::min(course.least_offset, offset);
        course.largest_offset = first ? offset : std::max(course.largest_offset, offset);
    }
    return course;
}

/// From where to where a face is drawn, along itself.
std::pair<double, double> reach_of_face(const PlaneCourse& course) {
    const Scene& scene = course.view.solution.scene;
    if (scene.cam && scene.cam->face_half_width)
        return {-*scene.cam->face_half_width, *scene.cam->face_half_width};
    const double beyond = face_beyond * course.report().summary.base_radius;
    return {std::min(course.least_offset - beyond, 0.0), std::max(course.largest_offset + beyond, 0.0)};
}

std::vector<Vector2d> points_of(const MechanismShape& shape, const std::pair<double, double>& reach) {
    if (shape.kind != MechanismShape::Kind::face) return shape.points;
    const Vector2d along = shape.points[1] - shape.points[0];
    return {shape.points[0] + reach.first * along, shape.points[0] + reach.second * along};
}

const char* name_of_kind(MechanismShape::Kind kind) {
    return word_of<MechanismShape::Kind::face>(kind, {"link", "circle", "pivot", "guide", "face"});
}

Json parts_of(const PlaneCourse& course) {
    Json parts = Json::array();
    const std::pair<double, double> reach = reach_of_face(course);
    for (std::size_t k = 1; k < course.shapes.front().size(); ++k) {  // the first is the cam's centre
        const MechanismShape& first = course.shapes.front()[k];
        std::vector<std::vector<Vector2d>> places;
        bool moves = false;
        for (const std::vector<MechanismShape>& shapes : course.shapes) {
            places.push_back(k < shapes.size() ? points_of(shapes[k], reach) : places.back());
            for (std::size_t p = 0; p < places.back().size(); ++p)
                moves = moves || (places.back()[p] - places.front()[p]).norm() > still;
        }
        if (!moves) places.resize(1);
        Json points = Json::array();
        for (const std::vector<Vector2d>& place : places)
            for (const Vector2d& point : place) append(points, course.length, point);
        parts.push_back({{"kind", name_of_kind(first.kind)},
                         {"name", words_of(first.name)},
                         {"radius", rounded_json(course.length.of(first.radius))},
                         {"count", places.front().size()},
                         {"points", std::move(points)}});
    }
    return parts;
}

/// The cam along its own motion, without the dwell of a DRD cam.
Json outline(const PlaneCourse& course, int station, std::string_view name, bool pitch) {
    Json points = Json::array();
    const CamPoints& cam = *course.view.delivered.cam;
    const MotionChain& motion = *course.view.delivered.whole;
    std::vector<const Vector3d*> places;
    for (const double x : even_places(motion.breakpoints(), outline_points)) {
        const MechanismPoint& point = cam.at(motion_at(motion, x), station);
        places.push_back(pitch ? &point.pitch : &point.contact);
        append(points, course.length, places.back()->head<2>());
    }
    const double gap = (*places.front() - *places.back()).norm();
    const bool turn = cam.scale().unit_angle * (motion.end() - motion.begin()) > units::turn - still;
    return {{"name", name},
            {"closed", turn && gap < 1e3 * still},
            {"pitch", pitch},
            {"points", std::move(points)}};
}

Json outlines_of(const PlaneCourse& course) {
    const CamMechanism& formulas = *course.cam().formulas;
    Json all = Json::array();
    if (formulas.stations() > 1) {
        // Of a cam the first side is filled, the other one a line.
        for (const int side : {0, 1})
            all.push_back(outline(course, side, formulas.station_name(side), false));
        if (!formulas.has_guide()) all.back()["closed"] = false;
    } else {
        all.push_back(outline(course, 0, "cam", false));
    }
    if (formulas.roller_radius() >= 0) all.push_back(outline(course, 0, "path of the roller's centre", true));
    return all;
}

Json circles_of(const PlaneCourse& course) {
    Json all = Json::array();
    const CamMechanism& formulas = *course.cam().formulas;
    if (!formulas.planar()) return all;
    const double base = course.report().summary.base_radius;
    all.push_back({{"name", "base circle"}, {"radius", rounded_json(course.length.of(base))}});
    if (const int roller = formulas.roller_radius(); roller >= 0)
        all.push_back({{"name", "prime circle"},
                       {"radius", rounded_json(course.length.of(base + course.cam().dimensions[roller]))}});
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
    const Solution& solution = view.solution;
    if (!view.delivered.whole || !solution.cam->cam.formulas->is_plane_curve()) return nullptr;
    const PlaneCourse course = plane_course(view);
    if (course.shapes.front().empty()) return nullptr;
    const Vector2d center = course.shapes.front().front().points.front();
    Json turned = Json::array(), contact = Json::array(), middle = Json::array();
    for (std::size_t i = 0; i < course.turned.size(); ++i) {
        turned.push_back(rounded_json(view.units.angle.of(course.turned[i])));
        append(contact, course.length,
               center + Eigen::Rotation2Dd(course.turned[i]) *
                            view.delivered.rows[i].cam.front().contact.head<2>());
    }
    append(middle, course.length, center);
    const std::optional<ProfileShape> shape = delivered_shape(view);
    const std::optional<double> rim = shape ? rim_radius(*shape) : std::nullopt;
    return {{"rim", rim ? rounded_json(course.length.of(*rim)) : Json(nullptr)},
            {"unit", course.length.name},
            {"rotation", sense_of(solution.cam->cam.formulas->rotation())},
            {"center", std::move(middle)},
            {"outlines", outlines_of(course)},
            {"circles", circles_of(course)},
            {"turned", std::move(turned)},
            {"contact", std::move(contact)},
            {"parts", parts_of(course)}};
}

}  // namespace camopt
