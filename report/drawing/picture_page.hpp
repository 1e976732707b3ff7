// SPDX-License-Identifier: MIT
// The page that pictures of cams and mechanisms share: a frame to scale with its lengths at the rim, and a
// column beside it for what the lines mean, dimensions and figures. px; m inside the frame.
#pragma once

#include "report/drawing/drawing.hpp"
#include "report/view/shown_units.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

inline constexpr double picture_width = 1000, picture_height = 760;
inline constexpr double picture_left = 74, picture_top = 60, picture_frame_width = 660,
                        picture_frame_height = 640;
inline constexpr double picture_legend_left = 760, picture_legend_top = 76;

/// The box with a margin around it as large as the frame lets it be, in its middle.
[[nodiscard]] PicturePlace fitted_place(const DrawingBox& box);

/// A frame as wide as the page's with numbers at its rim: m or rad of one shown unit along and across.
[[nodiscard]] PlotFrame frame_around(const PicturePlace& place, double top, double height, double along,
                                     double across, int ticks_up = 8);
/// Frame, grid and lengths at the rim; `words`: what they are, "x, y in mm (cam frame)".
void draw_length_frame(SvgCanvas& canvas, const PicturePlace& place, const ShownUnit& length,
                       std::string_view words);

/// Labels within the frame, off these styles of the drawing where they find room.
[[nodiscard]] PlacedTexts labels_of(const Drawing& drawing, const PicturePlace& place,
                                    std::span<const std::string_view> avoided);

/// Entry under entry beside the frame.
class LegendColumn {
 public:
    /// entries: how many there will be, so that all find room.
    LegendColumn(SvgCanvas& canvas, int entries);

    void heading(std::string_view words);
    void sample(const char* css_class, std::string_view words);
    void value(std::string_view name, std::string_view shown);
    void words(std::string_view text, const char* css_class = "entry");

 private:
    SvgCanvas& canvas_;
    double y_ = picture_legend_top, step_ = 0.0;
};

/// The dimensions of the solution's cam.
void add_dimensions(LegendColumn& column, const Solution& solution);
/// Its figures with their cam angles; those of either side too, or of the whole cam alone.
enum class DrawnFigures { all, of_whole_cam };
void add_figures(LegendColumn& column, const Solution& solution, DrawnFigures which = DrawnFigures::all);
/// Entries that both take, without the headings.
[[nodiscard]] int figure_entries(const Solution& solution, DrawnFigures which = DrawnFigures::all);
/// That the cam is open, and why.
void add_opening(LegendColumn& column, const Solution& solution);

/// The page with its title; `style`: CSS rules besides those of the column.
[[nodiscard]] SvgCanvas new_picture(std::string_view style, std::string_view title,
                                    double height = picture_height);

}  // namespace camopt
