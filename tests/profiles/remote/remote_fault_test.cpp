// SPDX-License-Identifier: MIT
// What does not reach is named, with the amount it lacks.
#include "core/errors.hpp"
#include "tappet.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace remote_fault_test {

using namespace test;

std::string fault_of(const CamSpec& spec, double most = 0.08) {
    return RemoteCam(spec).fault(spec.middle(), 0.0, most);
}

void expect_words(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST(RemoteFault, TheReferenceHasNone) {
    EXPECT_EQ(fault_of(tappet()), "");
    EXPECT_EQ(fault_of(tappet(true)), "");
}

TEST(RemoteFault, NamesShortDyadAndDeficit) {
    CamSpec spec = tappet();
    set(spec, second_coupler, 40);
    // (10, 560) is 296.816 mm from (260, 400): 6.816 mm more than 250 + 40.
    expect_words(fault_of(spec),
                 {"rocker_output_arm", "second_coupler", "too short by 6.816", "displacement 0 mm"});
    spec = tappet();
    set(spec, coupler, 150);
    expect_words(fault_of(spec), {"lever_arm", "coupler", "too short by"});
}

TEST(RemoteFault, NamesTheDyadThatCannotFold) {
    CamSpec spec = tappet();
    set(spec, second_coupler, 600);
    expect_words(fault_of(spec), {"second_coupler", "cannot fold", "by 53.18"});
}

TEST(RemoteFault, FindsFaultsOnlyAtFullLift) {
    CamSpec spec = tappet();
    EXPECT_EQ(fault_of(spec, 0.08), "");
    expect_words(fault_of(spec, 0.4), {"at displacement"});
}

TEST(RemoteFault, NamesLeverWithoutMotion) {
    CamSpec spec = tappet();
    set(spec, center_x, 100);  // the arm, at -7 deg at first, passes -3 deg on its way
    set(spec, center_y, 72);
    expect_words(fault_of(spec), {"line to the cam's centre"});
}

TEST(RemoteFault, NamesNonpositiveDimension) {
    CamSpec spec = tappet();
    set(spec, coupler, 0);
    expect_words(fault_of(spec), {"the coupler of 0 mm is not positive"});
}

TEST(RemoteFault, RefusesAnUnknownBranch) {
    CamSpec spec = tappet();
    spec.choices["lever_branch"] = "up";
    expect_words(testing_support::refusal([&] { const RemoteCam cam(spec); }),
                 {"lever_branch", "\"up\"", "\"left\"", "\"right\""});
}

}  // namespace remote_fault_test
}  // namespace camopt
