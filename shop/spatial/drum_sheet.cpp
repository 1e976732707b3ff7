// SPDX-License-Identifier: MIT
#include "shop/spatial/drum_sheet.hpp"

#include "report/spatial/flank_surfaces.hpp"
#include "report/spatial/indexing_body.hpp"
#include "report/view/view.hpp"
#include "shop/sheet/dimension_marks.hpp"
#include "shop/sheet/sheet_furniture.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using units::degree;

constexpr int table_step = 5;                    // deg
constexpr int label_steps[] = {30, 45, 60, 90};  // deg, the first that leaves room for its labels
constexpr int line_angles = 721, section_heights = 9;
constexpr double same_angle = 1e-9;      // rad
constexpr double wall_of_drawing = 1.0;  // of half the groove's width: as the solid, where nothing says it

// m on the paper: what dimensions and words beside the views need.
constexpr double left_of_development = 32e-3, between_views = 16e-3, right_of_body = 30e-3, above = 20e-3,
                 below = 24e-3;
constexpr double tick = 2e-3, label_height = 2.5e-3, label_width = 11e-3, label_below = 5.5e-3,
                 line_distance = 9e-3, next_line = 8e-3, overhang = 3e-3, hatch_step = 2.5e-3,
                 least_hatch = 0.3e-3;

/// A line on the developed outside.
using DevelopedLine = std::vector<Vector2d>;

/// What runs beyond either end of the turn goes on at the other one; cut at both ends of the body.
std::vector<DevelopedLine> on_one_turn(const DevelopedLine& line, double around, double length) {
    std::vector<DevelopedLine> pieces;
    DevelopedLine piece;
    double turns = 0.0;
    const auto close_piece = [&] {
        if (piece.size() > 1) pieces.push_back(piece);
        piece.clear();
    };
    const auto between = [](const Vector2d& a, const Vector2d& b, int i, double value) -> Vector2d {
        return a + (value - a(i)) / (b(i) - a(i)) * (b - a);
    };
    const auto inside = [&](const Vector2d& point) { return point.y() >= 0.0 && point.y() <= length; };
    const auto add = [&](const Vector2d& point) {
        piece.emplace_back(point.x() - turns * around, point.y());
    };
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (k == 0) {
            turns = std::floor(line[0].x() / around);
            if (inside(line[0])) add(line[0]);
            continue;
        }
        Vector2d from = line[k - 1];
        const Vector2d& to = line[k];
        if (inside(from) != inside(to)) {
            const Vector2d end = between(from, to, 1, (inside(from) ? to : from).y() < 0.0 ? 0.0 : length);
            if (inside(from)) {
                add(end);
                close_piece();
                continue;
            }
            turns = std::floor(end.x() / around);
            from = end;
            add(end);
        }
        if (!inside(to)) continue;
        while (to.x() > (turns + 1.0) * around || to.x() < turns * around) {
            const double step = to.x() < turns * around ? -1.0 : 1.0;
            const Vector2d seam = between(from, to, 0, (turns + (step > 0.0 ? 1.0 : 0.0)) * around);
            add(seam);
            close_piece();
            turns += step;
            add(seam);
        }
        add(to);
    }
    close_piece();
    return pieces;
}

/// Lines at 45 degrees within a closed polygon.
void hatch(Drawing& drawing, const DevelopedLine& polygon, double step, double least) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Vector2d& point : polygon) {
        low = std::min(low, point.y() - point.x());
        high = std::max(high, point.y() - point.x());
    }
    for (int k = static_cast<int>(std::ceil(low / step)); k * step < high; ++k) {
        const double c = k * step;
        std::vector<double> crossings;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double before = a.y() - a.x() - c, after = b.y() - b.x() - c;
            if ((before < 0.0) != (after < 0.0))
                crossings.push_back(a.x() + before / (before - after) * (b.x() - a.x()));
        }
        std::ranges::sort(crossings);
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
            if (crossings[i + 1] - crossings[i] > least)
                drawing.line("hatch", {crossings[i], crossings[i] + c},
                             {crossings[i + 1], crossings[i + 1] + c});
    }
}

