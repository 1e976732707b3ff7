// SPDX-License-Identifier: MIT
#include "studies/bound/box_bound.hpp"

#include "studies/bound/bounder.hpp"

namespace camopt {

std::optional<BoxBound> bound_over_boxes(const CamModel& model, double incumbent,
                                         const BoxBoundOptions& options, const SolveControl& control) {
    return box_bound::Bounder(model, incumbent, options, control).run();
}

}  // namespace camopt
