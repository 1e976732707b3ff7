// SPDX-License-Identifier: MIT
#include "output/version.hpp"

namespace camopt {

std::string_view version() {
    return CAMOPT_VERSION;
}

}  // namespace camopt
