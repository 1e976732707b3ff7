// SPDX-License-Identifier: MIT
#include "shop/sheet/cam_sheet.hpp"

#include "core/text/list_text.hpp"
#include "report/drawing/plane_cam.hpp"
#include "report/view/key_words.hpp"
#include "report/view/number_text.hpp"
#include "scene/limit_table.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/dimension_marks.hpp"
#include "shop/sheet/sheet_furniture.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using units::degree;

constexpr double outline_tolerance = 1e-6;  // m: of the arcs
constexpr int table_step = 5;               // deg

// m on the paper: what dimensions and words beside the views need.
constexpr double beside_cam = 24e-3, above_cam = 16e-3, before_section = 6e-3, after_section = 22e-3;
constexpr double leader_reach = 4e-3, datum_reach = 3e-3, rotation_distance = 3.5e-3, keyway_line = 5e-3,
                 thickness_line = 6e-3, bore_line = 7e-3, depth_line = 15e-3, hatch_step = 2.5e-3,
                 center_overhang = 3e-3;
constexpr double rotation_head = 3.0e-3, rotation_half_width = 0.8e-3, rotation_angle = 26 * degree;
constexpr double datum_apart = 15 * degree, keyway_apart = 60 * degree;

Vector2d unit_vector(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

double direction_angle(const Vector2d& direction) {
    return std::atan2(direction.y(), direction.x());
}

/// Directions for words around the cam, each as far from all before as can be.
class FreeDirections {
 public:
    void take(double angle) { taken_.push_back(angle); }
    [[nodiscard]] double next() {
        constexpr int steps = 24;
        double best = 0.0, most = -1.0;
        for (int k = 0; k < steps; ++k) {
            const double angle = (k + 0.5) * units::turn / steps;
            double nearest = units::turn;
            for (const double other : taken_)
                nearest = std::min(nearest, std::abs(std::remainder(angle - other, units::turn)));
            if (nearest > most + 1e-9) most = nearest, best = angle;
        }
        take(best);
        return best;
    }

 private:
    std::vector<double> taken_;
};

class CamSheetMaker {
 public:
    /// piece: "second disk"; empty: the cam is one piece.
    CamSheetMaker(const Solution& solution, const ProfileShape& shape, const DrawingSpec& drawing,
                  std::string piece)
        : solution_(solution),
          shape_(shape),
          cam_(shape.formulas()),
          drawing_(drawing),
          piece_(std::move(piece)),
          disk_(rim_radius(shape)) {
        base_ = shape.base_radius();
        prime_ = shape.prime_radius();
        for (const std::vector<MechanismPoint>& points : profile_pieces(shape, 1440))
            for (const MechanismPoint& point : points) {
                const Vector2d contact = in_plane(point.contact), pitch = in_plane(point.pitch);
                box_.add(contact);
                box_.add(pitch);
                if (contact.norm() > farthest_.norm()) farthest_ = contact;
                rim_.push_back(contact);
                if (shape.has_roller()) rim_.push_back(pitch);
            }
        if (disk_) {
            box_.add({0.0, 0.0}, *disk_);
            rim_.emplace_back(*disk_ * ray_at(cam_.rotation(), drawing.datum));
            farthest_ = other_side_farthest();
        }
        box_.add({0.0, 0.0}, prime_);
        datum_ = ray_at(cam_.rotation(), drawing.datum);
        cut_ = drawing.keyway ? ray_at(cam_.rotation(), drawing.keyway->at) : datum_;
    }

    Sheet make() {
        choose_paper();
        place_views();
        add_outline();
        add_bore();
        add_datum();
        add_section();
        add_dimensions();
        separate_dimensions(sheet_);
        add_rotation();
        add_furniture();
        return std::move(sheet_);
    }

 private:
    const Solution& solution_;
    const ProfileShape& shape_;
    const CamMechanism& cam_;
    const DrawingSpec& drawing_;
    std::string piece_;
    std::optional<double> disk_;  ///< radius of the disk that a groove is cut into
    double base_ = 0.0, prime_ = 0.0;
    DrawingBox box_;
    Vector2d farthest_ = Vector2d::Zero(), datum_, cut_;
    std::vector<Vector2d> rim_;
    FreeDirections free_;
    SheetTable table_;
    double section_left_ = 0.0;  ///< model
    Sheet sheet_;

    [[nodiscard]] Drawing& draw() { return sheet_.drawing; }
    [[nodiscard]] Vector2d other_side_farthest() const {
        Vector2d farthest = Vector2d::Zero();
        for (const std::vector<MechanismPoint>& piece : profile_pieces(other_side(shape_), 1440))
            for (const MechanismPoint& point : piece)
                if (point.contact.norm() > farthest.norm()) farthest = in_plane(point.contact);
        return farthest;
    }
    [[nodiscard]] double keyway_from_datum() const {
        return std::remainder(direction_angle(cut_) - direction_angle(datum_), units::turn);
    }
    [[nodiscard]] bool has_keyway_angle() const { return std::abs(keyway_from_datum()) > 1e-9; }
    [[nodiscard]] double thickness() const { return *drawing_.thickness; }
    /// m of the model in so much on the paper.
    [[nodiscard]] double paper(double length) const { return sheet_.paper(length); }
    /// From the origin, which lies inside, along the ray to the rim of the box.
    [[nodiscard]] double exit(const Vector2d& ray) const {
        double reach = HUGE_VAL;
        for (int i = 0; i < 2; ++i) {
            const double side = ray(i) > 0.0 ? box_.most(i) : box_.least(i);
            if (std::abs(ray(i)) > 1e-12) reach = std::min(reach, side / ray(i));
        }
        return reach;
    }

    [[nodiscard]] SheetTable radius_table() const {
        SheetTable table;
        const bool rollers = shape_.has_roller();
        table.head = rollers ? std::vector<std::string>{"α", "R", "Rc"} : std::vector<std::string>{"α", "R"};
        if (disk_) table.head.emplace_back("Ro");
        const LengthUnit unit = solution_.scene.length_unit;
        const auto shown = [unit](const std::optional<double>& radius) {
            return radius ? fmt::format("{:.{}f}", *radius / metres_of(unit), drawn_decimals(unit))
                          : std::string("open");
        };
        for (int alpha = 0; alpha < 360; alpha += table_step) {
            const Vector2d ray = ray_at(cam_.rotation(), drawing_.datum + alpha * degree);
            table.rows.push_back({fmt::format("{}°", alpha), shown(radius_along(shape_, ray, true))});
            if (rollers) table.rows.back().push_back(shown(radius_along(shape_, ray, false)));
            if (disk_) table.rows.back().push_back(shown(radius_along(other_side(shape_), ray, true)));
        }
        return table;
    }
    void choose_paper() {
        table_ = radius_table();
        choose_format(sheet_, box_.size() + Vector2d(thickness(), 0.0),
                      {2.0 * beside_cam + before_section + after_section, 2.0 * above_cam}, table_.width());
        sheet_.lengths = solution_.scene.length_unit;
        sheet_.title = solution_.scene.title.empty() ? "Cam" : solution_.scene.title;
        if (!piece_.empty()) sheet_.title += ", " + piece_;
    }
    void place_views() {
        const double scale = sheet_.scale;
        const Vector2d room = room_for_views(sheet_, table_.width());
        const Vector2d cam = scale * box_.size();
        const double all = cam.x() + 2.0 * beside_cam + before_section + scale * thickness() + after_section;
        const double left = sheet_left_margin + block_distance + 0.5 * (room.x() - all) + beside_cam;
        const double bottom = sheet_margin + title_block_height + block_distance + 0.5 * (room.y() - cam.y());
        sheet_.origin = Vector2d(left, bottom) - scale * box_.least;
        section_left_ = box_.most.x() + paper(beside_cam + before_section);
    }

    void add_outline() {
        draw() = cam_outlines(shape_, [](const ProfileShape& side, bool of_cam) {
            return outline_chain(side, of_cam, outline_tolerance).vertices;
        });
        if (!shape_.closed && !draw().has("open"))
            draw().line("open", in_plane(shape_.at(shape_.begin()).contact),
                        in_plane(shape_.at(shape_.end()).contact));
        for (const Vector2d& axis : {Vector2d(1.0, 0.0), Vector2d(0.0, 1.0)})
            draw().line("axes", -(exit(-axis) + paper(center_overhang)) * axis,
                        (exit(axis) + paper(center_overhang)) * axis);
    }
    void add_bore() {
        if (!drawing_.bore) return;
        if (!drawing_.keyway)
            draw().circle("bore", {0.0, 0.0}, 0.5 * *drawing_.bore);
        else
            draw().path("bore", bore_outline(drawing_, cam_.rotation()), true);
    }
    void add_datum() {
        const double reach = exit(datum_) + paper(datum_reach);
        const double rim = disk_ ? *disk_ : radius_along(shape_, datum_, true).value_or(base_);
        draw().line("datum", drawing_.reach() * datum_, reach * datum_);
        draw().line("datum-mark", (rim - paper(4e-3)) * datum_, rim * datum_);
        add_datum_words("datum, α = 0", reach, datum_);
        if (!make_way(farthest_, datum_apart) && has_keyway_angle()) make_way(cut_, keyway_apart);
        free_.take(direction_angle(datum_));
        for (const double axis : {0.0, 90.0, 180.0, 270.0})
            if (std::abs(std::remainder(axis * degree - direction_angle(datum_), units::turn)) > 20 * degree)
                free_.take(axis * degree);
    }
    /// The largest radius, and the angle of the keyway, have their words beside those of the datum where both
    /// point nearly the same way: the datum's step aside, away from it.
    bool make_way(const Vector2d& other, double near) {
        const double apart = std::remainder(direction_angle(other) - direction_angle(datum_), units::turn);
        if (std::abs(apart) > near) return false;
        auto& word = std::get<DrawnText>(draw().elements.back());
        const Vector2d left(-datum_.y(), datum_.x());
        const Vector2d away = apart < 0.0 ? left : Vector2d(-left);
        if (word.anchor == TextSide::middle) {
            word.anchor = away.x() > 0.0 ? TextSide::start : TextSide::end;
            word.at.x() += (away.x() > 0.0 ? 1.0 : -1.0) * paper(1e-3);
        } else {
            word.at.y() += (away.y() > 0.0 ? 1.0 : -1.0) * paper(3.5e-3);
        }
        return true;
    }
    /// At so much of the model along a ray, outside of its end.
    void add_datum_words(const std::string& words, double reach, const Vector2d& ray) {
        const TextSide anchor = ray.x() > 0.3    ? TextSide::start
                                : ray.x() < -0.3 ? TextSide::end
                                                 : TextSide::middle;
        const double drop = ray.y() < 0.0 ? 2.5e-3 * -ray.y() : 0.0, lift = ray.y() > 0.3 ? 0.8e-3 : 0.0;
        const double aside = anchor == TextSide::middle ? 0.0 : (ray.x() > 0.0 ? 1.0 : -1.0) * 1.0e-3;
        const Vector2d beside(aside, lift - drop - (lift > 0.0 ? 0.0 : 0.9e-3));
        draw().text({"datum-words", reach * ray + paper(1.0) * beside, paper(2.5e-3), words, anchor});
    }

    void hatch(const Vector2d& low, const Vector2d& high) {
        const double step = paper(hatch_step) * std::numbers::sqrt2;
        // Lines y = x + c through the box.
        const int first = static_cast<int>(std::ceil((low.y() - high.x()) / step));
        for (int k = first; k * step < high.y() - low.x(); ++k) {
            const double c = k * step;
            const double from = std::max(low.x(), low.y() - c), to = std::min(high.x(), high.y() - c);
            if (to - from > paper(0.3e-3)) draw().line("hatch", {from, from + c}, {to, to + c});
        }
    }
    /// The section stands on the right: first angle shows it from the left, third angle from the right.
    [[nodiscard]] bool upper_right() const { return drawing_.projection == Projection::first_angle; }
    /// On one side of the axis, from the bore to the rim.
    void add_groove_section(double sense, double bore, double rim) {
        const Vector2d ray = sense * cut_;
        const double inner = radius_along(shape_, ray, true).value_or(base_),
                     outer = radius_along(other_side(shape_), ray, true).value_or(inner);
        const double left = section_left_, right = left + thickness(), depth_of = *drawing_.groove_depth;
        const double face = upper_right() ? right : left, back = upper_right() ? left : right,
                     floor = upper_right() ? right - depth_of : left + depth_of;
        const auto part = [&](double from, double to, double side) {
            hatch({std::min(back, side), std::min(sense * from, sense * to)},
                  {std::max(back, side), std::max(sense * from, sense * to)});
        };
        part(bore, inner, face);
        part(inner, outer, floor);
        part(outer, rim, face);
        for (const double flank : {inner, outer})
            draw().line("section", {floor, sense * flank}, {face, sense * flank});
        draw().line("section", {floor, sense * inner}, {floor, sense * outer});
        if (sense > 0.0) return;
        DrawnDimension depth;
        depth.direction = 0.0;
        depth.first = {std::min(floor, face), -rim};
        depth.second = {std::max(floor, face), -rim};
        depth.place = {floor, -rim - paper(thickness_line)};
        sheet_.dimensions.push_back(depth);
    }
    /// Through the middle of the keyway, or through the datum.
    void add_section() {
        const auto reach = [&](const Vector2d& ray) {
            return disk_ ? *disk_ : radius_along(shape_, ray, true).value_or(base_);
        };
        const double up = reach(cut_), down = reach(-cut_), left = section_left_, right = left + thickness();
        draw().rectangle("section", {left, -down}, {right, up});
        const double radius = 0.5 * drawing_.bore.value_or(0.0);
        const double top = drawing_.keyway ? radius + drawing_.keyway->depth : radius;
        if (disk_) {
            add_groove_section(1.0, top, up);
            add_groove_section(-1.0, radius, down);
        } else {
            hatch({left, top}, {right, up});
            hatch({left, -down}, {right, -radius});
        }
        draw().line("axes", {left - paper(center_overhang), 0.0}, {right + paper(center_overhang), 0.0});
        DrawnDimension dimension;
        dimension.direction = 0.0;
        dimension.first = {left, up};
        dimension.second = {right, up};
        dimension.place = {left, up + paper(thickness_line)};
        sheet_.dimensions.push_back(dimension);
        if (!drawing_.bore) return;
        draw().line("section", {left, -radius}, {right, -radius});
        draw().line("section", {left, top}, {right, top});
        if (drawing_.keyway) {
            const double edge = std::sqrt(radius * radius - std::pow(0.5 * drawing_.keyway->width, 2));
            draw().line("section", {left, edge}, {right, edge});
        }
        const auto height = [&](double from, double to, double distance, bool across) {
            DrawnDimension upright;
            upright.direction = 90 * degree;
            upright.first = {right, from};
            upright.second = {right, to};
            upright.place = {right + paper(distance), 0.0};
            upright.across = across;
            if (across) upright.tolerance = drawing_.title_block.bore_fit;
            sheet_.dimensions.push_back(upright);
        };
        height(-radius, radius, bore_line, true);
        if (drawing_.keyway) height(-radius, top, depth_line, false);
    }

    void add_leader(DrawnDimension::Kind kind, double radius, double angle) {
        DrawnDimension dimension;
        dimension.kind = kind;
        dimension.second = radius * unit_vector(angle);
        dimension.place = (exit(unit_vector(angle)) + paper(leader_reach)) * unit_vector(angle);
        sheet_.dimensions.push_back(dimension);
    }
    void add_dimensions() {
        const double far = direction_angle(farthest_);
        if (drawing_.keyway) add_keyway();
        free_.take(far);
        add_leader(DrawnDimension::Kind::radius, farthest_.norm(), far);
        if (disk_) add_leader(DrawnDimension::Kind::diameter, *disk_, free_.next());
        add_leader(DrawnDimension::Kind::diameter, base_, free_.next());
        if (prime_ > base_) add_leader(DrawnDimension::Kind::diameter, prime_, free_.next());
    }
    void add_keyway() {
        const Keyway& keyway = *drawing_.keyway;
        const double radius = 0.5 * *drawing_.bore, floor = radius + keyway.depth,
                     way = direction_angle(cut_);
        const Vector2d left(-cut_.y(), cut_.x());
        DrawnDimension width;
        width.direction = way + 90 * degree;
        width.first = floor * cut_ - 0.5 * keyway.width * left;
        width.second = floor * cut_ + 0.5 * keyway.width * left;
        width.place = (floor + paper(keyway_line)) * cut_;
        width.tolerance = drawing_.title_block.keyway_tolerance;
        sheet_.dimensions.push_back(width);
        if (!has_keyway_angle()) return;
        DrawnDimension angle;
        angle.kind = DrawnDimension::Kind::angle;
        angle.direction = direction_angle(datum_);
        angle.sweep = keyway_from_datum();
        const double reach = std::max(0.5 * (drawing_.reach() + base_), drawing_.reach() + paper(11e-3));
        angle.place = reach * datum_;
        sheet_.dimensions.push_back(angle);
        separate_dimensions(sheet_);
        const double behind_words = floor + paper(keyway_line + 3.5e-3),
                     end = sheet_.dimensions.back().place.norm() + paper(2e-3);
        draw().line("axes", behind_words * cut_, end * cut_);
        free_.take(way);
    }

    /// Outside of the outline, in a free direction.
    void add_rotation() {
        const double middle = free_.next(), sense = sense_of(cam_.rotation());
        double radius = base_;
        for (const Vector2d& point : rim_)
            if (std::abs(std::remainder(direction_angle(point) - middle, units::turn)) < rotation_angle)
                radius = std::max(radius, point.norm());
        radius = std::max({radius, prime_, disk_.value_or(0.0)}) + paper(rotation_distance);
        const double half = 0.5 * rotation_angle, tip = middle + sense * half;
        draw().arc("rotation", {0.0, 0.0}, radius, middle - half, middle + half);
        const Vector2d out = unit_vector(tip), ahead = sense * Vector2d(-out.y(), out.x());
        const Vector2d end = radius * out;
        draw().polyline("rotation-head",
                        std::array<Vector2d, 3>{end + paper(rotation_head) * ahead,
                                                end + paper(rotation_half_width) * out,
                                                end - paper(rotation_half_width) * out},
                        true);
    }

    [[nodiscard]] std::string length_text(double metres) const {
        return drawn_length(metres, sheet_.lengths);
    }
    /// "translating roller, roller radius 10 mm, offset 8 mm"
    [[nodiscard]] std::string follower_text() const {
        const DirectCamDrawing& drawn = shape_.direct.value();
        std::string text = words_of(drawn.follower);
        const std::vector<NamedDimension>& all = drawn.dimensions;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!all[i].of_form && static_cast<int>(i) != cam_.base_radius_index())
                text += fmt::format(", {} {}", words_of(all[i].name), length_text(all[i].value));
        return text;
    }
    [[nodiscard]] std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        if (!shape_.closed)
            notes.push_back(
                fmt::format("OPEN: {}. Dwell arcs end at the dashed line.",
                            shape_.open_because.empty() ? "not one revolution" : shape_.open_because));
        if (solution_.cam->summary.undercut())
            notes.emplace_back(
                "UNDERCUT: the outline intersects itself; this cam cannot be made as designed.");
        if (solution_.cam->summary.cusp())
            notes.emplace_back("CUSP: the least radius of curvature is 0, an edge that wears.");
        notes.push_back("Follower: " + follower_text() + ".");
        if (disk_)
            notes.push_back(fmt::format("Groove: {} wide, {} deep in the upper face.",
                                        length_text(2.0 * cam_.surface_offset(shape_.cam.dimensions, 1)),
                                        length_text(*drawing_.groove_depth)));
        notes.push_back(fmt::format("Turns {}, seen as drawn.", name_of(cam_.rotation())));
        std::string limits;
        for (const LimitRow& row : limit_rows())
            if (const auto& limit = row.in(solution_.scene.limits);
                limit && !row.needs_forces && !row.needs_dynamics)
                append_item(limits,
                            fmt::format("{} {} {}{}", key_words(fmt::format("limits.{}", row.name)).words,
                                        row.is_least() ? "≥" : "≤", short_text(limit->given()),
                                        limit->unit.empty() ? "" : " " + limit->unit));
        if (!limits.empty()) notes.push_back("Limits of form: " + limits + ".");
        const CamSummary& summary = solution_.cam->summary;
        std::string radii;
        if (summary.convex_radius)
            radii = fmt::format("convex {}", length_text(summary.convex_radius->value));
        if (summary.concave_radius)
            append_item(radii, "concave " + length_text(summary.concave_radius->value));
        if (!radii.empty())
            notes.push_back(fmt::format("Least radii of curvature{}: {}.",
                                        piece_.empty() ? "" : " of both disks", radii));
        const char* const radii_words =
            disk_ ? "R, Ro to the inner and the outer flank, Rc to the roller's centre, along one ray"
            : shape_.has_roller() ? "R to the cam, Rc to the roller's centre, along the same ray"
                                  : "R to the cam";
        notes.push_back(fmt::format(
            "α from the datum mark, {} as drawn. {}.",
            cam_.rotation() == Rotation::counterclockwise ? "clockwise" : "counterclockwise", radii_words));
        notes.push_back(fmt::format("Section through the {}.", drawing_.keyway ? "keyway" : "datum"));
        for (std::string tolerance : {profile_tolerance(), number_tolerances()})
            if (!tolerance.empty()) notes.push_back(std::move(tolerance));
        return notes;
    }
    /// "Profile: the follower's displacement within ±0.02 mm, its slope within ±0.005 mm/deg." Empty: none is
    /// given.
    [[nodiscard]] std::string profile_tolerance() const {
        if (!solution_.scene.tolerance) return {};
        const auto& [profile, slope, acceleration] = solution_.scene.tolerance->motion;
        const bool turns = solution_.scene.motion.lift_is_angle;
        const double unit = turns ? units::degree : metres_of(sheet_.lengths);
        const char* const name = turns ? "deg" : name_of(sheet_.lengths);
        std::string words;
        if (profile)
            append_item(words,
                        fmt::format("the follower's displacement within ±{:.4g} {}", *profile / unit, name));
        if (slope)
            append_item(words,
                        fmt::format("its slope within ±{:.4g} {}/deg", *slope / unit * units::degree, name));
        if (acceleration)
            append_item(words, fmt::format("its second derivative within ±{:.4g} {}/deg²",
                                           *acceleration / unit * units::degree * units::degree, name));
        return words.empty() ? words : fmt::format("Profile: {}.", words);
    }
    /// "base radius ±0.05 mm": what the limits were held for. Empty: none is given.
    [[nodiscard]] std::string number_tolerances() const {
        std::string words;
        if (!solution_.scene.tolerance) return words;
        const CamSpec& cam = *solution_.scene.cam;
        for (const auto& [name, tolerance] : solution_.scene.tolerance->numbers) {
            const int own = cam.written_as(name);
            if (own < 0 || tolerance.percent) continue;
            const bool turns = cam.dimensions[static_cast<std::size_t>(own)].is_angle;
            append_item(words,
                        fmt::format("{} ±{:.4g} {}", words_of(name),
                                    tolerance.size / (turns ? units::degree : metres_of(sheet_.lengths)),
                                    turns ? "deg" : name_of(sheet_.lengths)));
        }
        return words.empty() ? words : fmt::format("Limits hold for {}.", words);
    }
    /// "±0.02 mm", of the follower's displacement; empty: none is given.
    [[nodiscard]] std::string band_of_profile() const {
        const auto& tolerance = solution_.scene.tolerance;
        if (!tolerance || !tolerance->motion[0]) return {};
        const bool turns = solution_.scene.motion.lift_is_angle;
        return fmt::format("±{:.4g} {} of the follower",
                           *tolerance->motion[0] / (turns ? units::degree : metres_of(sheet_.lengths)),
                           turns ? "deg" : name_of(sheet_.lengths));
    }
    void add_furniture() {
        TitleBlock title = drawing_.title_block;
        if (title.profile_tolerance.empty()) title.profile_tolerance = band_of_profile();
        if (title.part.empty())
            title.part = sheet_.title;
        else if (!piece_.empty())
            title.part += ", " + piece_;
        const CamSummary& summary = solution_.cam->summary;
        std::string mass;
        if (drawing_.density && shape_.closed && !summary.undercut())
            mass = weight_shown(sheet_.lengths).text(*drawing_.density * cam_volume(shape_, drawing_), 3);
        add_frame(sheet_, title, mass, drawing_.projection);
        const double right = sheet_.width - sheet_margin, top = sheet_.height - sheet_margin;
        add_table(sheet_, table_, {right - table_.width(), top});
        const double left = sheet_left_margin + 2e-3;
        add_notes(sheet_, notes(), {left, sheet_margin + title_block_height},
                  {right - title_block_width - left - 2e-3, title_block_height});
    }
};

}  // namespace

std::vector<Sheet> cam_sheets(const View& view, const CamSheetOptions& options) {
    const Solution& solution = view.solution;
    const std::optional<ProfileShape> shape = delivered_shape(view);
    if (!shape || shape->is_plate())
        throw InputError("a workshop drawing needs a cam with a base circle, and this solution has none");
    std::vector<Sheet> sheets;
    const std::vector<ProfileShape> pieces = made_pieces(*shape);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const DrawingSpec drawing = drawing_of(solution, pieces[i], options);
        const std::string name = pieces.size() > 1 ? shape->formulas().station_name(static_cast<int>(i)) : "";
        sheets.push_back(CamSheetMaker(solution, pieces[i], drawing, name).make());
    }
    return sheets;
}

}  // namespace camopt
