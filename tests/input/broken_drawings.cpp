// SPDX-License-Identifier: MIT
// Bore, keyway and thickness of a disk cam.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_drawings_parts {

/// Eight lines: [drawing] of a cam whose base circle has a radius of 40 mm.
const std::string disk_drawing =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 10\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_knife\"\n"
    "base_radius_mm = 40\n"
    "[drawing]\n";

const std::string grooved_drawing =
    "objective.jerk = 1\n"
    "motion.type = \"RR\"\n"
    "motion.lift_mm = 10\n"
    "[cam]\n"
    "type = \"disk\"\n"
    "follower = \"translating_roller\"\n"
    "form = \"grooved\"\n"
    "roller_radius_mm = 8\n"
    "base_radius_mm = 40\n"
    "[drawing]\n";

}  // namespace broken_drawings_parts

std::vector<BrokenScene> broken_drawings() {
    using namespace broken_drawings_parts;
    return {
        {"drawing_without_cam", "objective.jerk = 1\nmotion.type = \"DRD\"\n[drawing]\n",
         "s.toml:3:1: drawing: found a drawing without a base circle; allowed: only with a cam that has a "
         "base "
         "radius"},
        {"bore_not_positive", disk_drawing + "bore_mm = 0\n",
         "s.toml:9:11: drawing.bore_mm: found 0; allowed: a number > 0"},
        {"bore_beyond_the_cam", disk_drawing + "bore_mm = 80\n",
         "s.toml:9:11: drawing.bore_mm: found a bore that lies 40 mm from the centre; allowed: less than 40 "
         "mm, "
         "the radius of the base circle"},
        {"keyway_beyond_the_cam", disk_drawing + "bore_mm = 70\nkeyway = { width_mm = 18, depth_mm = 5 }\n",
         "s.toml:10:10: drawing.keyway: found a keyway that reaches 41 mm from the centre; allowed: less "
         "than "
         "40 mm, the radius of the base circle"},
        {"groove_depth_without_a_groove", disk_drawing + "groove_depth_mm = 8\n",
         "s.toml:9:19: drawing.groove_depth_mm: found a depth without a groove; allowed: only with cam.form "
         "= \"grooved\""},
        {"groove_as_deep_as_the_cam", grooved_drawing + "thickness_mm = 8\ngroove_depth_mm = 8\n",
         "s.toml:12:19: drawing.groove_depth_mm: found 8 mm; allowed: less than the thickness, 8 mm"},
        {"keyway_without_bore", disk_drawing + "keyway = { width_mm = 8, depth_mm = 3 }\n",
         "s.toml:9:10: drawing.keyway: found a keyway without a bore; allowed: only where drawing.bore is "
         "given"},
        {"keyway_wider_than_bore", disk_drawing + "bore_mm = 8\nkeyway = { width_mm = 8, depth_mm = 3 }\n",
         "s.toml:10:23: drawing.keyway.width_mm: found 8 mm; allowed: less than the bore's 8 mm"},
        {"keyway_without_depth", disk_drawing + "bore_mm = 20\nkeyway = { width_mm = 8 }\n",
         "s.toml:10:10: drawing.keyway.depth_mm: missing; allowed: a number > 0"},
    };
}

}  // namespace camopt::input
