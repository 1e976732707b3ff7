// SPDX-License-Identifier: MIT
#include "core/version.hpp"

namespace camopt {

std::string_view version() {
    return CAMOPT_VERSION;
}

}  // namespace camopt
