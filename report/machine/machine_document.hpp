// SPDX-License-Identifier: MIT
// A machine's result as people see it: what stops it, the timing diagram of all axes with the clearances over
// one revolution of the master, and each axis with its largest loads, for the electrical and the mechanical
// department.
#pragma once

#include "report/document/document.hpp"
#include "studies/machine/machine.hpp"

namespace camopt {

/// Without curves where nothing is delivered. The folders of its axes are named after them.
[[nodiscard]] Document machine_document(const MachineSolution& solution);

}  // namespace camopt
