// SPDX-License-Identifier: MIT
// Every example scene of a cam runs, and comes to the verdict that the manual shows.
#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace camopt {
namespace {

using nlohmann::json;

struct Expected {
    std::string verdict;
    std::string limit;  ///< one that bites; empty: none does
};

const std::map<std::string, Expected> expected = {
    {"cam_arm_flat", {"optimal", "limits.cam_radius_min_mm"}},
    {"cam_arm_roller", {"optimal", ""}},
    {"cam_conjugate", {"optimal", "limits.pressure_angle_deg"}},
    {"cam_clockwise", {"optimal", "limits.rise_pressure_angle_deg"}},
    {"cam_drdrd", {"optimal", "limits.pressure_angle_deg"}},
    {"cam_flat", {"optimal", "limits.cam_radius_min_mm"}},
    {"cam_forces", {"optimal", "limits.contact_force_min_n"}},
    {"cam_grooved", {"optimal", "limits.hertz_pressure_max_mpa"}},
    {"cam_infeasible", {"infeasible", ""}},
    {"cam_knife", {"optimal", "limits.pressure_angle_deg"}},
    {"cam_laws_and_splines", {"optimal", ""}},
    {"cam_roller", {"optimal", "limits.pressure_angle_deg"}},
    {"cam_smallest", {"optimal", "limits.pressure_angle_deg"}},
    {"cam_undercut", {"optimal", "limits.cam_radius_min_mm"}},
};

TEST(CamScenes, NoneIsForgotten) {
    const std::filesystem::path folder = std::filesystem::path(CAMOPT_SOURCE_DIR) / "scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().stem().string();
        EXPECT_TRUE(!name.starts_with("cam_") || expected.contains(name)) << name;
    }
}

TEST(CamScenes, ComeToTheVerdictOfTheManual) {
    for (const auto& [name, wanted] : expected) {
        SCOPED_TRACE(name);
        const test::ProgramRun run = test::run_camopt("solve " + test::scene(name) + " --json");
        EXPECT_EQ(run.exit_code, wanted.verdict == "infeasible" ? 3 : 0) << run.errors;
        const json found = json::parse(run.output, nullptr, false);
        ASSERT_FALSE(found.is_discarded());
        EXPECT_EQ(found["verdict"], wanted.verdict);
        if (wanted.verdict == "infeasible") continue;
        EXPECT_LE(found["worst_violation"].get<double>(), 1e-7);
        EXPECT_FALSE(found["cam"]["undercut"].get<bool>());
        EXPECT_FALSE(found["bound"]["lower"].is_null());
        bool bites = wanted.limit.empty();
        for (const json& limit : found["constraints"]) {
            bites = bites || (limit["key"] == wanted.limit && limit["active"].get<bool>());
        }
        EXPECT_TRUE(bites) << found["constraints"];
    }
}

}  // namespace
}  // namespace camopt
