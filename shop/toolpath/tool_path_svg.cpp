// SPDX-License-Identifier: MIT
#include "shop/toolpath/tool_path_svg.hpp"

#include "core/units.hpp"
#include "core/word_of.hpp"
#include "report/drawing/drawing.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using units::degree;

constexpr double bend_step = 2 * degree;  // of arcs and rotary axes between two points of a line

// Layout, px.
constexpr double page_width = 1000, frame_left = 78, frame_top = 88, frame_width = 640;
constexpr double tallest_view = 620, least_side = 90, tallest_side = 230, between_views = 62, page_foot = 60;
constexpr double legend_left = 752, legend_step = 21, sample = 34, least_page = 470;
constexpr int most_turns = 8;  // of a program about the cam's axis, for its outlines
constexpr double room = 0.04;  // of a view, on either side

// What cuts lies over what does not.
constexpr std::array<PictureStyle, 4> move_styles = {
    {{"roughing", "fill:none;stroke:#8a8a8a;stroke-width:.9"},
     {"rapid", "fill:none;stroke:#d55e00;stroke-width:1.2;stroke-dasharray:5 4"},
     {"way", "fill:none;stroke:#009e73;stroke-width:1.6"},
     {"finishing", "fill:none;stroke:#7b3fa0;stroke-width:1.8;stroke-linejoin:round"}}};
constexpr const char* work_style =
    ".blank{fill:#f4efe6;stroke:#9a8866;stroke-width:1.2;stroke-dasharray:6 "
    "4}.finished{fill:#d9e8f2;stroke:#0072b2;stroke-width:1.1;stroke-linejoin:round}.groove{fill:#fff;fill-"
    "rule:evenodd;stroke:#0072b2;stroke-width:1.1;stroke-linejoin:round}.flank{fill:none;stroke:#0072b2;"
    "stroke-width:1.1}.cutter{fill:#7b3fa0;fill-opacity:.10;stroke:#7b3fa0;stroke-width:1}.heading{font-"
    "size:13px;font-weight:600}.refused{fill:#d00000;font-weight:600;font-size:13px}";

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

/// One of the two views of a program: where a tip is drawn, m or rad.
struct View {
    bool developed = false;  ///< to the right the angle about the cam's axis, unwrapped
    bool side = false;       ///< upwards what the first view looks along
    double angle = 0.0;      ///< of the last point, rad

    Vector2d operator()(const Vector3d& tip) {
        if (!developed) return {tip.x(), side ? tip.z() : tip.y()};
        angle += std::remainder(std::atan2(tip.y(), tip.x()) - angle, units::turn);
        return {angle, side ? tip.head<2>().norm() : tip.z()};
    }
};

Drawing drawing_in(View view, std::span<const ToolPathLine> lines) {
    Drawing drawing;
    for (const ToolPathLine& line : lines) {
        std::vector<Vector2d> points;
        for (const Vector3d& point : line.points) points.push_back(view(point));
        drawing.polyline(style_of(line.role), points);
    }
    return drawing;
}

DrawingBox with_room(DrawingBox box) {
    const Vector2d more = (room * box.size()).cwiseMax(1e-6);
    box.least -= more;
    box.most += more;
    return box;
}

class ToolPathPainter {
 public:
    ToolPathPainter(const CheckedProgram& program, const NcWork& work, const Machine& machine,
                    const ToolPathPicture& picture)
        : program_(program),
          work_(work),
          picture_(picture),
          developed_(machine.axes().size() > 3),
          lines_(tool_path_lines(program, machine)) {
        first_ = drawing_in({developed_, false}, lines_);
        second_ = drawing_in({developed_, true}, lines_);
        const Blank& blank = work.job.blank;
        first_box_ = first_.box();
        second_box_ = second_.box();
        if (developed_) {
            for (const double z : {blank.lower, blank.upper}) first_box_.add({first_box_.least.x(), z});
            second_box_.add({second_box_.least.x(), blank.radius});
            for (const std::vector<ArcVertex>& line : outlines())
                for (const ArcVertex& vertex : line) first_box_.add(vertex.position);
        } else {
            first_box_.add({0.0, 0.0}, blank.radius);
            second_box_.add({first_box_.least.x(), blank.lower});
            second_box_.add({first_box_.most.x(), blank.upper});
        }
        first_box_ = with_room(first_box_);
        second_box_ = with_room(second_box_);
        second_box_.least.x() = first_box_.least.x();
        second_box_.most.x() = first_box_.most.x();
        place_views();
    }

