// SPDX-License-Identifier: MIT
#include "studies/machine/machine_solution.hpp"

#include <fmt/format.h>

namespace camopt {

void MachineOptions::validate() const {
    if (!(speed_gap > 0.0 && speed_gap < 1.0))
        throw InputError(fmt::format("speed gap: found {}; allowed: a number > 0 and < 1", speed_gap));
    if (!(more_speed > 0.0) || !(max_seconds > 0.0) || scanned_speeds < 2)
        throw InputError(
            "machine options: found a number that is not positive; allowed: more_speed > 0, "
            "max_seconds > 0, scanned_speeds >= 2");
}

}  // namespace camopt
