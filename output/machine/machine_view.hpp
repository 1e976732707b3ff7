// SPDX-License-Identifier: MIT
// A machine's result as people see it: the timing diagram of all axes and the clearances over one revolution
// of the master as a picture, the same as a page with one moving cursor, and a report in Markdown for the
// electrical and the mechanical department.
#pragma once

#include "output/json/result_json.hpp"
#include "output/view/tables.hpp"
#include "output/view/view.hpp"
#include "studies/machine/machine.hpp"

namespace camopt {

/// Displacements of all axes, then what every clearance sums up, by the angle of the master. Empty where
/// nothing is delivered.
struct MachineView {
    explicit MachineView(const MachineSolution& shown);

    const MachineSolution& solution;
    std::vector<double> angles;  ///< deg, 0 to 360
    std::vector<Curve> curves;   ///< groups "axes" and "clearances"
    std::vector<ViewTable> tables;
    std::string headline;
    std::vector<std::string> sentences;
};

/// timing.svg. Throws InputError where nothing is delivered.
[[nodiscard]] std::string timing_svg(const MachineView& view);

/// report.md.
[[nodiscard]] std::string machine_markdown(const MachineView& view, const RunOrigin& origin);

}  // namespace camopt
