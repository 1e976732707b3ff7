// SPDX-License-Identifier: MIT
#include "output/nc/milling/milling_choice.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/nc/requirement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace camopt {

namespace {

constexpr Requirement require_milling{"milling", " mm", units::millimetre};

}  // namespace

void MillingChoice::validate(double cutter_diameter) const {
    if (step_over && !(*step_over > 0.0 && *step_over <= cutter_diameter))
        throw InputError(
            fmt::format("milling: the step-over of roughing must be > 0 mm and no more than the cutter's "
                        "diameter of {:g} "
                        "mm, found {:g} mm",
                        cutter_diameter / units::millimetre, *step_over / units::millimetre));
    if (step_down)
        require_milling(std::isfinite(*step_down) && *step_down >= 1e-5,
                        "the step-down of roughing must be 0.01 mm or more", *step_down);
    require_milling(std::isfinite(finish_allowance) && finish_allowance >= 0.0,
                    "the allowance for finishing must be >= 0 mm", finish_allowance);
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
    job.tool = fmt::format("cylindrical end mill, diameter {:g} mm, working length {:g} mm or more",
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

std::string roughing_words(const MillingChoice& choice, double step_over, int layers) {
    return fmt::format(
        "roughing: {} layer{} over the whole depth, step-over {:.4g} mm, leaves {:g} mm for finishing",
        layers, layers == 1 ? "" : "s", step_over / units::millimetre,
        choice.finish_allowance / units::millimetre);
}

}  // namespace camopt