    std::string paint() {
        SvgCanvas canvas(page_width, page_height_, css_of(move_styles) + work_style,
                         "Tool path: " + picture_.title);
        canvas.rectangle(0, 0, page_width, page_height_, "page");
        canvas.text(frame_left, 34, picture_.title, "title");
        canvas.text(frame_left, 56,
                    "The way of the cutter's end, as printed in the program and followed by its check",
                    "subtitle");
        if (const std::string fault = program_.fault(); !fault.empty())
            canvas.text(frame_left, 76, "REFUSED, not written: " + fault, "refused");
        paint_view(canvas, false);
        paint_view(canvas, true);
        paint_legend(canvas);
        return canvas.finish();
    }

 private:
    const CheckedProgram& program_;
    const NcWork& work_;
    const ToolPathPicture& picture_;
    bool developed_;
    std::vector<ToolPathLine> lines_;
    Drawing first_, second_;
    DrawingBox first_box_, second_box_;
    PicturePlace first_place_, second_place_;
    double first_height_ = 0.0, second_height_ = 0.0, page_height_ = 0.0;

    [[nodiscard]] double second_top() const { return frame_top + first_height_ + between_views; }

    void place_views() {
        const Vector2d first = first_box_.size(), second = second_box_.size();
        double kx = frame_width / first.x(), ky = 0.0, left = frame_left - kx * first_box_.least.x();
        if (developed_) {
            first_height_ = 0.6 * tallest_view;
            second_height_ = 0.7 * tallest_side;
            ky = first_height_ / first.y();
        } else {
            // One scale for all; the wider frame is filled from its middle.
            ky = kx = std::min(kx, tallest_view / first.y());
            first_height_ = kx * first.y();
            second_height_ = std::clamp(kx * second.y(), least_side, tallest_side);
            left = frame_left + 0.5 * (frame_width - kx * (first_box_.least.x() + first_box_.most.x()));
        }
        const double side = second_height_ / second.y();
        first_place_ = {{left, frame_top + first_height_ + ky * first_box_.least.y()}, {kx, ky}};
        second_place_ = {{left, second_top() + second_height_ + side * second_box_.least.y()}, {kx, side}};
        page_height_ = std::max(least_page, second_top() + second_height_ + page_foot);
    }

    /// Beside the program's lines: on every turn about the cam's axis that they take.
    [[nodiscard]] std::vector<std::vector<ArcVertex>> outlines() const {
        std::vector<std::vector<ArcVertex>> result;
        const DrawingBox drawn = first_.box();
        for (const std::vector<Vector3d>& outline : work_.task.outlines) {
            View view{developed_, false};
            std::vector<ArcVertex> line;
            line.reserve(outline.size());
            for (const Vector3d& point : outline) line.push_back({view(point), 0.0});
            const double middle = 0.5 * (line.front().position.x() + line.back().position.x());
            for (int turn = -most_turns; developed_ && turn <= most_turns; ++turn) {
                const double offset = turn * units::turn;
                if (!(middle + offset > drawn.least.x() && middle + offset < drawn.most.x())) continue;
                result.push_back(line);
                for (ArcVertex& vertex : result.back()) vertex.position.x() += offset;
            }
            if (!developed_) result.push_back(std::move(line));
        }
        return result;
    }

    void paint_frame(SvgCanvas& canvas, bool side) const {
        const PicturePlace& place = side ? second_place_ : first_place_;
        const double top = side ? second_top() : frame_top, height = side ? second_height_ : first_height_;
        PlotFrame frame;
        // Of one shown unit.
        const double across = place.scale.x() * (developed_ ? degree : picture_.length.size),
                     upwards = place.scale.y() * picture_.length.size;
        frame.horizontal = {(frame_left - place.origin.x()) / across,
                            (frame_left + frame_width - place.origin.x()) / across, frame_left,
                            frame_left + frame_width};
        frame.vertical = {(place.origin.y() - top - height) / upwards, (place.origin.y() - top) / upwards,
                          top + height, top};
        frame.horizontal_ticks = labelled_ticks(frame.horizontal.lower, frame.horizontal.upper, 8);
        frame.vertical_ticks = labelled_ticks(frame.vertical.lower, frame.vertical.upper, side ? 4 : 8);
        const std::string& unit = picture_.length.name;
        if (side)
            frame.horizontal_title =
                developed_ ? "angle about the cam's axis, deg" : fmt::format("x, {} (cam frame)", unit);
        const char* const up =
            developed_ ? (side ? "from the axis" : "z along the cam's axis") : (side ? "z" : "y");
        frame.vertical_title = fmt::format("{}, {}", up, unit);
        draw_plot_frame(canvas, frame);
    }

