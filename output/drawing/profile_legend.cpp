// SPDX-License-Identifier: MIT
#include "output/drawing/profile_legend.hpp"

#include "core/units.hpp"
#include "output/drawing/picture_page.hpp"
#include "output/words/number_text.hpp"
#include "profiles/disk/disk_mechanism.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace camopt {

namespace {

using units::degree;

void add_lines(LegendColumn& column, const ProfileShape& shape, bool undercut) {
    const FormSpec& form = shape.cam.form;
    column.sample(shape.closed ? "cam" : "sector", form.is_conjugate() ? "first disk" : "cam");
    if (form.is_conjugate()) column.sample(shape.closed ? "second" : "second-sector", "second disk");
    if (form.is_grooved()) column.sample(shape.closed ? "groove" : "sector", "groove: inner, outer flank");
    if (has_roller(shape.cam.follower)) column.sample("pitch", "pitch curve (roller centre)");
    column.sample("circle", "base circle");
    if (has_roller(shape.cam.follower)) column.sample("prime", "prime circle");
    column.sample("follower", fmt::format("follower at θ = {}°", short_text(shape.start / degree)));
    column.sample("ghost", "follower every 60°");
    column.sample("mark", "contact every 30°");
    if (!shape.closed && !shape.open_because.empty()) column.sample("open", "open: nothing given");
    if (undercut) column.sample("undercut", "undercut");
}

}  // namespace

void draw_profile_legend(SvgCanvas& canvas, const ProfileShape& shape, bool undercut) {
    LegendColumn column(canvas, shape.length);
    add_lines(column, shape, undercut);
    column.heading(words_of(name_of(shape.cam.follower)));
    if (shape.cam.form.drives_both_ways())
        column.words(fmt::format("form: {}", name_of(shape.cam.form.type)));
    for (int i = 0; i < dimension_count; ++i) {
        const auto dimension = static_cast<DimensionIndex>(i);
        if (has_dimension(shape.cam.follower, dimension))
            column.value(words_of(name_of(dimension)), shape.cam[dimension]);
    }
    if (has_roller(shape.cam.follower))
        column.value("prime radius",
                     shape.cam[DimensionIndex::base_radius] + shape.cam[DimensionIndex::roller_radius]);
    for (const MechanismDimension& dimension : form_dimensions(shape.cam.follower, shape.cam.form)) {
        if (dimension.is_angle)
            column.value(words_of(dimension.name),
                         std::string_view(short_text(dimension.value.low / degree) + " deg"));
        else
            column.value(words_of(dimension.name), dimension.value.low);
    }
    if (has_flat_face(shape.cam.follower) && !is_oscillating(shape.cam.follower)) {
        if (shape.face_half_width)
            column.value("face half width", *shape.face_half_width);
        else
            column.words("face: no width given, drawn as needed");
    }
    column.words(fmt::format("turns {}", name_of(shape.cam.rotation)));
    if (!shape.closed && shape.open_because.empty())
        column.words(fmt::format("open: θ from {}° to {}°", short_text(shape.begin() / degree),
                                 short_text(shape.end() / degree)));
    if (!shape.closed && !shape.open_because.empty()) {
        column.words(fmt::format("OPEN: θ = {}° … {}°", short_text(shape.begin() / degree),
                                 short_text(shape.end() / degree)),
                     "warning");
        const std::string& why = shape.open_because;
        const std::size_t colon = why.find(": ");
        column.words(why.substr(0, colon));
        if (colon != std::string::npos) column.words("(" + why.substr(colon + 2) + ")");
    }
    if (!undercut) return;
    column.words("UNDERCUT where it is red:", "warning");
    column.words("the follower cannot move as", "warning");
    column.words("designed there.", "warning");
}

}  // namespace camopt
