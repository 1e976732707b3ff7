// SPDX-License-Identifier: MIT
// Every row of the table of limits is read by each of its keys, refused out of its range, ruled, relaxed,
// reported: a row that is missing anywhere fails here, a new one is tested without an edit.
#include "scene/limit_table.hpp"

#include "input/keys/scene_keys.hpp"
#include "report/folders/result_folder.hpp"
#include "report/json/result_json.hpp"
#include "report/view/key_words.hpp"
#include "scene/key_row.hpp"
#include "scene/motion/set_points.hpp"
#include "studies/check/scene_check.hpp"
#include "studies/least/adjustment.hpp"
#include "studies/solve/solve.hpp"
#include "table_scenes.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <vector>

namespace camopt {
namespace limit_table_test {

using namespace tables;
using testing_support::says;
using Json = nlohmann::ordered_json;

constexpr const char* least_jerk = "jerk = 1";

/// Those of elastic trains stand behind those of cams; studies/response/train_scenes_test.cpp is theirs.
std::span<const LimitRow> rows_of_cams() {
    const auto trains = std::ranges::find(limit_rows(), true, &LimitRow::needs_dynamics);
    return {limit_rows().begin(), trains};
}

/// For every row, both ways of moving, and every spelling.
template <typename Visit>
void for_each_key(const Visit& visit) {
    for (const LimitRow& row : rows_of_cams())
        for (const bool swings : {false, true})
            for (const Spelling& spelling : spellings_of(row, swings)) {
                SCOPED_TRACE(fmt::format("limits.{}{}", name_of_limit(row, swings), spelling.suffix));
                visit(row, swings, spelling);
            }
}

TEST(LimitTable, CoversEveryMemberOfLimitSpec) {
    // Members cannot be counted, but their size can.
    EXPECT_EQ(sizeof(LimitSpec), peak_limit_rows().size() * sizeof(std::optional<PeakLimit>) +
                                     limit_rows().size() * sizeof(std::optional<WrittenLimit>) +
                                     sizeof(MotorCurve) + sizeof(LimitSpec::spring_harmonics));
    LimitSpec limits;
    std::set<const void*> members;
    std::set<std::string> names;
    for (const PeakLimitRow& row : peak_limit_rows()) {
        EXPECT_TRUE(members.insert(&row.in(limits)).second) << row.name();
        EXPECT_TRUE(names.insert(row.name()).second) << row.name();
        if (row.side == 0 && !row.of_cam) {
            EXPECT_EQ(row.order(), static_cast<int>(members.size()));
        }
    }
    for (const LimitRow& row : limit_rows()) {
        EXPECT_TRUE(members.insert(&row.in(limits)).second) << row.name;
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(&limit_row(row.figure), &row);
        EXPECT_EQ(limit_named(row.name), &row);
        EXPECT_STREQ(limit_name_in("limits." + row.first_key()), row.name);
        if (row.swinging.name != nullptr) {
            EXPECT_TRUE(names.insert(row.swinging.name).second);
        }
    }
    EXPECT_EQ(limit_named("face_half_width"), nullptr);
    EXPECT_EQ(limit_name_in("cam.face_half_width_mm"), nullptr);
}

TEST(LimitTable, EveryKeySetsOneRow) {
    for_each_key([](const LimitRow& row, bool swings, const Spelling& spelling) {
        const double value = loose_value(row);
        const Scene scene = read(scene_text(swings, least_jerk, limit_line(row, swings, spelling, value)));
        for (const LimitRow& other : limit_rows())
            EXPECT_EQ(other.in(scene.limits).has_value(), &other == &row) << other.name;
        const auto& limit = row.in(scene.limits);
        ASSERT_TRUE(limit);
        EXPECT_NEAR(limit->value, value, 1e-12 * std::abs(value));
        EXPECT_EQ(limit->key, fmt::format("limits.{}{}", name_of_limit(row, swings), spelling.suffix));
        EXPECT_EQ(limit->unit, spelling.unit);
    });
}

TEST(LimitTable, EveryRowRefusesInvalidRange) {
    for_each_key([](const LimitRow& row, bool swings, const Spelling& spelling) {
        const std::string key = name_of_limit(row, swings) + std::string(spelling.suffix);
        const std::string message =
            refusal_of(scene_text(swings, least_jerk, limit_line(row, swings, spelling, value_outside(row))));
        const input::KeyMatch match = input::match_key("limits", key);
        ASSERT_NE(match.row, nullptr);
        EXPECT_TRUE(says(message, fmt::format("limits.{}: found", key)));
        EXPECT_TRUE(says(message, "allowed: " + match.row->allowed(*match.spelling)));
        Scene scene = read(scene_text(swings, least_jerk, ""));
        row.in(scene.limits) = WrittenLimit{value_outside(row)};
        const std::optional<SceneFault> fault = find_fault(scene);
        ASSERT_TRUE(fault);
        EXPECT_EQ(fault->member, fmt::format("limits.{}", row.name));
        EXPECT_EQ(fault->allowed, row.range.number_text());
    });
}

TEST(LimitTable, EveryRowRequiresItsCamData) {
    for (const LimitRow& row : rows_of_cams()) {
        Scene scene = read(scene_text(false, least_jerk, ""));
        row.in(scene.limits) = WrittenLimit{loose_value(row)};
        EXPECT_FALSE(find_fault(scene)) << row.name;
        scene.forces.reset();
        EXPECT_EQ(find_fault(scene).has_value(), row.needs_forces) << row.name;
        scene.cam.reset();
        EXPECT_TRUE(find_fault(scene)) << row.name;
    }
}

TEST(LimitTable, EveryRowHasRuleAndRelaxation) {
    for (const LimitRow& row : rows_of_cams()) {
        SCOPED_TRACE(row.name);
        const Spelling& spelling = row.spellings.front();
        const Scene scene =
            read(scene_text(false, least_jerk, limit_line(row, false, spelling, loose_value(row))));
        const std::string key = "limits." + row.first_key();
        const SceneCheck check = check_scene(scene);
        EXPECT_TRUE(std::ranges::any_of(check.limits, [&](const LimitShape& limit) {
            return limit.key == key;
        })) << "no rule";
        EXPECT_TRUE(check.derivatives_agree);
        const std::vector<Adjustment> all = adjustments(scene);
        const auto own = std::ranges::find(all, key, &Adjustment::key);
        ASSERT_NE(own, all.end()) << "no relaxation";
        EXPECT_TRUE(own->limit);
        EXPECT_EQ(own->may_grow, !row.is_least());
        EXPECT_EQ(own->may_shrink, row.is_least());
    }
}

TEST(LimitTable, EveryRowIsReportedEverywhere) {
    for (const bool swings : {false, true}) {
        std::string lines;
        for (const LimitRow& row : rows_of_cams())
            lines += limit_line(row, swings, spellings_of(row, swings).front(), loose_value(row)) + "\n";
        const Solution solution = solve(read(scene_text(swings, least_jerk, lines)));
        ASSERT_TRUE(solution.motion);
        const Json json = Json::parse(result_json(solution));
        const std::string report = report_markdown(solution);
        for (const LimitRow& row : rows_of_cams()) {
            const std::string name = name_of_limit(row, swings);
            SCOPED_TRACE(name);
            const std::string key = "limits." + name + std::string(spellings_of(row, swings).front().suffix);
            const auto found = std::ranges::find(solution.constraints, name, &ConstraintReport::name);
            ASSERT_NE(found, solution.constraints.end());
            EXPECT_EQ(found->key, key);
            EXPECT_EQ(is_least_limit(name), row.is_least());
            EXPECT_TRUE(row.is_least() ? found->worst >= found->limit : found->worst <= found->limit)
                << found->worst << " against " << found->limit;
            const auto& rows = json["constraints"];
            EXPECT_TRUE(std::ranges::any_of(rows, [&](const Json& one) {
                return one["name"] == name && one["key"] == key;
            })) << "not in result.json";
            EXPECT_TRUE(says(report, key)) << "not in the report";
        }
    }
}

/// "velocity_mm_s = 1e9", "velocity_mm_s = { min = -1e9 }".
std::string cap_line(const PeakLimitRow& row, const Spelling& spelling, double value) {
    const std::string key = row.key_name + std::string(spelling.suffix);
    if (row.side == 0) return fmt::format("{} = {}", key, value);
    return fmt::format("{} = {{ {} = {} }}", key, row.side < 0 ? "min" : "max", row.side * value);
}

/// The scene with these lines in [limits]; a cap on the cam's own motion needs a train that gives its output.
std::string capped(bool of_cam, bool swings, const std::string& lines) {
    std::string text = scene_text(swings, least_jerk, lines);
    if (!of_cam) return text;
    text.replace(text.find("[spline]\n"), 9, "[spline]\ndegree = 5\n");
    return text + fmt::format("[dynamics]\n{} = 1\nnatural_frequency_hz = 40\nprescribe = \"output\"\n",
                              swings ? "inertia_kg_m2" : "mass_kg");
}

TEST(LimitTable, EveryPeakCapIsFullySupported) {
    for (const PeakLimitRow& row : peak_limit_rows())
        for (const Spelling& spelling : row.spellings) {
            const std::string written = row.key_name + std::string(spelling.suffix);
            const std::string key = written + (row.side == 0 ? "" : row.side < 0 ? ".min" : ".max");
            SCOPED_TRACE(key);
            const bool swings = spelling.unit.starts_with("deg") || spelling.unit.starts_with("rad");
            const std::string line = cap_line(row, spelling, 1e9);
            const Scene scene = read(capped(row.of_cam, swings, line));
            const auto& limit = row.in(scene.limits);
            ASSERT_TRUE(limit);
            EXPECT_EQ(limit->key, "limits." + key);
            EXPECT_EQ(limit->physical(), !spelling.unit.empty());
            EXPECT_EQ(limit->in_time(), is_unit_of_time(spelling.unit));
            EXPECT_TRUE(says(refusal_of(capped(row.of_cam, swings, written + " = 0")), "limits." + written));
            if (limit->physical()) {
                EXPECT_NE(refusal_of(capped(row.of_cam, !swings, line)), "") << "unit of another lift";
            }
            const std::vector<Adjustment> caps = adjustments(scene);
            EXPECT_EQ(std::ranges::count(caps, "limits." + key, &Adjustment::key), 1);
        }
}

TEST(LimitTable, EveryPeakCapIsReported) {
    for (const int side : {0, -1, 1}) {
        std::string lines;
        for (const PeakLimitRow& row : peak_limit_rows())
            if (row.side == side) lines += cap_line(row, row.spellings.front(), 1e6) + "\n";
        const Solution solution = solve(read(capped(true, false, lines)));
        ASSERT_TRUE(solution.motion);
        const std::string json = result_json(solution), report = report_markdown(solution);
        for (const PeakLimitRow& row : peak_limit_rows()) {
            if (row.side != side) continue;
            const std::string key = fmt::format("limits.{}{}", row.key_name,
                                                side == 0  ? ""
                                                : side < 0 ? ".min"
                                                           : ".max");
            EXPECT_EQ(std::ranges::count(solution.constraints, row.name(), &ConstraintReport::name), 1);
            EXPECT_TRUE(says(json, "\"" + key + "\"")) << key;
            EXPECT_TRUE(says(report, key)) << key;
        }
    }
}

TEST(LimitTable, SynonymsOfRowsAreRecognized) {
    int count = 0;
    const auto hinted = [&](const char* name, const Spelling& spelling, std::string_view word) {
        const std::string message =
            refusal_of(scene_text(false, least_jerk, fmt::format("{}{} = 1", word, spelling.suffix)));
        EXPECT_TRUE(says(message, fmt::format("did you mean '{}{}'?", name, spelling.suffix)));
        ++count;
    };
    for (const LimitRow& row : rows_of_cams())
        for (const std::string_view word : row.also_called) hinted(row.name, row.spellings.front(), word);
    for (const PeakLimitRow& row : peak_limit_rows())
        for (const std::string_view word : row.also_called) hinted(row.name(), row.spellings.front(), word);
    EXPECT_GT(count, 0);
}

}  // namespace limit_table_test
}  // namespace camopt