    void paint_blank(SvgCanvas& canvas, bool side) const {
        const Blank& blank = work_.job.blank;
        const PicturePlace& place = side ? second_place_ : first_place_;
        if (!developed_ && !side) {
            const Vector2d middle = place({0.0, 0.0});
            canvas.circle(middle.x(), middle.y(), place.scale.x() * blank.radius, "blank");
            return;
        }
        const double left = developed_ ? first_box_.least.x() : -blank.radius;
        const double right = developed_ ? first_box_.most.x() : blank.radius;
        const double low = developed_ && side ? second_box_.least.y() : blank.lower;
        const double high = developed_ && side ? blank.radius : blank.upper;
        const Vector2d corner = place({left, high}), other = place({right, low});
        canvas.rectangle(corner.x(), corner.y(), other.x() - corner.x(), other.y() - corner.y(), "blank");
    }

    [[nodiscard]] const char* outline_class() const {
        return developed_ ? "flank" : work_.task.outlines.size() > 1 ? "groove" : "finished";
    }
    [[nodiscard]] const char* outline_words() const {
        return developed_                       ? "flanks, at both roller ends"
               : work_.task.outlines.size() > 1 ? "groove"
                                                : "finished cam";
    }
    /// Of a plane cam one path: what lies between two flanks is their groove.
    void paint_outlines(SvgCanvas& canvas) const {
        std::string together;
        for (const std::vector<ArcVertex>& line : outlines()) {
            const std::string data = svg_path(line, !developed_, first_place_);
            if (developed_)
                canvas.path(data, outline_class());
            else
                together += data;
        }
        if (!together.empty()) canvas.path(together, outline_class());
    }

    void paint_view(SvgCanvas& canvas, bool side) const {
        const PicturePlace& place = side ? second_place_ : first_place_;
        paint_blank(canvas, side);
        paint_frame(canvas, side);
        if (!side) paint_outlines(canvas);
        SvgCanvas moves;
        draw(moves, side ? second_ : first_, place, move_styles);
        canvas.insert(0, 0,
                      fmt::format("<g class=\"view\" data-place=\"{} {} {} {}\">\n{}</g>\n", place.origin.x(),
                                  place.origin.y(), place.scale.x(), place.scale.y(), moves.elements()));
        if (!developed_ && !side) paint_cutter(canvas);
    }

    /// Where finishing begins.
    void paint_cutter(SvgCanvas& canvas) const {
        for (const ToolPathLine& line : lines_)
            if (line.role == MoveRole::finishing && !line.points.empty()) {
                const Vector2d at = first_place_(line.points.front().head<2>());
                canvas.circle(at.x(), at.y(), 0.5 * first_place_.scale.x() * work_.task.cutter.diameter,
                              "cutter");
                return;
            }
    }

    void paint_legend(SvgCanvas& canvas) const {
        double y = frame_top + 10;
        const auto entry = [&](const char* css_class, const std::string& words) {
            canvas.line(legend_left, y - 4, legend_left + sample, y - 4, css_class);
            canvas.text(legend_left + sample + 10, y, words, "entry");
            y += legend_step;
        };
        const auto words = [&](const std::string& text, const char* css_class = "entry") {
            canvas.text(legend_left, y, text, css_class);
            y += legend_step;
        };
        std::array<int, 4> moves{};
        for (const FollowedMove& followed : program_.moves) ++moves[static_cast<std::size_t>(followed.role)];
        const auto count = [&](MoveRole role) { return moves[static_cast<std::size_t>(role)]; };
        words("Moves", "heading");
        entry("rapid", fmt::format("rapids, {}", count(MoveRole::rapid)));
        entry("way", fmt::format("down, in, out, up, {}", count(MoveRole::way)));
        if (count(MoveRole::roughing) > 0)
            entry("roughing", fmt::format("roughing, {}", count(MoveRole::roughing)));
        entry("finishing", fmt::format("finishing, {}", count(MoveRole::finishing)));
        y += 8;
        words("Work", "heading");
        entry("blank", "blank");
        entry(outline_class(), outline_words());
        if (!developed_) entry("cutter", "cutter where finishing begins");
        y += 8;
        const auto length = [&](double metres) { return picture_.length.text(metres); };
        words("Figures", "heading");
        words(fmt::format("cutter ⌀ {}", length(work_.task.cutter.diameter)));
        words(fmt::format("blank ⌀ {}", length(2.0 * work_.job.blank.radius)));
        words(fmt::format("passes {}", program_.travel.passes));
        words(fmt::format("{:.1f} min at the given feed", program_.program.seconds / units::minute));
        if (program_.travel.good()) {
            words(fmt::format("rapids at least {}", length(program_.least_distance)));
            words("off the blank");
        }
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
