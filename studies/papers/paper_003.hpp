// SPDX-License-Identifier: MIT
// J. K. Shin, J. K. Lee, H. T. Ahn, "Design of a disk cam with remote follower in a tappet shedding device":
// its cams' pressure angles by two definitions beside its verdicts, profiles, forward simulations standing in
// for its experiment, and the motions that keep its dwells within its 30 deg. The paper prints no number of a
// cam and no dimension: what agrees with it agrees by the choice of ours.
#pragma once

#include "studies/papers/paper_catalogue.hpp"

namespace camopt {

/// Some ten seconds: two solves that are not convex.
[[nodiscard]] PaperReport paper_003(const SolveControl& control = {}, const PaperProgress& finished = {});

}  // namespace camopt
