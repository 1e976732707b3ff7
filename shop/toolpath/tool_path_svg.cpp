// SPDX-License-Identifier: MIT
#include "shop/toolpath/tool_path_svg.hpp"

#include "core/units.hpp"
#include "core/word_of.hpp"
#include "report/drawing/picture_page.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using units::degree;

constexpr double bend_step = 2 * degree;  // of arcs and rotary axes between two points of a line

// Layout of what report/drawing/picture_page.hpp leaves open, px.
constexpr double frame_top = 88, tallest_view = 620, least_side = 90, tallest_side = 230, between_views = 62,
                 page_foot = 60, least_page = 470;
constexpr int most_turns = 8;  // of a program about the cam's axis, for its outlines
constexpr double room = 0.04;  // of a view, on either side

// What lies lower comes first: what cuts lies over what does not.
constexpr std::array<PictureStyle, 10> styles = {
    {{"blank", "fill:#f4efe6;stroke:#9a8866;stroke-width:1.2;stroke-dasharray:6 4"},
     {"finished", "fill:#d9e8f2;stroke:#0072b2;stroke-width:1.1;stroke-linejoin:round"},
     {"groove", "fill:#fff;stroke:#0072b2;stroke-width:1.1;stroke-linejoin:round"},
     {"inside", "fill:#f4efe6;stroke:#0072b2;stroke-width:1.1;stroke-linejoin:round"},
     {"flank", "fill:none;stroke:#0072b2;stroke-width:1.1"},
     {"roughing", "fill:none;stroke:#8a8a8a;stroke-width:.9"},
     {"rapid", "fill:none;stroke:#d55e00;stroke-width:1.2;stroke-dasharray:5 4"},
     {"way", "fill:none;stroke:#009e73;stroke-width:1.6"},
     {"finishing", "fill:none;stroke:#7b3fa0;stroke-width:1.8;stroke-linejoin:round"},
     {"cutter", "fill:#7b3fa0;fill-opacity:.10;stroke:#7b3fa0;stroke-width:1"}}};
constexpr std::span<const PictureStyle> blank_style(styles.data(), 1), work_styles(&styles[1], 4),
    move_styles(&styles[5], 4), cutter_style(&styles[9], 1);
constexpr const char* refused_style = ".refused{fill:#d00000;font-weight:600;font-size:13px}";

const char* style_of(MoveRole role) {
    return word_of<MoveRole::finishing>(role, {"rapid", "way", "roughing", "finishing"});
}

/// Into how many straight pieces a move is cut to be drawn.
int bends(const Machine& machine, const Eigen::VectorXd& from, const NcMove& move) {
    double turned = 0.0;
    for (std::size_t i = 0; i < machine.axes().size(); ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        if (machine.axes()[i].kind == AxisKind::rotary)
            turned = std::max(turned, std::abs(move.values(axis) - from(axis)));
    }
    if (move.arc)
        turned = std::max(
            turned, linear_length(from, move) / std::max(1e-9, (from.head<2>() - move.arc->center).norm()));
    return std::clamp(static_cast<int>(std::ceil(turned / bend_step)), 1, 720);
}

/// Where a tip is drawn in one of the two views of a program, m or rad.
struct Projected {
    bool developed = false;  ///< to the right the angle about the cam's axis, unwrapped
    bool side = false;       ///< upwards what the first view looks along
    double angle = 0.0;      ///< of the last point, rad

    Vector2d operator()(const Vector3d& tip) {
        if (!developed) return {tip.x(), side ? tip.z() : tip.y()};
        angle += std::remainder(std::atan2(tip.y(), tip.x()) - angle, units::turn);
        return {angle, side ? tip.head<2>().norm() : tip.z()};
    }
};

struct PathView {
    Drawing drawing = {};
    DrawingBox box = {};
    double top = frame_top, height = 0.0;  ///< px, of its frame
    PicturePlace place = {};

    void take(Projected at, std::span<const ToolPathLine> lines) {
        for (const ToolPathLine& line : lines) {
            std::vector<Vector2d> points;
            for (const Vector3d& point : line.points) points.push_back(at(point));
            drawing.polyline(style_of(line.role), points);
        }
        box = drawing.box();
    }
    void widen() {
        const Vector2d more = (room * box.size()).cwiseMax(1e-6);
        box.least -= more;
        box.most += more;
    }
    void set_place(double left, double across, double upwards) {
        place = {{left, top + height + upwards * box.least.y()}, {across, upwards}};
    }
};

