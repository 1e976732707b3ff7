// SPDX-License-Identifier: MIT
// The way of a program's cutter as a picture: rapids, ways in and out, roughing, finishing, with the outline
// of the blank and of the finished cam.
//
// Drawn are the moves that the verifier followed (CheckedProgram::moves), of the cutter's centre at its end,
// in the cam frame, and nothing else: what is not in the printed text is not in the picture.
//   three axes      seen along the tool, x and y to one scale; below it x and z
//   rotary axes     developed: the angle about the cam's axis and z; below it that angle and the distance
//   from the axis
// Lines come group by group, <g class="view" data-place="x0 y0 kx ky">: the px of a point (a, b) of that view
// are (x0 + kx a, y0 − ky b), a and b in m, angles in rad. Nothing throws.
#pragma once

#include "report/view/shown_units.hpp"
#include "shop/nc/checked_program.hpp"

namespace camopt {

struct ToolPathLine {
    MoveRole role = MoveRole::rapid;
    int pass = 0;
    std::vector<Eigen::Vector3d>
        points;  ///< of the tip, cam frame, m: ends of moves, and between them where they bend
};

/// Consecutive moves of one role and pass are one line. The first moves, before every axis has a value, are
/// left out.
[[nodiscard]] std::vector<ToolPathLine> tool_path_lines(const CheckedProgram& program,
                                                        const Machine& machine);

struct ToolPathPicture {
    std::string title;
    ShownUnit length;
};

/// work: what the program was made of, for blank, cutter and outlines.
[[nodiscard]] std::string tool_path_svg(const CheckedProgram& program, const NcWork& work,
                                        const Machine& machine, const ToolPathPicture& picture);

}  // namespace camopt
