// SPDX-License-Identifier: MIT
// Inverse cams that must be refused.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_inverse_parts {

const std::string objective = "objective.jerk = 1\n";
/// Five lines.
const std::string start = objective +
                          "motion.type = \"DRD\"\n"
                          "motion.lift_mm = 60\n"
                          "[cam]\n"
                          "type = \"inverse\"\n";

}  // namespace broken_inverse_parts

std::vector<BrokenScene> broken_inverse() {
    using namespace broken_inverse_parts;
    return {
        {"WithoutItsRoller", start,
         "s.toml:4:1: cam.roller_radius_mm: missing for an inverse cam; allowed: a number > 0, or a range { "
         "min = …, max = … }"},
        {"ThatSwings", objective + "motion.type = \"DRD\"\nmotion.lift_deg = 20\ncam.type = \"inverse\"\n",
         "s.toml:4:12: cam.type: found \"inverse\" where the lift is an angle; allowed: motion.lift_mm, "
         "motion.lift_in or motion.lift_m, the stroke of its feeder"},
        {"ThatReturns", objective + "motion.type = \"RR\"\nmotion.lift_mm = 20\ncam.type = \"inverse\"\n",
         "s.toml:4:12: cam.type: found \"inverse\" with the motion \"RR\"; allowed: the motion \"DRD\""},
        {"WithAFollower", start + "follower = \"rotating\"\n",
         "s.toml:6:1: cam.follower: found a key for cams of type \"disk\" or \"cylindrical\"; allowed: only "
         "with cam.type = \"disk\" or \"cylindrical\"; cam.type = \"inverse\" already determines this value: "
         "remove the key"},
        {"WithARotation", start + "rotation = \"clockwise\"\n",
         "s.toml:6:1: cam.rotation: found a key for cams of type \"disk\" or \"remote\" or \"barrel\" or "
         "\"cylindrical\"; allowed: only with cam.type = \"disk\" or \"remote\" or \"barrel\" or "
         "\"cylindrical\""},
        {"WithANegativePin", start + "pin_distance_mm = -3\n",
         "s.toml:6:19: cam.pin_distance_mm: found -3; allowed: a number > 0, or a range { min = …, max = … "
         "}"},
        {"ADiskWithAPin",
         objective + "motion.type = \"DRD\"\nmotion.lift_mm = 60\n[cam]\ntype = \"disk\"\nfollower = "
                     "\"translating_knife\"\nbase_radius_mm = 40\npin_distance_mm = 3\n",
         "s.toml:8:1: cam.pin_distance_mm: found a key for cams of type \"inverse\"; allowed: only with "
         "cam.type = \"inverse\""},
    };
}

}  // namespace camopt::input
