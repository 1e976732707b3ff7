// SPDX-License-Identifier: MIT
#include "output/json/result_json.hpp"

#include "core/version.hpp"
#include "tests/output/sample_solution.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace camopt {
namespace result_json_test {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;
}

/// Whether `part` stands in `whole` in this order, with others between.
bool in_order(const std::vector<std::string>& part, const std::vector<std::string>& whole) {
    std::size_t found = 0;
    for (const std::string& key : whole)
        if (found < part.size() && key == part[found]) ++found;
    return found == part.size();
}

TEST(ResultJson, CarriesTheContractedKeysInOrder) {
    const Json json = Json::parse(result_json(test::sample_solution(), {"a.toml", "camopt solve a.toml"}));
    EXPECT_TRUE(in_order({"camopt", "scene", "verdict", "objective", "bound", "peaks", "constraints",
                          "spline", "design", "dimensions", "solver", "evaluations", "seconds"},
                         keys_of(json)));
    EXPECT_TRUE(in_order({"lower", "gap", "proof", "any_curve_limit"}, keys_of(json["bound"])));
    EXPECT_TRUE(in_order({"velocity", "acceleration", "jerk", "torque"}, keys_of(json["peaks"])));
    EXPECT_TRUE(
        in_order({"name", "limit", "worst", "unit", "at_deg", "active"}, keys_of(json["constraints"][0])));
    EXPECT_EQ(keys_of(json["spline"]),
              (std::vector<std::string>{"degree", "continuity", "breakpoints", "knots", "coefficients"}));
    EXPECT_EQ(keys_of(json["design"]), (std::vector<std::string>{"kind", "names", "values"}));
    EXPECT_TRUE(in_order({"name", "termination", "iterations", "exchange_rounds"}, keys_of(json["solver"])));
    EXPECT_EQ(keys_of(json["evaluations"]),
              (std::vector<std::string>{"cost", "gradient", "constraints", "jacobian", "hessian",
                                        "profile_points"}));
    EXPECT_EQ(keys_of(json["seconds"]),
              (std::vector<std::string>{"total", "solve", "setup", "solver", "judgement", "proof",
                                        "tie_break", "report"}));
    EXPECT_FALSE(json.contains("relaxation"));
}

TEST(ResultJson, WritesTheValues) {
    const Json json = Json::parse(result_json(test::sample_solution(), {"a.toml", ""}));
    EXPECT_EQ(json["camopt"], version());
    EXPECT_EQ(json["scene"], "a.toml");
    EXPECT_EQ(json["verdict"], "optimal");
    EXPECT_EQ(json["objective"], 1.125961);
    EXPECT_EQ(json["bound"]["any_curve_limit"], 0.9371963699);
    EXPECT_EQ(json["peaks"]["acceleration"], (Json{{"value", 8.0}, {"at", 0.25}}));
    EXPECT_DOUBLE_EQ(json["constraints"][0]["at_deg"].get<double>(), 45.0);
    EXPECT_EQ(json["design"]["values"][0].get<double>(), 1.0 / 12.0);  // the same double
    EXPECT_EQ(json["spline"]["coefficients"].size(), 7U);
    EXPECT_EQ(json["spline"]["knots"].size(), 11U);
    EXPECT_EQ(json["evaluations"]["profile_points"], 0);
    EXPECT_TRUE(json["reference"]["jerk"].is_null());  // not in use
    EXPECT_DOUBLE_EQ(json["physical_peaks"]["v_mm_s"].get<double>(), 2.0 * 10.0 / 0.05);
}

TEST(ResultJson, InfeasibleSceneHasRelaxationAndNulls) {
    const std::string text = result_json(test::infeasible_solution());
    const Json json = Json::parse(text);
    EXPECT_EQ(json["verdict"], "infeasible");
    for (const char* key : {"scene", "objective", "peaks", "spline", "design"})
        EXPECT_TRUE(json[key].is_null()) << key;
    EXPECT_EQ(json["relaxation"][0],
              (Json{{"key", "limits.velocity_mm_s"}, {"given", 100.0}, {"needed", 312.5}, {"exact", false}}));
    EXPECT_TRUE(json["relaxation"][1]["needed"].is_null());
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf,"), std::string::npos);
}

TEST(ResultJson, InvalidByteInTitleIsEscaped) {
    Solution solution = test::sample_solution();
    solution.scene.title = "broken \xff title";
    EXPECT_TRUE(Json::accept(result_json(solution)));
}

}  // namespace result_json_test
}  // namespace camopt
