// SPDX-License-Identifier: MIT
#include "report/view/cam_words.hpp"

#include "core/text/list_text.hpp"
#include "report/view/cam_presentation.hpp"
#include "report/view/key_words.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

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

using Units = ShownUnits;

constexpr FigureRow<CamSummary> cam_rows[] = {
    {"pressure_angle_deg", figure_words::pressure_angle, &Units::angle,
     [](const CamSummary& cam) -> std::optional<CamExtreme> { return cam.pressure_angle; }},
    {.key = "rise_pressure_angle_deg",
     .name = "on the rise",
     .unit = &Units::angle,
     .of = [](const CamSummary& cam) { return cam.rise_pressure_angle; },
     .of_direct_cams = true},
    {.key = "return_pressure_angle_deg",
     .name = "on the return",
     .unit = &Units::angle,
     .of = [](const CamSummary& cam) { return cam.return_pressure_angle; },
     .of_direct_cams = true},
    {.key = "rest_pressure_angle_deg",
     .name = nullptr,
     .unit = &Units::angle,
     .of = [](const CamSummary& cam) { return cam.rest_pressure_angle; },
     .of_direct_cams = true},
    {"convex_radius_mm", figure_words::convex_radius, &Units::length,
     [](const CamSummary& cam) { return drawn_radius(cam.convex_radius); }},
    {"concave_radius_mm", figure_words::concave_radius, &Units::length,
     [](const CamSummary& cam) { return cam.concave_radius; }},
    {.key = "contact_offset_mm",
     .name = "largest contact offset on the face",
     .unit = &Units::length,
     .of = [](const CamSummary& cam) { return cam.contact_offset; },
     .only_where_found = true},
    {"regularity", "least regularity (0: undercut)", &Units::number,
     [](const CamSummary& cam) -> std::optional<CamExtreme> { return cam.regularity; }},
};

constexpr FigureRow<ForceSummary> force_rows[] = {
    {"least_force_n", "least force on the follower", &Units::load,
     [](const ForceSummary& forces) -> std::optional<CamExtreme> { return forces.least_force; },
     "least_moment_nm", "least moment on the follower"},
    {"largest_force_n", "largest force on the follower", &Units::load,
     [](const ForceSummary& forces) -> std::optional<CamExtreme> { return forces.largest_force; },
     "largest_moment_nm", "largest moment on the follower"},
    {.key = "lift_off_rpm",
     .name = "the follower lifts off above",
     .unit = &Units::speed,
     .of = [](const ForceSummary& forces) { return forces.lift_off_speed; }},
    {"torque_nm", figure_words::torque, &Units::torque,
     [](const ForceSummary& forces) -> std::optional<CamExtreme> { return forces.torque; }},
    {.key = "driving_force_n",
     .name = "largest force that drives the plate",
     .unit = &Units::force,
     .of = [](const ForceSummary& forces) { return forces.driving_force; },
     .only_where_found = true},
    {"normal_force_n", "largest force along the normal", &Units::force,
     [](const ForceSummary& forces) { return forces.normal_force; }},
    {"hertz_pressure_mpa", figure_words::hertz_pressure, &Units::pressure,
     [](const ForceSummary& forces) { return forces.hertz_pressure; }},
};

constexpr FigureRow<SideSummary> side_rows[] = {
    {"pressure_angle_deg", figure_words::pressure_angle, &Units::angle,
     [](const SideSummary& side) -> std::optional<CamExtreme> { return side.pressure_angle; }},
    {"convex_radius_mm", "least convex radius", &Units::length,
     [](const SideSummary& side) { return drawn_radius(side.convex_radius); }},
    {"concave_radius_mm", "least concave radius", &Units::length,
     [](const SideSummary& side) { return drawn_radius(side.concave_radius); }},
    {"regularity", "least regularity", &Units::number,
     [](const SideSummary& side) -> std::optional<CamExtreme> { return side.regularity; }},
    {"normal_force_n", "largest force along the normal", &Units::force,
     [](const SideSummary& side) { return side.normal_force; }},
    {"hertz_pressure_mpa", figure_words::hertz_pressure, &Units::pressure,
     [](const SideSummary& side) { return side.hertz_pressure; }},
};

/// Rise and return are told apart where there are both.
bool is_told(const FigureRow<CamSummary>& row, const CamReport& cam) {
    if (row.name == nullptr) return false;
    const std::optional<CamExtreme>& back = cam.summary.return_pressure_angle;
    if (row.of_direct_cams) return back && back->value > 0.0;
    return row.unit != &Units::number || cam.cam.formulas->contact() != ContactKind::edge;
}

/// Both sides lean equally: what is common stands above.
bool leans_alike(const CamSummary& summary) {
    return summary.sides.front().pressure_angle.value == summary.sides.back().pressure_angle.value;
}

