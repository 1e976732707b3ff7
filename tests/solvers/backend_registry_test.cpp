// SPDX-License-Identifier: MIT
#include "solvers/backend_support.hpp"
#include "solvers/registry.hpp"
#include "tests/support/refusal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace camopt {
namespace backend_registry_test {

using testing::AllOf;
using testing::HasSubstr;
using testing_support::refusal;

std::string option_refusal(const char* solver, const char* option, OptionValue value) {
    return refusal<InputError>([&] { check_native_options(solver, {{option, value}}); });
}

TEST(Termination, EveryValueHasItsOwnName) {
    std::set<std::string> names;
    for (int value = 0; value <= static_cast<int>(Termination::unsupported); ++value)
        names.insert(name_of(static_cast<Termination>(value)));
    EXPECT_EQ(names.size(), 11u);
    EXPECT_FALSE(names.contains("unknown"));
    EXPECT_EQ(BackendResult{}.termination, Termination::not_run);
}

TEST(BackendOptions, NameFoundAndAllowedOnRefusal) {
    BackendOptions options;
    EXPECT_NO_THROW(options.validate());
    options.tolerance = -1.0;
    EXPECT_THAT(refusal<InputError>([&] { options.validate(); }),
                AllOf(HasSubstr("'tolerance'"), HasSubstr("found -1"), HasSubstr("(0, 1)")));
    options = {};
    options.max_iterations = 0;
    EXPECT_THAT(refusal<InputError>([&] { options.validate(); }),
                AllOf(HasSubstr("'max_iterations'"), HasSubstr("found 0"), HasSubstr(">= 1")));
    options = {};
    options.max_seconds = infinity;
    EXPECT_THAT(refusal<InputError>([&] { options.validate(); }),
                AllOf(HasSubstr("'max_seconds'"), HasSubstr("found inf"), HasSubstr("> 0")));
}

TEST(Registry, KnowsItsBackends) {
    std::vector<std::string> names;
    for (const SolverEntry& entry : solver_entries()) {
        names.push_back(entry.name);
        EXPECT_FALSE(entry.method.empty());
        EXPECT_EQ(entry.available, !entry.version.empty()) << entry.name;
        if (entry.name != "structured") {
            EXPECT_THAT(entry.remedy, HasSubstr("install"));
        }
    }
    EXPECT_THAT(names, testing::ElementsAre("structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla", "nlopt.mma",
                                            "nlopt.ccsaq", "nlopt.isres", "nlopt.auglag.lbfgs",
                                            "nlopt.auglag.sbplx", "nlopt.auglag.neldermead"));
}

TEST(Registry, UnknownNameListsAlternatives) {
    EXPECT_THAT(refusal<InputError>([] { (void)make_solver("snopt"); }),
                AllOf(HasSubstr("unknown solver 'snopt'"),
                      HasSubstr("structured, ipopt, nlopt.slsqp, nlopt.cobyla")));
    EXPECT_THROW(check_native_options("snopt", {}), InputError);
}

TEST(Registry, MakesKnownAndRefusesUnknown) {
    for (const SolverEntry& entry : solver_entries()) {
        if (entry.available) {
            EXPECT_EQ(make_solver(entry.name)->name(), entry.name);
        } else {
            EXPECT_THAT(refusal<UnavailableError>([&] { (void)make_solver(entry.name); }),
                        AllOf(HasSubstr(entry.name), HasSubstr(entry.remedy)));
        }
    }
}

TEST(NativeOptions, UnknownNameListsAlternatives) {
    EXPECT_THAT(
        option_refusal("ipopt", "xyz", 1.0),
        AllOf(HasSubstr("unknown option 'xyz' of ipopt; allowed: linear_solver"), HasSubstr("mu_strategy")));
    EXPECT_THAT(option_refusal("nlopt.slsqp", "initial_step", 1.0),
                HasSubstr("unknown option 'initial_step'"));
}

TEST(NativeOptions, KindIsChecked) {
    EXPECT_THAT(option_refusal("ipopt", "mehrotra_algorithm", std::string("yes")),
                AllOf(HasSubstr("found 'yes'"), HasSubstr("bool: true or false")));
    EXPECT_THAT(option_refusal("ipopt", "acceptable_iter", 1.5),
                AllOf(HasSubstr("found 1.5"), HasSubstr("integer")));
    EXPECT_THAT(option_refusal("ipopt", "mu_init", std::string("small")), AllOf(HasSubstr("number: > 0")));
    EXPECT_THAT(option_refusal("nlopt.mma", "dual_algorithm", std::string("slsqp")),
                HasSubstr("'lbfgs' or 'mma'"));
    EXPECT_THAT(option_refusal("ipopt", "mu_strategy", true), HasSubstr("'adaptive' or 'monotone'"));
}

TEST(NativeOptions, RangeIsChecked) {
    EXPECT_THAT(option_refusal("ipopt", "mumps_pivtol", 2.0), HasSubstr("[0, 1]"));
    EXPECT_THAT(option_refusal("ipopt", "mu_init", 0.0), HasSubstr("> 0"));
    EXPECT_THAT(option_refusal("ipopt", "bound_relax_factor", -1.0), HasSubstr(">= 0"));
    EXPECT_THAT(option_refusal("nlopt.slsqp", "restarts", -1LL), HasSubstr("[0, 1000]"));
    EXPECT_THAT(option_refusal("nlopt.isres", "search_radius", 0.0), HasSubstr("> 0"));
    EXPECT_THAT(option_refusal("nlopt.auglag.lbfgs", "inner_maxeval", 0LL), HasSubstr("[1, 1"));
    EXPECT_THAT(option_refusal("structured", "correctors", 11LL), HasSubstr("[0, 10]"));
}

// The packaged Ipopt 3.11 ends the whole process on ma97.
TEST(NativeOptions, IpoptUsesOnlyMumps) {
    EXPECT_THAT(option_refusal("ipopt", "linear_solver", std::string("ma97")), HasSubstr("found 'ma97'"));
}

TEST(NativeOptions, UnavailableChoiceIsRefusedWithAlternatives) {
    SolverEntry entry;
    entry.name = "structured";
    entry.options = {text_option("factorization", "auto", {"auto", "chain", "klu"}, "")};
    entry.options.front().absent = {"klu"};
    entry.options.front().remedy = "install libsuitesparse-dev";
    EXPECT_NO_THROW(check_native_options(entry, {{"factorization", std::string("chain")}}));
    EXPECT_EQ(
        refusal<UnavailableError>([&] {
            check_native_options(entry, {{"factorization", std::string("klu")}});
        }),
        "option 'factorization' of structured: 'klu' is not built into this camopt; available: auto, chain; "
        "install libsuitesparse-dev");
}

TEST(NativeOptions, RightOnesPass) {
    EXPECT_NO_THROW(check_native_options("ipopt", {{"mu_strategy", std::string("monotone")},
                                                   {"mehrotra_algorithm", false},
                                                   {"acceptable_iter", 0LL},
                                                   {"mu_init", 1LL},
                                                   {"bound_relax_factor", 0.0}}));
    EXPECT_NO_THROW(check_native_options("nlopt.cobyla", {{"initial_step", 0.5}, {"restarts", 0LL}}));
}

}  // namespace backend_registry_test
}  // namespace camopt
