// SPDX-License-Identifier: MIT
// B. K. Gu, J. H. Shin, D. W. Kang, S. W. Chang, "A Study On the Manufacturing process of Cylindrical Cam
// based on Relative Velocity Method and Inverse Kinematics": the open cylindrical cam with a rotating
// follower (OCRF). The paper holds no number; its formulas are put to the test on an example of ours.
#pragma once

#include "studies/papers/paper_catalogue.hpp"

namespace camopt {

/// About a second.
[[nodiscard]] PaperReport paper_001(const SolveControl& control = {}, const PaperProgress& finished = {});

}  // namespace camopt