class DrumSheetMaker {
 public:
    DrumSheetMaker(const Solution& solution, const CamFlanks& cam, const FollowerMotion& motion,
                   const DrawingSpec& drawing)
        : solution_(solution), cam_(cam), motion_(motion), drawing_(drawing), sense_(sense_of(cam.rotation)) {
        if (indexes(cam, motion)) indexing_.emplace(cam, motion, cam.roller_length + floor_clearance);
        way_ = indexing_ ? indexing_->path() : motion_;
        choose_body();
        const double datum = std::remainder(drawing_.datum - motion_.begin(), units::turn);
        datum_ = motion_.begin() + (datum < -same_angle ? datum + units::turn : datum);
        const Vector3d first = near_end(std::min(datum_, motion_.end()));
        from_ = std::atan2(first.y(), first.x());
    }

    Sheet make() {
        fill_table();
        sheet_.lengths = solution_.scene.length_unit;
        sheet_.title = solution_.scene.title.empty() ? "Drum" : solution_.scene.title;
        const Vector2d words(left_of_development + between_views + right_of_body, above + below);
        choose_format(sheet_, {around() + 2.0 * body_.radius, length()}, words, table_.width());
        place_views();
        add_development();
        add_body();
        separate_dimensions(sheet_);
        add_furniture();
        return std::move(sheet_);
    }

 private:
    const Solution& solution_;
    const CamFlanks& cam_;
    const FollowerMotion& motion_;
    const DrawingSpec& drawing_;
    double sense_ = 1.0;
    std::optional<IndexingGroove> indexing_;
    FollowerMotion way_;
    DrumSize body_;
    double floor_ = HUGE_VAL;  ///< least radius of the groove
    double datum_ = 0.0, from_ = 0.0;
    double middle_ = 0.0;  ///< x of the body's axis
    SheetTable table_;
    Sheet sheet_;

    [[nodiscard]] Drawing& draw() { return sheet_.drawing; }
    [[nodiscard]] double paper(double length) const { return sheet_.paper(length); }
    [[nodiscard]] double length() const { return body_.upper - body_.lower; }
    [[nodiscard]] double around() const { return units::turn * body_.radius; }
    [[nodiscard]] bool is_round() const { return indexing_ && cam_.arc.has_value(); }
    [[nodiscard]] Vector3d near_end(double theta) const { return cam_.axis(theta, way_.state(theta).s).foot; }
    [[nodiscard]] std::string length_text(double metres) const {
        return drawn_length(metres, sheet_.lengths);
    }

    void choose_body() {
        const FlankGrid grid = flank_grid(cam_, way_, {2, line_angles, 0.0, 0.0});
        DrumSize groove{0.0, HUGE_VAL, -HUGE_VAL};
        for (const FlankSurface& flank : grid.flanks)
            for (const Vector3d& point : flank.points) {
                const double radius = point.head<2>().norm();
                floor_ = std::min(floor_, radius);
                groove = {std::max(groove.radius, radius), std::min(groove.lower, point.z()),
                          std::max(groove.upper, point.z())};
            }
        body_ = body_around(groove, cam_.body, wall_of_drawing * cam_.roller_radius);
        if (indexing_) {
            const double lower = indexing_->lower(), upper = indexing_->upper();
            body_ = {indexing_->outside(is_round() ? 0.5 * (lower + upper) : lower), lower, upper};
        }
        if (drawing_.reach() >= floor_)
            throw InputError(
                fmt::format("drawing.bore: found a bore that reaches {} from the axis; allowed: less than "
                            "{}, the groove's floor",
                            length_text(drawing_.reach()), length_text(floor_)));
    }

    /// z from the lower end; the angle unwound from the datum on.
    [[nodiscard]] DevelopedLine developed(const std::vector<Vector3d>& points, double first) const {
        DevelopedLine line;
        double angle = first;
        for (const Vector3d& point : points) {
            const double here = sense_ * (from_ - std::atan2(point.y(), point.x()));
            angle += std::remainder(here - angle, units::turn);
            line.emplace_back(body_.radius * angle, point.z() - body_.lower);
        }
        return line;
    }
    void add_lines(const char* style, const std::vector<Vector3d>& points) {
        for (const DevelopedLine& piece :
             on_one_turn(developed(points, way_.begin() - datum_), around(), length()))
            draw().polyline(style, piece);
    }

