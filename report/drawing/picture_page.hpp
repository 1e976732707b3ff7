// SPDX-License-Identifier: MIT
// The page that pictures of cams and mechanisms share: a frame to scale with its lengths at the rim, and a
// column beside it for what the lines mean, dimensions and figures. px; m inside the frame.
#pragma once

#include "report/chart/svg_canvas.hpp"
#include "report/drawing/profile_shape.hpp"

namespace camopt {

// Drawing in the cam frame: metres in, px out, the same scale both ways.
struct ProfileCanvas {
    SvgCanvas& canvas;
    Eigen::Vector2d origin;  ///< px of the cam's centre
    double scale = 1.0;      ///< px per m

    [[nodiscard]] Eigen::Vector2d place(const Eigen::Vector2d& point) const {
        return {origin.x() + scale * point.x(), origin.y() - scale * point.y()};
    }
    /// Metres of so many px, for marks whose size does not depend on the cam.
    [[nodiscard]] double px(double count) const { return count / scale; }

    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view css_class) const;
    void circle(const Eigen::Vector2d& center, double radius, std::string_view css_class) const;
    void polyline(std::span<const Eigen::Vector2d> points, bool closed, std::string_view css_class) const;
    /// The words' middle at the point.
    void text(const Eigen::Vector2d& middle, std::string_view words, std::string_view css_class) const;
};

// The column beside the drawing of a cam: what the lines mean, the dimensions, and what is wrong.
void draw_profile_legend(SvgCanvas& canvas, const ProfileShape& shape, bool undercut);

inline constexpr double picture_width = 1000, picture_height = 760;
inline constexpr double picture_left = 74, picture_top = 60, picture_frame_width = 660,
                        picture_frame_height = 640;
inline constexpr double picture_legend_left = 760, picture_legend_top = 76;

/// What a picture has to show, m.
struct PictureBox {
    Eigen::Vector2d least = Eigen::Vector2d::Constant(1e300), most = Eigen::Vector2d::Constant(-1e300);

    void add(const Eigen::Vector2d& point) {
        least = least.cwiseMin(point);
        most = most.cwiseMax(point);
    }
    /// A square about a point.
    void add(const Eigen::Vector2d& middle, double half) {
        add(middle - Eigen::Vector2d::Constant(half));
        add(middle + Eigen::Vector2d::Constant(half));
    }
    /// With a margin around it.
    [[nodiscard]] PictureBox with_room() const;
};

/// The box as large as the frame lets it be, in its middle.
[[nodiscard]] ProfileCanvas fitted_canvas(SvgCanvas& canvas, const PictureBox& box);

/// Frame, grid and lengths at the rim; `words`: what they are, "x, y in mm (cam frame)".
void draw_length_frame(const ProfileCanvas& drawing, const ShownUnit& length, std::string_view words);

/// Entry under entry beside the frame.
class LegendColumn {
 public:
    /// entries: how many there will be, so that all find room.
    LegendColumn(SvgCanvas& canvas, ShownUnit length, int entries = 0);

    void heading(std::string_view words);
    void sample(const char* css_class, std::string_view words);
    void value(std::string_view name, double length) { value(name, std::string_view(length_.text(length))); }
    void value(std::string_view name, std::string_view shown);
    void words(std::string_view text, const char* css_class = "entry");

 private:
    SvgCanvas& canvas_;
    double y_ = picture_legend_top, step_ = 0.0;
    ShownUnit length_;
};

/// The dimensions of the solution's cam, `between`, and its figures with their cam angles.
void add_figures(LegendColumn& column, const Solution& solution, std::string_view between = {});
/// Entries that they take, without the headings.
[[nodiscard]] int figure_entries(const Solution& solution);
/// That the cam is open, and why.
void add_opening(LegendColumn& column, const Solution& solution);

/// The page with its title; `style`: CSS rules besides those of the column.
[[nodiscard]] SvgCanvas new_picture(std::string_view style, std::string_view title);

/// A cross at the centre, and an arrow of this radius in the sense in which the cam turns.
void draw_rotation(const ProfileCanvas& drawing, const Eigen::Vector2d& center, double radius,
                   Rotation rotation);

}  // namespace camopt
