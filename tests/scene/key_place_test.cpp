// SPDX-License-Identifier: MIT
// Where the rows of the key table say that values live: what is assigned is found again, and is checked.
#include "scene/key_place.hpp"

#include "core/text/parsing.hpp"
#include "scene/keys/own_rows.hpp"
#include "scene/machine_spec.hpp"

#include <gtest/gtest.h>

namespace camopt::key_place_test {

bool is_table(const KeyRow& row) {
    return row.type == KeyType::table || row.type == KeyType::text_or_table;
}

bool is_of_valve(const KeyRow& row) {
    return row.table.ends_with("_ramp") || row.meaning.starts_with("Type `\"valve\"`");
}

/// With every optional part that has a row, and an entry of each array of tables.
Scene whole_scene() {
    Scene scene;
    scene.motion.speed = 1.0;
    std::vector<KeyRow> rows = own_rows();
    std::ranges::stable_partition(rows, [](const KeyRow& row) { return row.table.empty(); });
    for (const KeyRow& row : rows) {
        if (!row.place->assign) continue;
        if (row.type == KeyType::tables) row.place->assign(scene, 1LL, {});
        if (is_table(row)) row.place->assign(scene, {}, {});
    }
    for (ProgramSegment& segment : scene.motion.segments) segment.angle = 1.0;
    return scene;
}

/// A number that the row allows, SI.
double allowed_number(const Range& range) {
    if (!std::isfinite(range.low)) return std::isfinite(range.high) ? range.high - 0.25 : 0.25;
    return range.low + 0.25 * (std::isfinite(range.high) ? range.high - range.low : 1.0);
}

std::vector<KeyValue> samples_of(const KeyRow& row) {
    if (row.type == KeyType::texts) return {std::vector<std::string>{"one", "two"}};
    std::vector<KeyValue> samples;
    for (const std::string_view choice : row.choices)
        samples.push_back(row.type == KeyType::integer ? KeyValue(integer_in(choice).value())
                                                       : KeyValue(std::string(choice)));
    if (!samples.empty()) return samples;
    if (row.type == KeyType::boolean_or_text) return {true, false, std::string("relative")};
    if (row.type == KeyType::text) return {std::string("two words")};
    if (row.type == KeyType::options) return {KeyOptions{{"name", 1.5}}};
    if (row.type == KeyType::points) return {KeyPairs{{0.0, 1.0}, {2.0, 0.5}}};
    if (row.type == KeyType::number_or_points) return {1.5, KeyPairs{{0.5, 1.0}, {2.0, 0.5}}};
    if (row.type == KeyType::bounds || row.type == KeyType::number_or_bounds)
        return {KeyBounds{-1.0, 2.0}, KeyBounds{std::nullopt, 2.0}};
    if (row.type == KeyType::number_or_range) return {2.0, KeyBounds{1.0, 2.0}};
    if (row.type == KeyType::boolean) return {true, false};
    if (row.name == "rest") return {4LL};  // up to 3 it is written as end_jerk
    if (row.type == KeyType::integer) return {static_cast<long long>(std::max(row.range.low, 2.0))};
    if (row.type == KeyType::number) return {allowed_number(row.range.scaled(row.spellings.front().factor))};
    if (row.type == KeyType::numbers) return {std::vector<double>{0.5, 1.0}};
    return {};
}

TEST(KeyPlaces, KeepAssignedValues) {
    int rows = 0;
    for (const KeyRow& row : own_rows()) {
        if (!row.place->assign || is_table(row) || row.type == KeyType::tables) continue;
        SCOPED_TRACE(std::string(row.table) + "." + row.key(row.spellings.front()));
        const std::vector<KeyValue> samples = samples_of(row);
        EXPECT_FALSE(samples.empty());
        for (const KeyValue& sample : samples) {
            Scene scene = whole_scene();
            if (is_of_valve(row)) scene.motion.valve.emplace();
            scene.motion.lift_is_angle = row.name == "valve_arm";
            if (row.name == "stops" || row.name == "engine_speed")
                scene.written[std::string(row.table) + "." + std::string(row.name)] = row.spellings.front();
            const KeyAt at{.spelling = &row.spellings.front(), .choices = row.choices.size()};
            row.place->assign(scene, sample, at);
            EXPECT_EQ(row.place->value(scene, at), sample);
        }
        ++rows;
    }
    EXPECT_GE(rows, 180);
}

TEST(KeyPlaces, KeepValuesOfMachines) {
    int rows = 0;
    for (const KeyRow& row : machine_rows()) {
        if (!row.place->assign || row.type == KeyType::tables) continue;
        SCOPED_TRACE(std::string(row.table) + "." + row.key(row.spellings.front()));
        const bool is_name = row.table == "axis" && row.name == "name";
        for (const KeyValue& sample :
             is_name ? std::vector<KeyValue>{std::string("three")} : samples_of(row)) {
            MachineSpec machine;
            machine.axes.resize(2);
            machine.axes[0].name = "one";
            machine.axes[1].name = "two";
            machine.clearances.resize(1);
            const KeyAt at{.spelling = &row.spellings.back()};
            row.place->assign(machine, sample, at);
            EXPECT_EQ(row.place->value(machine, at), sample);
        }
        ++rows;
    }
    EXPECT_EQ(rows, 10);
}

TEST(KeyPlaces, RefuseOwnersOfOtherFiles) {
    MachineSpec machine;
    const MachineSpec& unchanged = machine;
    const KeyPlace& title = *machine_rows().front().place;
    title.assign(machine, std::string("Slide"), {});
    EXPECT_EQ(unchanged.title, "Slide");
    Scene scene;
    EXPECT_THROW(title.assign(scene, std::string("Slide"), {}), std::bad_cast);
    EXPECT_THROW(title.assign(unchanged, std::string("Slide"), {}), std::bad_cast);
}

TEST(KeyPlaces, NumbersBelowTheirRangeAreRefused) {
    int rows = 0;
    for (const KeyRow& row : own_rows()) {
        if (!row.place->assign || row.type != KeyType::number || !std::isfinite(row.range.low) ||
            row.place->stored || row.place->entries > 0 || is_of_valve(row))
            continue;
        Scene scene = whole_scene();
        scene.forces->cam_modulus = 1.0;
        scene.drive->transmission = scene.dynamics->mass = 1.0;
        row.place->assign(scene, (row.range.low - 1.0) * row.spellings.front().factor,
                          {.spelling = &row.spellings.front()});
        const std::optional<SceneFault> fault = find_fault(scene);
        ASSERT_TRUE(fault) << row.table << "." << row.name;
        const std::string_view name = row.instead_of.empty() ? row.name : row.instead_of;
        EXPECT_TRUE(fault->member.ends_with(row.name) || fault->member.ends_with(name))
            << row.table << "." << row.name << ": " << fault->member;
        EXPECT_TRUE(fault->member.starts_with(row.table)) << fault->member;
        ++rows;
    }
    EXPECT_GE(rows, 60);
}

TEST(KeyPlaces, AbsentTablesHaveNoValues) {
    const Scene scene;
    for (const KeyRow& row : own_rows())
        if (row.place && (row.table == "forces" || row.table == "dynamics" || row.table == "drive")) {
            EXPECT_FALSE(row.place->value(scene, {})) << row.name;
        }
    EXPECT_EQ(scene.forces, std::nullopt);
}

}  // namespace camopt::key_place_test
