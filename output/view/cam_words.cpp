// SPDX-License-Identifier: MIT
#include "output/view/cam_words.hpp"

#include "output/view/key_words.hpp"
#include "output/view/shown_units.hpp"
#include "scene/cam_mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr double no_radius = 1e9;  // m: what is straighter than this is straight

/// Of the base circle and the roller on it, in mm; none where one of them is not known.
std::optional<double> prime_radius(const std::vector<DimensionValue>& dimensions) {
    double sum = 0.0;
    for (const DimensionIndex which : {DimensionIndex::base_radius, DimensionIndex::roller_radius}) {
        const auto found = std::ranges::find(dimensions, name_of(which), &DimensionValue::name);
        if (found == dimensions.end()) continue;
        if (!found->shown) return {};
        sum += *found->shown;
    }
    return sum;
}

/// What is straighter than any radius is none.
std::optional<CamExtreme> drawn_radius(const std::optional<CamExtreme>& radius) {
    if (radius && std::abs(radius->value) < no_radius) return radius;
    return {};
}

/// Collects figures of one solution.
class Figures {
 public:
    explicit Figures(const Solution& solution) : solution_(solution) {}

    void add(std::string name, const std::optional<CamExtreme>& extreme, const ShownUnit& unit) {
        if (!extreme) return;
        // Of a cusp the pressure is infinite.
        const bool untouched = std::isinf(extreme->value) && solution_.cam->summary.no_contact;
        std::string value = untouched ? no_contact_words : unit.text(extreme->value);
        all_.push_back({std::move(name), std::move(value), degrees_at(solution_, extreme->at)});
    }
    [[nodiscard]] std::vector<CamFigure> take() { return std::move(all_); }

 private:
    const Solution& solution_;
    std::vector<CamFigure> all_;
};

void add_geometry(Figures& figures, const CamReport& cam, const ShownUnits& shown) {
    const CamSummary& summary = cam.summary;
    figures.add("largest pressure angle", summary.pressure_angle, shown.angle);
    if (summary.return_pressure_angle && summary.return_pressure_angle->value > 0.0) {
        figures.add("on the rise", summary.rise_pressure_angle, shown.angle);
        figures.add("on the return", summary.return_pressure_angle, shown.angle);
    }
    figures.add("least convex radius of the cam", convex_radius(summary), shown.length);
    figures.add("least concave radius of the cam", summary.concave_radius, shown.length);
    figures.add("largest contact offset on the face", summary.contact_offset, shown.length);
    if (!cam.cam.formulas->undercut_words().empty())
        figures.add("least regularity (0: undercut)", summary.regularity, ShownUnit{});
}

/// Each side by itself, where there are two; what is common stands above.
void add_sides(Figures& figures, const CamReport& cam, const ShownUnits& shown) {
    const bool one_normal = !cam.summary.sides.empty() && cam.summary.sides.front().pressure_angle.value ==
                                                              cam.summary.sides.back().pressure_angle.value;
    for (const SideSummary& side : cam.summary.sides) {
        const auto name = [&](const char* what) { return fmt::format("{}: {}", side.name, what); };
        if (!one_normal) figures.add(name("largest pressure angle"), side.pressure_angle, shown.angle);
        figures.add(name("least convex radius"), drawn_radius(side.convex_radius), shown.length);
        figures.add(name("least concave radius"), drawn_radius(side.concave_radius), shown.length);
        figures.add(name("least regularity"), side.regularity, ShownUnit{});
        figures.add(name("largest force along the normal"), side.normal_force, shown.force);
        figures.add(name("largest Hertz pressure"), side.hertz_pressure, shown.pressure);
    }
}

void add_forces(Figures& figures, const CamReport& cam, const ShownUnits& shown) {
    if (!cam.summary.forces) return;
    const ForceSummary& forces = *cam.summary.forces;
    const bool swings = cam.cam.formulas->swings();
    const char* const what = swings ? "moment on the follower" : "force on the follower";
    figures.add(fmt::format("least {}", what), forces.least_force, shown.load);
    figures.add(fmt::format("largest {}", what), forces.largest_force, shown.load);
    figures.add("largest camshaft torque", forces.torque, shown.torque);
    figures.add("largest force along the normal", forces.normal_force, shown.force);
    figures.add("largest Hertz pressure", forces.hertz_pressure, shown.pressure);
}

}  // namespace

std::vector<DimensionValue> cam_dimensions(const Solution& solution) {
    const std::optional<CamSpec>& cam = solution.scene.cam;
    std::vector<DimensionValue> all;
    if (!cam) return all;
    for (std::size_t i = 0; i < cam->dimensions.size(); ++i) {
        const CamDimension& dimension = cam->dimensions[i];
        if (dimension.value.key.empty()) continue;  // this variant has no such dimension
        std::optional<double> number;
        if (!dimension.value.is_variable()) number = dimension.value.low;
        if (solution.cam) number = solution.cam->cam.dimensions[i];
        if (number) *number /= dimension.is_angle ? degree : millimetre;
        all.push_back({dimension.name, dimension.is_angle, number});
    }
    if (cam->formulas()->is_direct()) all.push_back({"prime_radius", false, prime_radius(all)});
    const ShownUnits shown = shown_units(solution.scene);
    for (DimensionValue& one : all)
        one.text = !one.shown     ? "free"
                   : one.is_angle ? shown.angle.text(*one.shown * degree)
                                  : shown.length.text(*one.shown * millimetre);
    return all;
}

std::string dimensions_text(const Solution& solution) {
    std::string text;
    for (const DimensionValue& dimension : cam_dimensions(solution))
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", words_of(dimension.name), dimension.text);
    return text;
}

std::string cam_text(const CamSpec& cam) {
    if (const auto formulas = cam.formulas(); formulas->is_direct()) {
        const std::string form = formulas->form_words();
        return fmt::format("{}{}{}, the cam turning {}", words_of(formulas->follower_name()),
                           form.empty() ? "" : " ", form, name_of(cam.rotation));
    }
    const auto follower = cam.choices.find("follower");
    const auto linkage = cam.choices.find("linkage");
    std::string parts = linkage == cam.choices.end() ? std::string{} : words_of(linkage->second);
    std::ranges::replace(parts, ' ', '-');
    if (follower != cam.choices.end()) parts = "a " + follower->second + " follower";
    return fmt::format("{} cam{}, turning {}", words_of(cam.type), parts.empty() ? "" : " with " + parts,
                       name_of(cam.rotation));
}

std::optional<CamExtreme> convex_radius(const CamSummary& summary) {
    return drawn_radius(summary.convex_radius);
}

std::vector<CamFigure> cam_figures(const Solution& solution) {
    Figures figures(solution);
    const ShownUnits shown = shown_units(solution.scene);
    add_geometry(figures, *solution.cam, shown);
    add_forces(figures, *solution.cam, shown);
    add_sides(figures, *solution.cam, shown);
    return figures.take();
}

TextTable cam_table(const Solution& solution, std::vector<TextTable::Column> columns) {
    TextTable table{std::move(columns), {}};
    for (const CamFigure& figure : cam_figures(solution))
        table.rows.push_back({figure.name, figure.value, figure.degrees});
    return table;
}

}  // namespace camopt
