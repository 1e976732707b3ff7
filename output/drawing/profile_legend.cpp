// SPDX-License-Identifier: MIT
#include "output/drawing/profile_legend.hpp"

#include "core/units.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace camopt {

namespace {

using units::degree;

constexpr double legend_line_height = 21, swatch = 30, indent = 40;  // px

/// Writes entry under entry.
class Column {
 public:
    Column(SvgCanvas& canvas, double left, double top, ShownUnit length)
        : canvas_(canvas), left_(left), y_(top), length_(std::move(length)) {}

    void heading(std::string_view words) {
        y_ += 8;
        canvas_.text(left_, y_, words, "heading");
        y_ += legend_line_height;
    }
    void sample(const char* css_class, std::string_view words) {
        canvas_.line(left_, y_ - 4, left_ + swatch, y_ - 4, css_class);
        canvas_.text(left_ + indent, y_, words, "entry");
        y_ += legend_line_height;
    }
    void value(std::string_view name, double length) {
        canvas_.text(left_, y_, name, "entry");
        canvas_.text(left_ + 215, y_, length_.text(length), "entry number");
        y_ += legend_line_height;
    }
    void words(std::string_view text, const char* css_class = "entry") {
        canvas_.text(left_, y_, text, css_class);
        y_ += legend_line_height;
    }

 private:
    SvgCanvas& canvas_;
    double left_, y_;
    ShownUnit length_;
};

void add_lines(Column& column, const ProfileShape& shape, bool undercut) {
    column.sample(shape.closed ? "cam" : "sector", "cam");
    if (has_roller(shape.cam.follower)) column.sample("pitch", "pitch curve (roller centre)");
    column.sample("circle", "base circle");
    if (has_roller(shape.cam.follower)) column.sample("prime", "prime circle");
    column.sample("follower", fmt::format("follower at θ = {}°", short_text(shape.begin() / degree)));
    column.sample("ghost", "follower every 60°");
    column.sample("mark", "contact every 30°");
    if (undercut) column.sample("undercut", "undercut");
}

}  // namespace

std::string_view profile_legend_style() {
    return ".heading{font-size:13px;font-weight:600}.number{text-anchor:end}";
}

void draw_profile_legend(SvgCanvas& canvas, const ProfileShape& shape, const ProfileLegend& legend) {
    Column column(canvas, legend.left, legend.top, shape.length);
    add_lines(column, shape, legend.undercut);
    column.heading(words_of(name_of(shape.cam.follower)));
    for (int i = 0; i < dimension_count; ++i) {
        const auto dimension = static_cast<DimensionIndex>(i);
        if (has_dimension(shape.cam.follower, dimension))
            column.value(words_of(name_of(dimension)), shape.cam[dimension]);
    }
    if (has_roller(shape.cam.follower))
        column.value("prime radius",
                     shape.cam[DimensionIndex::base_radius] + shape.cam[DimensionIndex::roller_radius]);
    if (has_flat_face(shape.cam.follower) && !is_oscillating(shape.cam.follower)) {
        if (shape.face_half_width)
            column.value("face half width", *shape.face_half_width);
        else
            column.words("face: no width given, drawn as needed");
    }
    column.words(fmt::format("turns {}", name_of(shape.cam.rotation)));
    if (!shape.closed)
        column.words(fmt::format("open: θ from {}° to {}°", short_text(shape.begin() / degree),
                                 short_text(shape.end() / degree)));
    if (!legend.undercut) return;
    column.words("UNDERCUT where it is red:", "warning");
    column.words("the follower cannot move as", "warning");
    column.words("designed there.", "warning");
}

}  // namespace camopt
