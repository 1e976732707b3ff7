// SPDX-License-Identifier: MIT
#include "output/json/version.hpp"

namespace camopt {

std::string_view version() {
    return CAMOPT_VERSION;
}

}  // namespace camopt
