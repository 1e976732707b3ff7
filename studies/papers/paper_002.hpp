// SPDX-License-Identifier: MIT
// W. H. Kim and T. W. Park, "Development of Program for Designing Barrel Cam of Machine Making Paper Cups",
// 2011: the barrel cam with what the paper prints, checked by points that drive the index.
#pragma once

#include "studies/papers/paper_catalogue.hpp"

namespace camopt {

/// What the paper has, without a solve.
[[nodiscard]] PaperReport paper_002_as_printed(const PaperProgress& finished = {});

/// And what an optimised motion gains. Some seconds: two solves.
[[nodiscard]] PaperReport paper_002(const SolveControl& control = {}, const PaperProgress& finished = {});

}  // namespace camopt