void add_chosen_spring(std::vector<DimensionValue>& all, const Solution& solution, const ShownUnits& units) {
    const std::optional<ForceSpec>& forces = solution.scene.forces;
    if (!forces) return;
    const ShownUnits files = file_units(solution.scene);
    const auto add = [&](const char* name, double number, bool is_range, const ShownUnit& file,
                         const ShownUnit& people) {
        if (!is_range) return;
        const bool found = solution.motion != nullptr;
        all.push_back({name, file, found ? std::optional(file.of(number)) : std::nullopt,
                       found ? people.text(number) : "free"});
    };
    add("preload", forces->preload, forces->preload_range.has_value(), files.load, units.load);
    add("spring_rate", forces->spring_rate, forces->spring_rate_range.has_value(), files.spring_rate,
        units.spring_rate);
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
        const ShownUnit unit = dimension.is_angle ? degrees_shown : millimetres_shown;
        all.push_back({dimension.name, unit, number ? std::optional(unit.of(*number)) : number});
    }
    if (cam->formulas()->base_radius_index() >= 0)
        all.push_back({"prime_radius", millimetres_shown, prime_radius(all)});
    const ShownUnits units = shown_units(solution.scene);
    for (DimensionValue& one : all) {
        const ShownUnit& people = one.unit.suffix == degrees_shown.suffix ? degrees_shown : units.length;
        one.text = one.shown ? people.text(*one.shown * one.unit.size) : "free";
    }
    add_chosen_spring(all, solution, units);
    return all;
}

std::string cam_text(const CamSpec& cam) {
    const auto formulas = cam.formulas();
    if (const DirectCam* const direct = formulas->direct()) {
        const DirectCamDrawing drawing = direct->drawing(cam.middle());
        if (const PlaneMechanism* const plane = formulas->plane(); plane != nullptr && plane->is_plate())
            return words_of(drawing.follower) + " on a plate that slides";
        const std::string form = form_words(drawing);
        return fmt::format("{}{}{}, the cam turning {}", words_of(drawing.follower), form.empty() ? "" : " ",
                           form, name_of(cam.rotation));
    }
    const auto follower = cam.choices.find("follower");
    const auto linkage = cam.choices.find("linkage");
    std::string parts = linkage == cam.choices.end() ? std::string{} : words_of(linkage->second);
    std::ranges::replace(parts, ' ', '-');
    if (follower != cam.choices.end()) parts = "a " + follower->second + " follower";
    return fmt::format("{} cam{}, turning {}", words_of(cam.type), parts.empty() ? "" : " with " + parts,
                       name_of(cam.rotation));
}

std::string angles_words(double begin, double end, int digits) {
    return begin == end
               ? fmt::format("at {} deg", short_text(begin, digits))
               : fmt::format("from {} to {} deg", short_text(begin, digits), short_text(end, digits));
}

std::string stretch_words(const MotionSpec& motion, double begin, double end, int digits) {
    return angles_words(degrees_shown.of(motion.master_angle(begin)),
                        degrees_shown.of(motion.master_angle(end)), digits);
}

std::string stroke_words(const MotionSpec& motion, std::size_t index, double begin, double end) {
    return fmt::format("stroke {}, {}", index + 1, stretch_words(motion, begin, end));
}

bool is_loaded(const CamSummary& summary) {
    const std::optional<ForceSummary>& forces = summary.forces;
    return forces && (forces->largest_force.value != 0.0 || forces->least_force.value != 0.0);
}

std::optional<CamExtreme> convex_radius(const CamSummary& summary) {
    return drawn_radius(summary.convex_radius);
}

std::span<const FigureRow<CamSummary>> cam_figure_rows() {
    return cam_rows;
}

std::span<const FigureRow<ForceSummary>> force_figure_rows() {
    return force_rows;
}

std::span<const FigureRow<SideSummary>> side_figure_rows() {
    return side_rows;
}

std::vector<CamFigure> cam_figures(const Solution& solution) {
    const CamSummary& summary = solution.cam->summary;
    const ShownUnits shown = shown_units(solution.scene);
    std::vector<CamFigure> all;
    const auto add = [&](const auto& row, const auto& of, const std::string& before = {}) {
        const std::optional<CamExtreme> extreme = row.of(of);
        if (!extreme) return;
        const bool moment = row.name_of_moment != nullptr && solution.scene.motion.lift_is_angle;
        // Of a cusp the pressure is infinite.
        const bool untouched = std::isinf(extreme->value) && summary.no_contact;
        all.push_back({before + (moment ? row.name_of_moment : row.name),
                       untouched ? no_contact_words : (shown.*row.unit).text(extreme->value),
                       degrees_at(solution, extreme->at)});
    };
    for (const auto& row : cam_rows)
        if (is_told(row, *solution.cam)) add(row, summary);
    if (summary.forces)
        for (const auto& row : force_rows) add(row, *summary.forces);
    for (const SideSummary& side : summary.sides)
        for (const auto& row : side_rows)
            if (&row != &side_rows[0] || !leans_alike(summary)) add(row, side, side.name + ": ");
    return all;
}

}  // namespace camopt