class ToolPathPainter {
 public:
    ToolPathPainter(const CheckedProgram& program, const NcWork& work, const Machine& machine,
                    const ToolPathPicture& picture)
        : program_(program),
          work_(work),
          picture_(picture),
          developed_(machine.axes().size() > 3),
          groove_(work.task.outlines.size() > 1),
          lines_(tool_path_lines(program, machine)) {
        first_.take({developed_, false}, lines_);
        second_.take({developed_, true}, lines_);
        add_outlines();
        const Blank& blank = work.job.blank;
        if (developed_) {
            first_.box = first_.drawing.box();
            for (const double z : {blank.lower, blank.upper}) first_.box.add({first_.box.least.x(), z});
            second_.box.add({second_.box.least.x(), blank.radius});
        } else {
            if (blank.block)
                for (const Vector2d& corner : {blank.block->min(), blank.block->max()})
                    first_.box.add(corner);
            else
                first_.box.add({0.0, 0.0}, blank.radius);
            second_.box.add({first_.box.least.x(), blank.lower});
            second_.box.add({first_.box.most.x(), blank.upper});
        }
        first_.widen();
        second_.widen();
        second_.box.least.x() = first_.box.least.x();
        second_.box.most.x() = first_.box.most.x();
        place_views();
        add_blank();
        const auto finishing = std::ranges::find(lines_, MoveRole::finishing, &ToolPathLine::role);
        if (!developed_ && finishing != lines_.end())
            first_.drawing.circle("cutter", finishing->points.front().head<2>(),
                                  0.5 * work.task.cutter.diameter);
    }

    std::string paint() {
        SvgCanvas canvas = new_picture(css_of(styles) + refused_style, "Tool path: " + picture_.title,
                                       std::max(least_page, second_.top + second_.height + page_foot));
        canvas.text(picture_left, 58,
                    "The way of the cutter's end, as printed in the program and followed by its check",
                    "subtitle");
        if (const std::string fault = program_.fault(); !fault.empty())
            canvas.text(picture_left, 78, "REFUSED, not written: " + fault, "refused");
        paint_view(canvas, false);
        paint_view(canvas, true);
        paint_legend(canvas);
        return canvas.finish();
    }

 private:
    const CheckedProgram& program_;
    const NcWork& work_;
    const ToolPathPicture& picture_;
    bool developed_, groove_;
    std::vector<ToolPathLine> lines_;
    PathView first_, second_;

    void place_views() {
        const Vector2d first = first_.box.size(), second = second_.box.size();
        double across = picture_frame_width / first.x(), upwards = 0.0,
               left = picture_left - across * first_.box.least.x();
        if (developed_) {
            first_.height = 0.6 * tallest_view;
            second_.height = 0.7 * tallest_side;
            upwards = first_.height / first.y();
        } else {
            // One scale for all; the wider frame is filled from its middle.
            upwards = across = std::min(across, tallest_view / first.y());
            first_.height = across * first.y();
            second_.height = std::clamp(across * second.y(), least_side, tallest_side);
            left = picture_left +
                   0.5 * (picture_frame_width - across * (first_.box.least.x() + first_.box.most.x()));
        }
        second_.top = frame_top + first_.height + between_views;
        first_.set_place(left, across, upwards);
        second_.set_place(left, across, second_.height / second.y());
    }

    [[nodiscard]] const char* outline_style() const {
        return developed_ ? "flank" : groove_ ? "groove" : "finished";
    }
    /// Beside the program's lines: on every turn about the cam's axis that they take. Of a plane groove the
    /// inner flank comes first, and what lies within it is the blank.
    void add_outlines() {
        const DrawingBox drawn = first_.box;
        for (const std::vector<Vector3d>& outline : work_.task.outlines) {
            Projected at{developed_, false};
            std::vector<Vector2d> line;
            line.reserve(outline.size());
            for (const Vector3d& point : outline) line.push_back(at(point));
            if (!developed_) {
                const bool inside = groove_ && &outline == &work_.task.outlines.front();
                first_.drawing.polyline(inside ? "inside" : outline_style(), line, true);
                continue;
            }
            const double middle = 0.5 * (line.front().x() + line.back().x());
            for (int turn = -most_turns; turn <= most_turns; ++turn) {
                const Vector2d offset(turn * units::turn, 0.0);
                if (!(middle + offset.x() > drawn.least.x() && middle + offset.x() < drawn.most.x()))
                    continue;
                std::vector<Vector2d> moved = line;
                for (Vector2d& point : moved) point += offset;
                first_.drawing.polyline(outline_style(), moved);
            }
        }
    }
    void add_blank() {
        const Blank& blank = work_.job.blank;
        const double left = developed_    ? first_.box.least.x()
                            : blank.block ? blank.block->min().x()
                                          : -blank.radius,
                     right = developed_    ? first_.box.most.x()
                             : blank.block ? blank.block->max().x()
                                           : blank.radius;
        if (developed_)
            first_.drawing.rectangle("blank", {left, blank.lower}, {right, blank.upper});
        else if (blank.block)
            first_.drawing.rectangle("blank", blank.block->min(), blank.block->max());
        else
            first_.drawing.circle("blank", {0.0, 0.0}, blank.radius);
        second_.drawing.rectangle("blank", {left, developed_ ? second_.box.least.y() : blank.lower},
                                  {right, developed_ ? blank.radius : blank.upper});
    }

