// SPDX-License-Identifier: MIT
// Barrel and cylindrical cams that must be refused.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_spatial_parts {

/// Three lines.
const std::string swinging =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_deg = 20\n";
const std::string sliding =
    "objective.jerk = 1\n"
    "motion.type = \"DRD\"\n"
    "motion.lift_mm = 20\n";

/// Eight lines.
const std::string without_place = swinging +
                                  "[cam]\n"
                                  "type = \"barrel\"\n"
                                  "roller_radius_mm = 10\n"
                                  "roller_length_mm = 20\n"
                                  "arm_length_mm = 70\n";
const std::string barrel = without_place + "center_distance_mm = 150\n";

}  // namespace broken_spatial_parts

std::vector<BrokenScene> broken_spatial() {
    using namespace broken_spatial_parts;
    return {
        {"BarrelWithoutItsPlace", without_place,
         "s.toml:4:1: cam.center_distance_mm: missing for this cam (\"barrel\"); allowed: a number > 0, or a "
         "range { min = …, max = … }"},
        {"BarrelThatSlides", sliding + "[cam]\ntype = \"barrel\"\n",
         "s.toml:5:8: cam.type: found \"barrel\" where the lift is a length; allowed: a cylindrical cam with "
         "a "
         "\"translating\" follower, or motion.lift_deg or motion.lift_rad"},
        {"BarrelWithAFollower", barrel + "follower = \"rotating\"\n",
         "s.toml:10:1: cam.follower: found a key for cams of type \"disk\" or \"cylindrical\"; allowed: only "
         "with cam.type = \"disk\" or \"cylindrical\"; cam.type = \"barrel\" already determines this value: "
         "remove the key"},
        {"BarrelWithACylinder", barrel + "cylinder_radius_mm = 60\n",
         "s.toml:10:1: cam.cylinder_radius_mm: found a key that this cam (\"barrel\") does not have; "
         "allowed: "
         "leave it out"},
        {"CylinderWithADisksFollower",
         sliding + "[cam]\ntype = \"cylindrical\"\nfollower = \"translating_roller\"\n",
         "s.toml:6:12: cam.follower: found \"translating_roller\" for a cam of type \"cylindrical\"; "
         "allowed: "
         "\"rotating\" or \"translating\""},
        {"DiskWithACylindersFollower",
         sliding + "[cam]\ntype = \"disk\"\nfollower = \"rotating\"\nbase_radius_mm = 40\n",
         "s.toml:6:12: cam.follower: found \"rotating\" for a cam of type \"disk\"; allowed: "
         "\"translating_roller\", \"translating_flat\", \"translating_knife\", \"oscillating_roller\" or "
         "\"oscillating_flat\""},
        {"TranslatingThatSwings", swinging + "[cam]\ntype = \"cylindrical\"\nfollower = \"translating\"\n",
         "s.toml:6:12: cam.follower: found \"translating\" where the lift is an angle; allowed: "
         "\"rotating\", "
         "or motion.lift_mm, motion.lift_in or motion.lift_m"},
        {"TranslatingWithAnArm",
         sliding + "[cam]\ntype = \"cylindrical\"\nfollower = \"translating\"\narm_length_mm = 70\n",
         "s.toml:7:1: cam.arm_length_mm: found a key that this cam (\"cylindrical_translating\") does not "
         "have; allowed: only with \"rotating\""},
        {"DiskWithARollerLength",
         sliding + "[cam]\ntype = \"disk\"\nfollower = \"translating_knife\"\nbase_radius_mm = "
                   "40\nroller_length_mm = 20\n",
         "s.toml:8:1: cam.roller_length_mm: found a key for cams of type \"barrel\" or \"cylindrical\"; "
         "allowed: only with cam.type = \"barrel\" or \"cylindrical\""},
    };
}

}  // namespace camopt::input
