// SPDX-License-Identifier: MIT
#include "shop/sheet/plate_sheet.hpp"

#include "report/drawing/plane_cam.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/dimension_marks.hpp"
#include "shop/sheet/form_notes.hpp"
#include "shop/sheet/sheet_furniture.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using units::degree;

constexpr double surface_tolerance = 1e-6;  // m: of the arcs
constexpr int most_rows = 37;               // of the table: every 10° of a whole cycle
constexpr int row_step = 5;                 // deg, and its multiples
constexpr double one_height = 1e-6;         // m: two heights that differ by less are one

// m on the paper: what dimensions and words beside the views need.
constexpr double left_of_plate = 28e-3, beside_end_view = 22e-3, right_of_end_view = 12e-3, over = 16e-3,
                 under = 20e-3, first_line = 9e-3, line_apart = 8e-3, datum_overhang = 5e-3,
                 words_height = 2.5e-3;

class PlateSheetMaker {
 public:
    PlateSheetMaker(const Solution& solution, const ProfileShape& shape, const DrawingSpec& drawing,
                    double volume)
        : solution_(solution),
          shape_(shape),
          drawing_(drawing),
          volume_(volume),
          first_(in_plane(shape.at(shape.begin()).contact)),
          last_(in_plane(shape.at(shape.end()).contact)) {
        box_.add({first_.x(), 0.0});
        for (const std::vector<MechanismPoint>& points : profile_pieces(shape, 1440))
            for (const MechanismPoint& point : points) {
                highest_ = std::max(highest_, point.contact.y());
                box_.add(in_plane(point.contact));
                box_.add(in_plane(point.pitch));
            }
        if (first_.x() > last_.x()) std::swap(first_, last_);
    }

    Sheet make() {
        sheet_.lengths = solution_.scene.length_unit;
        sheet_.title = solution_.scene.title.empty() ? "Plate" : solution_.scene.title;
        fill_table();
        const Vector2d words(left_of_plate + beside_end_view + right_of_end_view, over + under);
        choose_format(sheet_, box_.size() + Vector2d(thickness(), 0.0), words, table_.width());
        place_views();
        add_outline();
        add_end_view();
        separate_dimensions(sheet_);
        add_furniture();
        return std::move(sheet_);
    }

 private:
    const Solution& solution_;
    const ProfileShape& shape_;
    const DrawingSpec& drawing_;
    double volume_;
    Vector2d first_, last_;  ///< ends of the surface, left and right
    double highest_ = 0.0;
    DrawingBox box_;
    SheetTable table_;
    double end_view_ = 0.0;  ///< x of its left side
    Sheet sheet_;

    [[nodiscard]] Drawing& draw() { return sheet_.drawing; }
    [[nodiscard]] double paper(double length) const { return sheet_.paper(length); }
    [[nodiscard]] double thickness() const { return drawing_.thickness.value(); }

    void fill_table() {
        // The dwells that the plate has before and behind its motion are straight.
        const double begin = shape_.start,
                     end = begin + solution_.motion->end() * solution_.scene.motion.unit_angle();
        const double range = degrees_shown.of(end - begin);
        const int step = row_step * static_cast<int>(std::ceil(range / (most_rows - 1) / row_step - 1e-9));
        table_.rows_a_block = most_rows;
        const LengthUnit unit = solution_.scene.length_unit;
        const auto shown = [unit](double metres) {
            return fmt::format("{:.{}f}", length_shown(unit).of(metres), drawn_decimals(unit));
        };
        table_.head = {"θ", "x", "y"};
        if (shape_.has_roller()) table_.head.insert(table_.head.end(), {"xc", "yc"});
        const auto add = [&](double theta) {
            const MechanismPoint point = shape_.at(theta);
            table_.rows.push_back({fmt::format("{}°", svg_number(degrees_shown.of(theta), 2)),
                                   shown(point.contact.x()), shown(point.contact.y())});
            if (!shape_.has_roller()) return;
            table_.rows.back().push_back(shown(point.pitch.x()));
            table_.rows.back().push_back(shown(point.pitch.y()));
        };
        for (int k = 0; k * step < range - 1e-6; ++k) add(begin + k * step * degree);
        add(std::min(end, shape_.end()));
    }

    void place_views() {
        const Vector2d room = room_for_views(sheet_, table_.width());
        const double scale = sheet_.scale;
        const double wide =
            left_of_plate + scale * (box_.size().x() + thickness()) + beside_end_view + right_of_end_view;
        const double high = over + scale * box_.size().y() + under;
        const double left = sheet_left_margin + block_distance + 0.5 * (room.x() - wide) + left_of_plate;
        const double bottom =
            sheet_margin + title_block_height + block_distance + 0.5 * (room.y() - high) + under;
        sheet_.origin = Vector2d(left, bottom) - scale * box_.least;
        end_view_ = box_.most.x() + paper(beside_end_view);
    }

