// SPDX-License-Identifier: MIT
// The pictures of a finished sweep: sweep.svg and sweep.html beside sweep.csv.
#pragma once

#include "output/report/sweep_folder.hpp"

#include <string_view>

namespace camopt::apps {

/// A sweep of the weights of V, A, J gets the losses of the classical laws too, which takes some solves;
/// where they are interrupted the pictures are drawn without the rest. `units` as of finish_sweep.
void write_sweep_pictures(const SweepFolder& folder, const SweepTable& table, std::string_view units = {});

}  // namespace camopt::apps
