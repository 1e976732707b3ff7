// SPDX-License-Identifier: MIT
// Cams of other types than "disk": keys that do not belong together, numbers that are missing.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_mechanisms_parts {

/// Three lines.
const std::string start =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 20\n";

/// Nine lines: a remote cam without its linkage.
const std::string remote = start +
                           "[cam]\n"
                           "type = \"remote\"\n"
                           "roller_radius_mm = 30\n"
                           "roller_arm_mm = 160\n"
                           "lever_pivot_x_mm = -160\n"
                           "lever_pivot_y_mm = 85\n";

}  // namespace broken_mechanisms_parts

std::vector<BrokenScene> broken_mechanisms() {
    using namespace broken_mechanisms_parts;
    return {
        {"RemoteWithoutLinkage", remote,
         "s.toml:4:1: linkage: missing; allowed: a [linkage] table for a cam of type \"remote\""},
        {"RemoteWithAnOffset", remote + "offset_mm = 3\n",
         "s.toml:10:1: cam.offset_mm: found a key for cams of type \"disk\"; allowed: only with cam.type = "
         "\"disk\""},
        {"DiskWithALever", start + "[cam]\ntype = \"disk\"\nroller_arm_mm = 160\n",
         "s.toml:6:1: cam.roller_arm_mm: found a key for cams of type \"remote\"; allowed: only with "
         "cam.type = "
         "\"remote\""},
        {"LinkageWithoutACam", start + "[linkage]\ntype = \"lever\"\n",
         "s.toml:4:2: linkage: found a key for cams of type \"remote\"; allowed: only with cam.type = "
         "\"remote\""},
        {"LinkageThatSwings", remote + "[linkage]\ntype = \"lever\"\n",
         "s.toml:11:8: linkage.type: found \"lever\" where the lift is a length; allowed: a linkage with a "
         "slider, or motion.lift_deg or motion.lift_rad"},
        {"MissingArm", remote + "[linkage]\ntype = \"lever_coupler_slider\"\n",
         "s.toml:10:1: linkage.lever_arm_mm: missing for the linkage \"lever_coupler_slider\"; allowed: a "
         "number > 0, or a range { min = …, max = … }"},
        {"DimensionOfAnotherLinkage",
         remote + "[linkage]\ntype = \"lever_coupler_slider\"\nsecond_coupler_mm = 100\nlever_arm_mm = 100\n"
                  "coupler_mm = 100\nslider_x_mm = 0\nslider_y_mm = 0\n",
         "s.toml:12:1: linkage.second_coupler_mm: found a key that the linkage \"lever_coupler_slider\" does "
         "not "
         "have; allowed: only with \"lever_coupler_lever_coupler_slider\""},
        {"UnknownBranch", remote + "[linkage]\ntype = \"lever_coupler_slider\"\nlever_branch = \"up\"\n",
         "s.toml:12:16: linkage.lever_branch: found \"up\"; allowed: \"left\" or \"right\""},
    };
}

}  // namespace camopt::input