    void paint_frame(SvgCanvas& canvas, bool side) const {
        const PathView& view = side ? second_ : first_;
        PlotFrame frame =
            frame_around(view.place, view.top, view.height, developed_ ? degree : picture_.length.size,
                         picture_.length.size, side ? 4 : 8);
        const std::string& unit = picture_.length.name;
        if (side)
            frame.horizontal_title =
                developed_ ? "angle about the cam's axis, deg" : fmt::format("x, {} (cam frame)", unit);
        const char* const up =
            developed_ ? (side ? "from the axis" : "z along the cam's axis") : (side ? "z" : "y");
        frame.vertical_title = fmt::format("{}, {}", up, unit);
        draw_plot_frame(canvas, frame);
    }

    void paint_view(SvgCanvas& canvas, bool side) const {
        const PathView& view = side ? second_ : first_;
        draw(canvas, view.drawing, view.place, blank_style);
        paint_frame(canvas, side);
        draw(canvas, view.drawing, view.place, work_styles);
        SvgCanvas moves;
        draw(moves, view.drawing, view.place, move_styles);
        const PicturePlace& place = view.place;
        canvas.insert(0, 0,
                      fmt::format("<g class=\"view\" data-place=\"{} {} {} {}\">\n{}</g>\n", place.origin.x(),
                                  place.origin.y(), place.scale.x(), place.scale.y(), moves.elements()));
        draw(canvas, view.drawing, view.place, cutter_style);
    }

    void paint_legend(SvgCanvas& canvas) const {
        std::array<int, 4> moves{};
        for (const FollowedMove& followed : program_.moves) ++moves[static_cast<std::size_t>(followed.role)];
        const auto count = [&](MoveRole role) { return moves[static_cast<std::size_t>(role)]; };
        LegendColumn column(canvas, 17);
        column.heading("Moves");
        column.sample("rapid", fmt::format("rapids, {}", count(MoveRole::rapid)));
        column.sample("way", fmt::format("down, in, out, up, {}", count(MoveRole::way)));
        if (count(MoveRole::roughing) > 0)
            column.sample("roughing", fmt::format("roughing, {}", count(MoveRole::roughing)));
        column.sample("finishing", fmt::format("finishing, {}", count(MoveRole::finishing)));
        column.heading("Work");
        column.sample("blank", "blank");
        column.sample(outline_style(), developed_ ? "flanks, at both roller ends"
                                       : groove_  ? "groove"
                                                  : "finished cam");
        if (!developed_) column.sample("cutter", "cutter where finishing begins");
        const auto length = [&](double metres) { return picture_.length.text(metres); };
        column.heading("Figures");
        column.words(fmt::format("cutter ⌀ {}", length(work_.task.cutter.diameter)));
        if (const auto& block = work_.job.blank.block)
            column.words(
                fmt::format("blank {} × {}", length(block->sizes().x()), length(block->sizes().y())));
        else
            column.words(fmt::format("blank ⌀ {}", length(2.0 * work_.job.blank.radius)));
        column.words(fmt::format("passes {}", program_.travel.passes));
        column.words(fmt::format("{:.1f} min at the given feed", program_.program.seconds / units::minute));
        if (!program_.travel.good()) return;
        column.words(fmt::format("rapids at least {}", length(program_.least_distance)));
        column.words("off the blank");
    }
};

}  // namespace

std::vector<ToolPathLine> tool_path_lines(const CheckedProgram& program, const Machine& machine) {
    std::vector<ToolPathLine> lines;
    Eigen::VectorXd from;
    for (const FollowedMove& followed : program.moves) {
        const NcMove& move = followed.move;
        if (!move.values.allFinite()) continue;
        if (from.size() > 0) {
            if (lines.empty() || lines.back().role != followed.role || lines.back().pass != followed.pass)
                lines.push_back({followed.role, followed.pass, {machine.pose(from).tip}});
            const int pieces = bends(machine, from, move);
            for (int k = 1; k <= pieces; ++k)
                lines.back().points.push_back(
                    machine.pose(k == pieces ? move.values : values_along(from, move, double(k) / pieces))
                        .tip);
        }
        from = move.values;
    }
    return lines;
}

std::string tool_path_svg(const CheckedProgram& program, const NcWork& work, const Machine& machine,
                          const ToolPathPicture& picture) {
    return ToolPathPainter(program, work, machine, picture).paint();
}

}  // namespace camopt