    void add_dimension(const Vector2d& from, const Vector2d& to, double direction, const Vector2d& place) {
        DrawnDimension dimension;
        dimension.direction = direction;
        dimension.first = from;
        dimension.second = to;
        dimension.place = place;
        sheet_.dimensions.push_back(dimension);
    }

    void add_outline() {
        draw().path("cam", body_outline(shape_, outline_chain(shape_, true, surface_tolerance).vertices),
                    true);
        if (shape_.has_roller())
            draw().path("pitch", outline_chain(shape_, false, surface_tolerance).vertices, false);
        const double top = box_.most.y() + paper(datum_overhang);
        if (first_.x() <= 0.0 && last_.x() >= 0.0) {
            draw().line("datum", {0.0, -paper(datum_overhang)}, {0.0, top});
            draw().text({"datum-words",
                         {0.0, top + paper(1e-3)},
                         paper(words_height),
                         "datum, x = 0",
                         TextSide::middle});
        }
        const double up = 90.0 * degree, left = box_.least.x() - paper(first_line),
                     right = box_.most.x() + paper(first_line), low = -paper(first_line);
        const bool datum_inside = first_.x() < -one_height && last_.x() > one_height;
        if (datum_inside) add_dimension({0.0, 0.0}, {last_.x(), 0.0}, 0.0, {0.0, low});
        add_dimension({first_.x(), 0.0}, {last_.x(), 0.0}, 0.0,
                      {0.0, datum_inside ? low - paper(line_apart) : low});
        add_dimension({first_.x(), 0.0}, first_, up, {left, 0.0});
        if (std::abs(last_.y() - first_.y()) > one_height)
            add_dimension({last_.x(), 0.0}, last_, up, {right, 0.0});
    }

    /// From the right end of the plate.
    void add_end_view() {
        const double left = end_view_, right = left + thickness();
        draw().rectangle("section", {left, 0.0}, {right, highest_});
        if (highest_ - last_.y() > one_height) draw().line("section", {left, last_.y()}, {right, last_.y()});
        add_dimension({left, highest_}, {right, highest_}, 0.0, {left, highest_ + paper(first_line)});
        if (highest_ - std::max(first_.y(), last_.y()) > one_height)
            add_dimension({right, 0.0}, {right, highest_}, 90.0 * degree, {right + paper(first_line), 0.0});
    }

    [[nodiscard]] std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        if (solution_.cam->summary.undercut())
            notes.emplace_back(
                "UNDERCUT: the outline intersects itself; this plate cannot be made as designed.");
        if (solution_.cam->summary.cusp())
            notes.emplace_back("CUSP: the least radius of curvature is 0, an edge that wears.");
        notes.push_back(follower_note(shape_, sheet_.lengths));
        // What the follower touches runs along the plate the other way.
        const bool backwards = shape_.at(shape_.end()).contact.x() > shape_.at(shape_.begin()).contact.x();
        notes.push_back(fmt::format(
            "The plate slides by {} in 360° of the cam angle θ, towards {}x.",
            drawn_length(units::turn * *shape_.formulas().slide(shape_.cam.dimensions), sheet_.lengths),
            backwards ? "-" : "+"));
        add_form_notes(notes, solution_);
        notes.push_back(
            fmt::format("x from the datum, y from the bottom. x, y: where the follower touches at θ{}.",
                        shape_.has_roller() ? "; xc, yc: its roller's centre" : ""));
        add_tolerance_notes(notes, solution_.scene);
        return notes;
    }

    void add_furniture() {
        TitleBlock title = drawing_.title_block;
        if (title.part.empty()) title.part = sheet_.title;
        std::string mass;
        if (drawing_.density && !solution_.cam->summary.undercut())
            mass = weight_shown(sheet_.lengths).text(*drawing_.density * volume_, 3);
        add_frame(sheet_, title, mass, drawing_.projection);
        const double right = sheet_.width - sheet_margin, top = sheet_.height - sheet_margin;
        add_table(sheet_, table_, {right - table_.width(), top});
        const double left = sheet_left_margin + 2e-3;
        add_notes(sheet_, notes(), {left, sheet_margin + title_block_height},
                  {right - title_block_width - left - 2e-3, title_block_height});
    }
};

}  // namespace

Sheet plate_sheet(const Solution& solution, const ProfileShape& shape, const DrawingSpec& drawing,
                  double volume) {
    return PlateSheetMaker(solution, shape, drawing, volume).make();
}

}  // namespace camopt
