// SPDX-License-Identifier: MIT
#include "core/version.hpp"

namespace camopt {

std::string_view version() {
    return CAMOPT_VERSION;
}

namespace {

// Set by core/CMakeLists.txt: 1 where the build has it.
constexpr bool has_ipopt = CAMOPT_BUILT_WITH_IPOPT;
constexpr bool has_nlopt = CAMOPT_BUILT_WITH_NLOPT;
constexpr bool has_spqr = CAMOPT_BUILT_WITH_SPQR;
constexpr bool has_suitesparse = CAMOPT_BUILT_WITH_SUITESPARSE;
constexpr bool has_opencascade = CAMOPT_BUILT_WITH_OPENCASCADE;
constexpr bool has_cairo = CAMOPT_BUILT_WITH_CAIRO;
constexpr bool has_httplib = CAMOPT_BUILT_WITH_HTTPLIB;

}  // namespace

std::vector<LicensedPart> licensed_parts() {
    std::vector<LicensedPart> parts = {{"camopt", "MIT", "all of it"},
                                       {"Eigen", "MPL-2.0", "linear algebra, compiled in"},
                                       {"fmt", "MIT", "messages"},
                                       {"toml++", "MIT", "scene files, compiled in"},
                                       {"nlohmann-json", "MIT", "result files, compiled in"}};
    if (has_ipopt) {
        parts.push_back({"Ipopt", "EPL-1.0", "solver"});
        parts.push_back({"MUMPS", "CECILL-C", "linear systems of Ipopt"});
    }
    if (has_nlopt) parts.push_back({"NLopt", "LGPL-2.1-or-later", "solvers"});
    if (has_spqr) parts.push_back({"SuiteSparseQR", "GPL-2.0-or-later", "sparse QR"});
    if (has_suitesparse) {
        parts.push_back(
            {"CHOLMOD", "LGPL-2.1-or-later AND GPL-2.0-or-later", "factorizations; some modules are GPL"});
        parts.push_back({"KLU", "LGPL-2.1-or-later", "factorizations"});
    }
    if (has_opencascade)
        parts.push_back({"Open CASCADE", "LGPL-2.1-only WITH OCCT-exception-1.0", "STEP files"});
    if (has_cairo) parts.push_back({"cairo", "LGPL-2.1-only OR MPL-1.1", "PDF drawings"});
    if (has_httplib) {
        parts.push_back({"cpp-httplib", "MIT", "the studio's server"});
        parts.push_back(
            {"OpenSSL, Brotli and zlib", "Apache-2.0, MIT, Zlib", "what cpp-httplib is linked to"});
    }
    return parts;
}

std::string terms_of_binary() {
    if ((has_spqr || has_suitesparse) && has_ipopt)
        return "A binary of this build holds parts under the GPL (SuiteSparse) and under the EPL (Ipopt), "
               "whose terms cannot both be met when it is distributed: use it yourself; to distribute one, "
               "build with CAMOPT_GPL=OFF, or without Ipopt.";
    if (has_spqr || has_suitesparse)
        return "A binary of this build may be distributed under the GPL, version 2 or later, as a whole: it "
               "holds "
               "parts of SuiteSparse. Built with CAMOPT_GPL=OFF it may be distributed under the MIT license.";
    std::string text = "A binary of this build may be distributed under the MIT license";
    if (has_nlopt || has_opencascade || has_cairo || has_ipopt)
        text += ", with the libraries it is linked to under theirs";
    return text + ".";
}

std::string license_text() {
    std::string text;
    for (const LicensedPart& part : licensed_parts())
        text += part.name + ": " + part.license + " (" + part.use + ")\n";
    return text + terms_of_binary();
}

}  // namespace camopt
