// SPDX-License-Identifier: MIT
#include "benchmarks/linear/clp_rival.hpp"
#include "core/errors.hpp"

namespace camopt::benchmarks {

std::vector<std::string> clp_methods() {
    return {};
}

std::string clp_version() {
    return {};
}

RivalRun run_clp(const LinearProgram&, const std::string&, double) {
    throw UnavailableError("this build has no Clp: install coinor-libclp-dev");
}

}  // namespace camopt::benchmarks
