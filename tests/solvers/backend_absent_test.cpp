// SPDX-License-Identifier: MIT
// Compiled together with the door of a part that is absent and with nlopt_absent.cpp, so that what a build
// without those libraries says is tested in every build.
#include "solvers/ipopt/ipopt_solver.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"
#include "tests/support/refusal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace camopt {
namespace backend_absent_test {

using testing::AllOf;
using testing::HasSubstr;

template <class Make>
void expect_unavailable(const SolverEntry& entry, Make make) {
    EXPECT_FALSE(entry.available);
    EXPECT_TRUE(entry.version.empty());
    EXPECT_FALSE(entry.options.empty()) << "what could be set is still said";
    EXPECT_THAT(testing_support::refusal<UnavailableError>([&] { (void)make(); }),
                AllOf(HasSubstr("'" + entry.name + "' is not built into this camopt"), HasSubstr("install"),
                      HasSubstr("-dev")));
}

TEST(AbsentBackend, IpoptSaysWhatToInstall) {
    expect_unavailable(ipopt_entry(), make_ipopt_solver);
}
TEST(AbsentBackend, NamesPackageForEveryNloptMethod) {
    using enum NloptMethod;
    for (const NloptMethod method :
         {slsqp, cobyla, mma, ccsaq, isres, auglag_lbfgs, auglag_sbplx, auglag_neldermead})
        expect_unavailable(nlopt_entry(method), [method] { return make_nlopt_solver(method); });
}

}  // namespace backend_absent_test
}  // namespace camopt
