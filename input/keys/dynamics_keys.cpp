// SPDX-License-Identifier: MIT
#include "input/keys/key_spellings.hpp"

namespace camopt::input {

using enum KeyType;
using namespace spellings;

namespace {

const Range damping_ratios = Range::between(0.0, 2.0);

}  // namespace

// A row is read as a row.
// clang-format off
std::vector<KeyRow> dynamics_rows() {
    return {
        {"dynamics", "mass", number, mass, positive, {}, "needed", "Moved at the output; of a lift that is a length."},
        {"dynamics", "inertia", number, inertia, positive, {}, "needed",
         "The same where the lift is an angle.", Availability::now, "mass"},
        {"dynamics", "natural_frequency", number, frequency, positive, {}, "or a stiffness",
         "Of the output on its spring, with the cam (or the stage before it) held and the return spring on; undamped."},
        {"dynamics", "stiffness", number, train_spring, positive, {}, "or a natural frequency",
         "Of the spring between the output and what stands before it.", Availability::now, "natural_frequency"},
        {"dynamics", "damping_ratio", number, plain, damping_ratios, {}, "0",
         "Damping of the output in parts of critical."},
        {"dynamics", "damping", number, damper, not_negative, {}, "0", "The same as a damper.",
         Availability::now, "damping_ratio"},
        {"dynamics", "return_spring", number, train_spring, not_negative, {}, "0",
         "Rate of the spring that presses the output back to the cam."},
        {"dynamics", "preload", number, force_or_moment, not_negative, {}, "0",
         "What the return spring presses with at displacement 0. Without spring and preload the cam guides the follower both ways."},
        {"dynamics", "speed_range", numbers, speed, positive, {}, "motion.speed",
         "Two speeds: terms and limits of the train hold from the first to the second."},
        {"dynamics", "stage", tables, plain, any, {}, "none",
         "Masses between cam and output, at most three, from the cam on."},
        {"dynamics.stage", "mass", number, mass, positive, {}, "needed", "Of this mass."},
        {"dynamics.stage", "inertia", number, inertia, positive, {}, "needed",
         "The same where the lift is an angle.", Availability::now, "mass"},
        {"dynamics.stage", "stiffness", number, train_spring, positive, {}, "required",
         "Of the spring to what stands before it."},
        {"dynamics.stage", "damping_ratio", number, plain, damping_ratios, {}, "0",
         "c / (2 sqrt(k m)) of this mass on this spring."},
    };
}
// clang-format on

}  // namespace camopt::input
