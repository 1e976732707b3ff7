// SPDX-License-Identifier: MIT
#include "shop/nc/milling/milling_choice.hpp"

#include "shop/nc/requirement.hpp"

namespace camopt {

namespace {

constexpr Requirement require_milling{"milling", " mm", units::millimetre};
constexpr double usual_allowance = 3e-4;  // m

}  // namespace

const char* name_of(MillingDirection direction) {
    return direction == MillingDirection::climb ? "climb" : "conventional";
}

const char* name_of(CompensationWords words) {
    return words == CompensationWords::none ? "none" : "control";
}

void MillingChoice::validate(double cutter_diameter) const {
    if (step_over && !(*step_over > 0.0 && *step_over <= cutter_diameter))
        throw InputError(
            fmt::format("milling: the step-over of roughing must be > 0 mm and no more than the cutter's "
                        "diameter of {:g} mm, found {:g} mm",
                        cutter_diameter / units::millimetre, *step_over / units::millimetre));
    if (step_down)
        require_milling(std::isfinite(*step_down) && *step_down >= 1e-5,
                        "the step-down of roughing must be 0.01 mm or more", *step_down);
    if (finish_allowance)
        require_milling(std::isfinite(*finish_allowance) && *finish_allowance >= 0.0,
                        "the allowance for finishing must be >= 0 mm", *finish_allowance);
    if (full_depth && (step_over || step_down || finish_allowance))
        throw InputError(
            "milling: found the full depth in one pass together with a step or an allowance of roughing; "
            "allowed: either of them");
    if (lead_radius)
        require_milling(std::isfinite(*lead_radius) && *lead_radius >= 1e-4 && *lead_radius <= 1.0,
                        "the radius of the arcs in and out must be 0.1 ... 1000 mm", *lead_radius);
    if (!(ramp_angle > 0.0 && ramp_angle <= 0.5 * std::numbers::pi * (1.0 + 1e-12)))
        throw InputError(
            fmt::format("milling: the ramp into a groove must be > 0 and <= 90 deg, found {:g} deg",
                        ramp_angle / units::degree));
}

NcJob milling_job(const MillingOptions& options, const Blank& blank, double diameter, double working_length) {
    NcJob job;
    job.title = options.title;
    job.stock = options.stock;
    job.tool = fmt::format("cylindrical end mill, diameter {:.9g} mm, working length {:g} mm or more",
                           diameter / units::millimetre, working_length / units::millimetre);
    job.feed = options.feed;
    job.spindle_rpm = options.spindle_rpm;
    job.blank = blank;
    job.clearance = options.clearance;
    job.safe_distance = options.safe_distance;
    const MillingChoice& choice = options.milling;
    job.spindle = choice.spindle;
    job.tool_number = choice.tool_number;
    job.compensation_register = choice.compensation_register.value_or(choice.tool_number.value_or(1));
    return job;
}

void take_passes(NcWork& work, MillingPasses milled) {
    work.task.passes = std::move(milled.passes);
    std::ranges::move(milled.remarks, std::back_inserter(work.job.remarks));
}

int MillingChoice::layers(double depth, double cutter_diameter) const {
    const double most = step_down.value_or(0.5 * cutter_diameter);
    return std::max(1, static_cast<int>(std::ceil(depth / most - 1e-9)));
}

double MillingChoice::allowance(double room) const {
    return finish_allowance.value_or(std::clamp(room, 0.0, usual_allowance));
}

std::string words_of(const Roughing& roughing) {
    const auto part = [](const char* words, double metres) {
        return metres > 0.0 ? fmt::format(", {} {:.4g} mm", words, metres / units::millimetre) : "";
    };
    if (roughing.roughed == 0)
        return fmt::format("roughing: none, the finishing pass cuts the only layer, {:.4g} mm deep",
                           roughing.height / units::millimetre);
    return fmt::format("roughing: {} of {} layers, {:.4g} mm deep each{}{}", roughing.roughed,
                       roughing.layers, roughing.height / units::millimetre,
                       part("step-over", roughing.step_over), part("for finishing", roughing.allowance));
}

std::string slot_words(double depth, double cutter_diameter) {
    return fmt::format("cuts a slot {:.4g} mm deep, {:.2g} times the cutter's diameter",
                       depth / units::millimetre, depth / cutter_diameter);
}

}  // namespace camopt
