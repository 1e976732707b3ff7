// SPDX-License-Identifier: MIT
// Where the rows of the key table say that values live: what is assigned is found again, and is checked.
#include "scene/key_place.hpp"

#include "core/text/parsing.hpp"
#include "scene/keys/own_rows.hpp"

#include <gtest/gtest.h>

namespace camopt::key_place_test {

bool is_table(const KeyRow& row) {
    return row.type == KeyType::table || row.type == KeyType::text_or_table;
}

/// With every optional part that has a row.
Scene whole_scene() {
    Scene scene;
    for (const KeyRow& row : own_rows())
        if (is_table(row) && row.place.assign) row.place.assign(scene, {}, 0);
    return scene;
}

/// A number that the row allows, SI.
double allowed_number(const Range& range) {
    if (!std::isfinite(range.low)) return std::isfinite(range.high) ? range.high - 0.25 : 0.25;
    return range.low + 0.25 * (std::isfinite(range.high) ? range.high - range.low : 1.0);
}

std::vector<KeyValue> samples_of(const KeyRow& row) {
    std::vector<KeyValue> samples;
    for (const std::string_view choice : row.choices)
        samples.push_back(row.type == KeyType::integer ? KeyValue(integer_in(choice).value())
                                                       : KeyValue(std::string(choice)));
    if (!samples.empty()) return samples;
    if (row.type == KeyType::text) return {std::string("two words")};
    if (row.type == KeyType::boolean) return {true, false};
    if (row.type == KeyType::integer) return {static_cast<long long>(std::max(row.range.low, 2.0))};
    if (row.type == KeyType::number) return {allowed_number(row.range.scaled(row.spellings.front().factor))};
    if (row.type == KeyType::numbers) return {std::vector<double>{0.0, 0.5, 1.0}};
    return {};
}

TEST(KeyPlaces, KeepAssignedValues) {
    int rows = 0;
    for (const KeyRow& row : own_rows()) {
        if (!row.place.assign || is_table(row)) continue;
        SCOPED_TRACE(row.key(row.spellings.front()));
        const std::vector<KeyValue> samples = samples_of(row);
        EXPECT_FALSE(samples.empty());
        for (const KeyValue& sample : samples) {
            Scene scene = whole_scene();
            row.place.assign(scene, sample, row.choices.size());
            EXPECT_EQ(row.place.value(scene), sample);
        }
        ++rows;
    }
    EXPECT_GE(rows, 80);
}

TEST(KeyPlaces, NumbersBelowTheirRangeAreRefused) {
    int rows = 0;
    for (const KeyRow& row : own_rows()) {
        if (!row.place.assign || row.type != KeyType::number || !std::isfinite(row.range.low)) continue;
        Scene scene = whole_scene();
        scene.forces->cam_modulus = 1.0;
        scene.drive->transmission = scene.dynamics->mass = 1.0;
        row.place.assign(scene, (row.range.low - 1.0) * row.spellings.front().factor, 0);
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
            EXPECT_FALSE(row.place.value(scene)) << row.name;
        }
    EXPECT_EQ(scene.forces, std::nullopt);
}

}  // namespace camopt::key_place_test
