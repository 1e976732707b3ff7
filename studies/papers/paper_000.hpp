// SPDX-License-Identifier: MIT
// J.-H. Shin, Y.-H. Choi, C.-S. Rho, "Kinematic Analysis and Simulation of an Automatic Feeding Mechanism
// Subjected by a Curvilinear Inverse Cam (I)": Table 1 and Figs. 9 and 10 beside ours with the misprints, the
// approximate method against the exact one, forward simulations, and the guide that the paper does not ask
// for: the best one.
#pragma once

#include "studies/papers/paper_catalogue.hpp"

namespace camopt {

/// About a second.
[[nodiscard]] PaperReport paper_000(const SolveControl& control = {}, const PaperProgress& finished = {});

}  // namespace camopt
