// SPDX-License-Identifier: MIT
// What a kind of cam takes where a scene says nothing is what its key table tells the user.
#include "input/keys/scene_keys.hpp"
#include "profiles/kinds/cam_kinds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace camopt {
namespace kind_defaults_test {

/// SI, of "0" or "required for barrel, else 0"; none where the text has no number.
std::optional<double> number_in(const KeyRow& row) {
    double value = 0.0;
    std::string_view text = row.default_text;
    text.remove_prefix(std::min(text.find_first_of("-0123456789"), text.size()));
    if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) return std::nullopt;
    return value * row.spellings.front().factor;
}

TEST(KindDefaults, AreThoseOfTheKeyTable) {
    int compared = 0;
    for (const CamKind& kind : cam_kinds())
        for (const CamVariant& variant : kind.variants)
            for (const CamNumber& number : variant.numbers) {
                if (!number.owned || number.key.empty() || number.per_lift != 0.0) continue;
                SCOPED_TRACE(kind.type + " " + variant.word + ": " + number.table + "." + number.key);
                const KeyRow* row = input::find_row(number.table, number.key);
                ASSERT_NE(row, nullptr);
                const std::optional<double> told = number_in(*row);
                if (!number.value) continue;
                ASSERT_TRUE(told) << row->default_text;
                EXPECT_NEAR(*number.value, *told, 1e-15 * std::abs(*told));
                ++compared;
            }
    EXPECT_GE(compared, 10);
}

}  // namespace kind_defaults_test
}  // namespace camopt
