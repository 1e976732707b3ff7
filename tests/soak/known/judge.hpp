// SPDX-License-Identifier: MIT
// What camopt says of a scene whose answer is known, and whether that is right.
#pragma once

#include "tests/soak/known/known_scene.hpp"

#include <string>

namespace camopt::soak {

enum class Judgement {
    right,    ///< optimal with the known objective, or infeasible where nothing moves
    open,     ///< local, feasible or failed: camopt proves nothing, and says so
    wrong,    ///< another objective, a bound above the optimum, a verdict that is not true
    refused,  ///< the scene is not accepted
};
[[nodiscard]] const char* name_of(Judgement judgement);

struct Judged {
    Judgement judgement = Judgement::wrong;
    std::string verdict, why;  ///< why: of all but right ones
    double seconds = 0.0;
};

[[nodiscard]] Judged judged(const KnownScene& scene);

}  // namespace camopt::soak
