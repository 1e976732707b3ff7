// SPDX-License-Identifier: MIT
#include "tests/support/source_folder.hpp"

namespace camopt {

std::string source_folder() {
    return CAMOPT_SOURCE_DIR;
}

}  // namespace camopt
