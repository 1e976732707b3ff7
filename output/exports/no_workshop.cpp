// SPDX-License-Identifier: MIT
// A build without the shop.
#include "output/exports/workshop.hpp"

namespace camopt {

const Workshop* workshop() {
    return nullptr;
}

}  // namespace camopt
