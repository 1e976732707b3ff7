// SPDX-License-Identifier: MIT
// How a cam is milled: roughing, direction, ways in and out, words for spindle, tool and compensation.
//
// Lengths m, angles rad.
#pragma once

#include "output/nc/nc_program.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

/// Climb: a tooth enters where the chip is thickest, against the tool's way; conventional: where it is
/// thinnest.
enum class MillingDirection { climb, conventional };

/// none: the program is the way of the cutter's centre. control: it is the cam's contour, G41 or G42 with D.
enum class CompensationWords { none, control };

struct MillingChoice {
    std::optional<double> step_over =
        {};  ///< > 0, no more than the cutter's diameter: between two roughing passes
    std::optional<double> step_down =
        {};                          ///< > 0: between two layers of roughing. Either one asks for roughing
    double finish_allowance = 3e-4;  ///< >= 0: what roughing leaves, beside the stock, for finishing
    std::optional<MillingDirection> direction = {};  ///< none: climb where a pass cuts one flank
    SpindleSense spindle = SpindleSense::clockwise;
    std::optional<int> tool_number = {};                       ///< none: no tool call
    CompensationWords compensation = CompensationWords::none;  ///< plane cams
    std::optional<int> compensation_register = {};             ///< D; none: the tool's number, or 1
    std::optional<double> lead_radius = {};  ///< > 0: of the arcs in and out; none: the cutter's radius
    double ramp_angle =
        0.0523598775598299;  ///< in (0, 90 deg]: how steep the cutter goes down along a groove

    [[nodiscard]] bool roughs() const { return step_over || step_down; }
    [[nodiscard]] bool climbs() const {
        return direction.value_or(MillingDirection::climb) == MillingDirection::climb;
    }
    /// Throws InputError naming what was found and what is allowed.
    void validate(double cutter_diameter) const;
};

/// The job's words for spindle, tool and register.
void set_words(NcJob& job, const MillingChoice& choice);

/// For the program's header: roughing, one line; empty where there is none.
[[nodiscard]] std::string roughing_words(const MillingChoice& choice, double step_over, int layers);

}  // namespace camopt