    void fill_table() {
        const LengthUnit unit = solution_.scene.length_unit;
        bool twisted = false;
        std::vector<std::array<double, 2>> rows;
        for (int alpha = 0; alpha < 360; alpha += table_step) {
            double theta = datum_ + alpha * degree;
            if (theta > motion_.begin() + units::turn - same_angle) theta -= units::turn;
            const bool made = theta <= motion_.end() + same_angle;
            const Vector3d at = near_end(std::min(theta, motion_.end()));
            const double psi = sense_ * (from_ - std::atan2(at.y(), at.x()));
            const double beside = std::remainder(psi - alpha * degree, units::turn);
            twisted = twisted || (made && std::abs(beside) > same_angle);
            rows.push_back({made ? at.z() - body_.lower : std::nan(""), alpha * degree + beside});
        }
        table_.head = {"α", "z"};
        if (twisted) table_.head.emplace_back("ψ");
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto& [z, psi] = rows[i];
            const bool made = std::isfinite(z);
            table_.rows.push_back(
                {fmt::format("{}°", static_cast<int>(i) * table_step),
                 made ? fmt::format("{:.{}f}", length_shown(unit).of(z), drawn_decimals(unit))
                      : std::string("open")});
            if (twisted)
                table_.rows.back().push_back(made ? fmt::format("{:.3f}°", degrees_shown.of(psi))
                                                  : std::string("open"));
        }
    }

    void place_views() {
        const Vector2d room = room_for_views(sheet_, table_.width());
        const double wide = left_of_development + between_views + right_of_body +
                            sheet_.scale * (around() + 2.0 * body_.radius);
        const double left =
            sheet_left_margin + block_distance + 0.5 * (room.x() - wide) + left_of_development;
        const double high = sheet_.scale * length() + above + below;
        const double bottom =
            sheet_margin + title_block_height + block_distance + 0.5 * (room.y() - high) + below;
        sheet_.origin = {left, bottom};
        middle_ = around() + paper(between_views) + body_.radius;
    }

    void add_dimension(const Vector2d& first, const Vector2d& second, double direction, const Vector2d& place,
                       bool across = false, const std::string& tolerance = {}) {
        DrawnDimension dimension;
        dimension.direction = direction;
        dimension.first = first;
        dimension.second = second;
        dimension.place = place;
        dimension.across = across;
        dimension.tolerance = tolerance;
        sheet_.dimensions.push_back(dimension);
    }

    /// Its first section lies on the outside.
    [[nodiscard]] FlankGrid outside_grid(int sections) const {
        FlankGrid grid = flank_grid(cam_, way_, {sections, line_angles, 0.0, 0.0});
        cut_at_outside(grid, cam_, way_, body_.radius);
        return grid;
    }
    void add_development() {
        draw().rectangle("section", {0.0, 0.0}, {around(), length()});
        std::array<std::vector<Vector3d>, 2> edges;
        std::vector<Vector3d> way;
        const int turns = static_cast<int>(std::ceil((way_.end() - way_.begin()) / units::turn));
        const std::vector<double> angles = even_angles(way_, turns * line_angles);
        way.reserve(angles.size());
        for (const double theta : angles) way.push_back(near_end(theta));
        if (indexing_) {
            for (const double theta : angles) {
                edges[0].push_back(indexing_->contact(theta, indexing_->first(theta)));
                edges[1].push_back(indexing_->contact(theta, indexing_->last(theta)));
            }
        } else {
            const FlankGrid grid = outside_grid(2);
            for (std::size_t side = 0; side < 2; ++side)
                edges[side].assign(
                    grid.flanks[side].points.begin(),
                    grid.flanks[side].points.begin() + static_cast<std::ptrdiff_t>(grid.angles.size()));
        }
        for (const std::vector<Vector3d>& edge : edges) add_lines("cam", edge);
        add_lines("pitch", way);
        const auto has_room = [&](int step) { return body_.radius * step * degree > paper(label_width); };
        const auto* const chosen = std::ranges::find_if(label_steps, has_room);
        const int label_step = chosen == std::end(label_steps) ? std::end(label_steps)[-1] : *chosen;
        for (int alpha = 0; alpha <= 360; alpha += label_step) {
            const double x = body_.radius * alpha * degree;
            draw().line("datum", {x, -paper(tick)}, {x, alpha == 0 ? length() + paper(tick) : 0.0});
            draw().text({"datum-words",
                         {x, -paper(label_below)},
                         paper(label_height),
                         fmt::format("{}°", alpha),
                         TextSide::middle});
        }
        const double up = 90.0 * degree;
        add_dimension({0.0, 0.0}, {0.0, length()}, up, {-paper(line_distance + 2.0 * next_line), 0.0});
        add_dimension({0.0, length()}, {around(), length()}, 0.0, {0.0, length() + paper(line_distance)});
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (const double theta : even_angles(motion_, line_angles)) {
            const double z = near_end(theta).z() - body_.lower;
            least = std::min(least, z);
            most = std::max(most, z);
        }
        add_dimension({0.0, 0.0}, {0.0, least}, up, {-paper(line_distance), 0.0});
        add_dimension({0.0, least}, {0.0, most}, up, {-paper(line_distance + next_line), 0.0});
    }

    /// The groove in the plane of the datum, from its lower edge on the outside over the floor to its upper
    /// one: (radius, z from the lower end). Empty: it does not go through there.
    [[nodiscard]] DevelopedLine groove_at(double angle) const {
        const FlankGrid grid = outside_grid(section_heights);
        const std::size_t count = grid.angles.size();
        std::array<DevelopedLine, 2> sides;
        for (std::size_t side = 0; side < 2; ++side)
            for (std::size_t i = 0; i < grid.heights.size(); ++i) {
                const auto begin = grid.flanks[side].points.begin() + static_cast<std::ptrdiff_t>(i * count);
                const std::vector<Vector3d> row(begin, begin + static_cast<std::ptrdiff_t>(count));
                const DevelopedLine line = developed(row, way_.begin() - datum_);
                for (std::size_t k = 0; k + 1 < count; ++k) {
                    const double a = line[k].x() / body_.radius - angle,
                                 b = line[k + 1].x() / body_.radius - angle;
                    const double turn = units::turn * std::round(a / units::turn);
                    if (!((a - turn <= 0.0) && (b - turn > 0.0))) continue;
                    const double share = (turn - a) / (b - a);
                    const Vector3d point = row[k] + share * (row[k + 1] - row[k]);
                    sides[side].emplace_back(point.head<2>().norm(), point.z() - body_.lower);
                    break;
                }
            }
        if (sides[0].size() != grid.heights.size() || sides[1].size() != grid.heights.size()) return {};
        if (sides[0].front().y() > sides[1].front().y()) std::swap(sides[0], sides[1]);
        sides[0].insert(sides[0].end(), sides[1].rbegin(), sides[1].rend());
        return sides[0];
    }

    /// One half of the section; sense: +1 right.
    void add_half(double sense, double bore, const DevelopedLine& groove) {
        DevelopedLine outline = {{bore, length()}, {bore, 0.0}};  // along the bore
        if (is_round()) {
            constexpr int steps = 48;
            for (int k = 0; k <= steps; ++k)
                outline.emplace_back(indexing_->outside(body_.lower + length() * k / steps),
                                     length() * k / steps);
        } else {
            outline.emplace_back(body_.radius, 0.0);
            outline.insert(outline.end(), groove.begin(), groove.end());
            outline.emplace_back(body_.radius, length());
        }
        if (bore == 0.0) outline.emplace_back(0.0, length());
        for (Vector2d& point : outline) point.x() = middle_ + sense * point.x();
        if (bore > 0.0)
            draw().polyline("section", outline, true);
        else  // both halves are one
            draw().polyline("section", std::span(outline).subspan(1));
        hatch(draw(), outline, paper(hatch_step) * std::numbers::sqrt2, paper(least_hatch));
    }
    [[nodiscard]] bool has_keyway_in_section() const {
        return drawing_.keyway &&
               std::abs(std::remainder(drawing_.keyway->at - drawing_.datum, units::turn)) < same_angle;
    }
    void add_body() {
        const double bore = 0.5 * drawing_.bore.value_or(0.0), up = 90.0 * degree;
        const double keyway = has_keyway_in_section() ? bore + drawing_.keyway->depth : bore;
        const DevelopedLine right = indexing_ ? DevelopedLine{} : groove_at(0.0),
                            left = indexing_ ? DevelopedLine{} : groove_at(0.5 * units::turn);
        add_half(1.0, keyway, right);
        add_half(-1.0, bore, left);
        draw().line("axes", {middle_, -paper(overhang)}, {middle_, length() + paper(overhang)});
        if (bore > 0.0)
            for (const double end : {0.0, length()})
                draw().line("section", {middle_ - bore, end}, {middle_ + keyway, end});
        const double widest = is_round() ? indexing_->outside(body_.upper) : body_.radius;
        add_dimension({middle_ - widest, length()}, {middle_ + widest, length()}, 0.0,
                      {middle_, length() + paper(line_distance)}, true);
        if (is_round())
            add_dimension({middle_ - body_.radius, 0.5 * length()}, {middle_ + body_.radius, 0.5 * length()},
                          0.0, {middle_, length() + paper(line_distance + next_line)}, true);
        if (bore > 0.0)
            add_dimension({middle_ - bore, 0.0}, {middle_ + bore, 0.0}, 0.0, {middle_, -paper(line_distance)},
                          true, drawing_.title_block.bore_fit);
        if (keyway > bore)
            add_dimension({middle_ - bore, 0.0}, {middle_ + keyway, 0.0}, 0.0,
                          {middle_, -paper(line_distance + next_line)});
        if (right.empty()) return;
        const std::size_t half = right.size() / 2;
        const Vector2d &lower = right.front(), &upper = right.back(), &floor = right[half - 1];
        const double x = middle_ + body_.radius + paper(line_distance);
        add_dimension({middle_ + lower.x(), 0.0}, {middle_ + lower.x(), lower.y()}, up, {x, 0.0});
        add_dimension({middle_ + lower.x(), lower.y()}, {middle_ + upper.x(), upper.y()}, up,
                      {x + paper(next_line), 0.0});
        add_dimension({middle_ + floor.x(), floor.y()}, {middle_ + body_.radius, floor.y()}, 0.0,
                      {middle_ + floor.x(), -paper(line_distance)});
    }

    [[nodiscard]] std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        if (!indexing_ && !groove_closes(motion_))
            notes.emplace_back(
                "OPEN: the groove does not end where it begins; it is not drawn beyond its motion.");
        if (solution_.cam->summary.undercut())
            notes.emplace_back("UNDERCUT: a flank folds; this drum cannot be made as designed.");
        const double roller = 2.0 * cam_.roller_radius - cam_.clearance;
        std::string groove =
            fmt::format("Groove: {} wide, for a roller ⌀{} × {}", length_text(2.0 * cam_.roller_radius),
                        length_text(roller), length_text(cam_.roller_length));
        if (cam_.clearance > 0.0) groove += fmt::format(", clearance {}", length_text(cam_.clearance));
        notes.push_back(groove + ".");
        notes.push_back(fmt::format(
            "Developed at ⌀{}. α from the datum, as the cam angle grows; dashed, z: the roller's axis at its "
            "near "
            "end, from the lower end of the body{}.",
            length_text(2.0 * body_.radius), table_.head.size() > 2 ? "; ψ: around the drum" : ""));
        if (indexing_)
            notes.push_back("Body as turned before the grooves of all rollers are milled" +
                            std::string(is_round() ? ": " + indexing_->turned_words() : "") + ".");
        else
            notes.emplace_back("Section in the plane of the datum, α = 0 on the right.");
        if (drawing_.keyway)
            notes.push_back(fmt::format(
                "Keyway: {}{} wide, {} deep beyond the bore, its middle at α = {}°.",
                length_text(drawing_.keyway->width),
                drawing_.title_block.keyway_tolerance.empty() ? ""
                                                              : " " + drawing_.title_block.keyway_tolerance,
                length_text(drawing_.keyway->depth),
                svg_number(
                    degrees_shown.of(std::remainder(drawing_.keyway->at - drawing_.datum, units::turn)), 3)));
        notes.push_back(fmt::format("Turns {}, seen from the upper end.", name_of(cam_.rotation)));
        return notes;
    }
    void add_furniture() {
        TitleBlock title = drawing_.title_block;
        if (title.part.empty()) title.part = sheet_.title;
        add_frame(sheet_, title, {}, drawing_.projection);
        const double right = sheet_.width - sheet_margin, top = sheet_.height - sheet_margin;
        add_table(sheet_, table_, {right - table_.width(), top});
        const double left = sheet_left_margin + 2e-3;
        add_notes(sheet_, notes(), {left, sheet_margin + title_block_height},
                  {right - title_block_width - left - 2e-3, title_block_height});
    }
};

}  // namespace

Sheet drum_sheet(const Solution& solution, const CamFlanks& cam, const FollowerMotion& motion,
                 const DrawingSpec& drawing) {
    return DrumSheetMaker(solution, cam, motion, drawing).make();
}

}  // namespace camopt
