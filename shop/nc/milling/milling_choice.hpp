// SPDX-License-Identifier: MIT
// How a cam is milled: roughing, direction, ways in and out, words for spindle, tool and compensation.
//
// Lengths m, angles rad.
#pragma once

#include "shop/nc/checked_program.hpp"

namespace camopt {

/// Climb: a tooth enters where the chip is thickest, against the tool's way; conventional: where it is
/// thinnest.
enum class MillingDirection { climb, conventional };

/// none: the program is the path of the cutter's centre. control: it is the cam's contour, G41 or G42 with D.
enum class CompensationWords { none, control };

[[nodiscard]] const char* name_of(MillingDirection direction);  ///< "climb"
[[nodiscard]] const char* name_of(CompensationWords words);     ///< "control"

struct MillingChoice {
    /// m, > 0, no more than the cutter's diameter: between two roughing passes; none: half the diameter.
    std::optional<double> step_over = {};
    std::optional<double> step_down = {};  ///< m, > 0: greatest height of a layer; none: half the diameter
    /// m, >= 0: what roughing leaves, beside the stock, for finishing; none: 0.3 mm, or what there is room
    /// for.
    std::optional<double> finish_allowance = {};
    bool full_depth = false;  ///< no roughing: the finishing pass cuts into the full blank; with a warning
    std::optional<MillingDirection> direction = {};  ///< none: climb where a pass cuts one flank
    SpindleSense spindle = SpindleSense::clockwise;
    std::optional<int> tool_number = {};                       ///< none: no tool call
    CompensationWords compensation = CompensationWords::none;  ///< plane cams
    std::optional<int> compensation_register = {};             ///< D; none: the tool's number, or 1
    std::optional<double> lead_radius = {};  ///< > 0: of the arcs in and out; none: the cutter's radius
    double ramp_angle =
        0.0523598775598299;  ///< in (0, 90 deg]: how steep the cutter goes down along a groove

    /// Layers of equal height, no higher than the step-down, over `depth`.
    [[nodiscard]] int layers(double depth, double cutter_diameter) const;
    [[nodiscard]] double step_over_of(double cutter_diameter) const {
        return step_over.value_or(0.5 * cutter_diameter);
    }
    /// room: the most that can be left.
    [[nodiscard]] double allowance(double room) const;
    /// How far chords of roughing may leave its path, which stands off by as much more.
    [[nodiscard]] static double coarse_chords(double allowance) { return std::min(0.1 * allowance, 2e-5); }
    [[nodiscard]] bool climbs() const {
        return direction.value_or(MillingDirection::climb) == MillingDirection::climb;
    }
    /// Throws InputError naming what was found and what is allowed.
    void validate(double cutter_diameter) const;
};

/// What programs that mill cams of any kind may be asked for.
struct MillingOptions {
    double stock = 0.0;             ///< m, left on the cam
    double feed = 5e-3;             ///< m/s
    double spindle_rpm = 0.0;       ///< rev/min; 0: no word
    double chord_tolerance = 1e-6;  ///< m
    double gouge_tolerance = 1e-5;  ///< m: checked_program.hpp
    BlankChoice blank;              ///< what is left out: the cam's extent and the allowance
    double clearance = 0.02;        ///< m: of the clearance plane above the blank
    double safe_distance = 2e-3;    ///< m: rapids keep so far from the blank
    MillingChoice milling;
    std::string title = "cam";
};

/// The program's words, of an end mill of that diameter and working length (m); no passes yet.
[[nodiscard]] NcJob milling_job(const MillingOptions& options, const Blank& blank, double diameter,
                                double working_length);

/// The passes that mill a cam.
struct MillingPasses {
    std::vector<CuttingPass> passes;   ///< roughing first
    std::vector<std::string> remarks;  ///< for the program's header
};

/// The passes and their remarks, behind those of the job.
void take_passes(NcWork& work, MillingPasses milled);

/// For the program's header, one line; m.
struct Roughing {
    int layers = 1, roughed = 1;  ///< a finishing pass that cuts a slot is the last layer
    double height = 0.0, step_over = 0.0, allowance = 0.0;  ///< height: of a layer
};
[[nodiscard]] std::string words_of(const Roughing& roughing);

/// Of a cut as wide as the cutter: "cuts a slot 23 mm deep, 1.9 times the cutter's diameter".
[[nodiscard]] std::string slot_words(double depth, double cutter_diameter);

}  // namespace camopt
