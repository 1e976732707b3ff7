// SPDX-License-Identifier: MIT
// A build without the shop.
#include "report/exports/workshop.hpp"

namespace camopt {

const Workshop* workshop() {
    return nullptr;
}

}  // namespace camopt
