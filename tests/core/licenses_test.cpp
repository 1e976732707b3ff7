// SPDX-License-Identifier: MIT
#include "core/version.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace camopt {
namespace licenses_test {

bool has(const std::string& name) {
    const std::vector<LicensedPart> parts = licensed_parts();
    return std::ranges::find(parts, name, &LicensedPart::name) != parts.end();
}

TEST(Licenses, ListWhatTheBuildHas) {
    EXPECT_EQ(licensed_parts().front().name, "camopt");
    EXPECT_EQ(licensed_parts().front().license, "MIT");
    EXPECT_TRUE(has("Eigen"));
    EXPECT_EQ(has("Ipopt"), CAMOPT_BUILT_WITH_IPOPT);
    EXPECT_EQ(has("NLopt"), CAMOPT_BUILT_WITH_NLOPT);
    EXPECT_EQ(has("SuiteSparseQR"), CAMOPT_BUILT_WITH_SPQR);
    EXPECT_EQ(has("CHOLMOD"), CAMOPT_BUILT_WITH_SUITESPARSE);
    EXPECT_EQ(has("Open CASCADE"), CAMOPT_BUILT_WITH_OPENCASCADE);
    EXPECT_EQ(has("cairo"), CAMOPT_BUILT_WITH_CAIRO);
    EXPECT_EQ(has("cpp-httplib"), CAMOPT_BUILT_WITH_HTTPLIB);
    for (const LicensedPart& part : licensed_parts()) {
        EXPECT_FALSE(part.license.empty()) << part.name;
        EXPECT_FALSE(part.use.empty()) << part.name;
    }
}

TEST(Licenses, GplIsNamedExactlyWhenRequired) {
    const std::vector<LicensedPart> parts = licensed_parts();
    const bool gpl = std::ranges::any_of(parts, [](const LicensedPart& part) {
        return part.license.find("GPL-2.0") != std::string::npos &&
               part.license.find("LGPL-2.0") == std::string::npos;
    });
    const std::string terms = terms_of_binary();
    EXPECT_EQ(terms.find("under the GPL") != std::string::npos, gpl) << terms;
    EXPECT_EQ(terms.find("may be distributed under the MIT license") != std::string::npos,
              !gpl || !has("Ipopt"))
        << terms;
    EXPECT_EQ(terms.find("use it yourself") != std::string::npos, gpl && has("Ipopt")) << terms;
}

}  // namespace licenses_test
}  // namespace camopt
