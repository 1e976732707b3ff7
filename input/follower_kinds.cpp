// SPDX-License-Identifier: MIT
#include "input/follower_kinds.hpp"

#include "input/keys/scene_keys.hpp"
#include "profiles/kinds/cam_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::input {
namespace {

/// Adds nothing for a number without a key, or one twice.
void add_key(FollowerKind& kind, const CamNumber& number) {
    const KeyRow* const row = number.owned ? find_row(number.table, number.key) : nullptr;
    if (!row) return;
    const std::string key = row->key(row->spellings.front());
    const std::string written = row->table == "cam" ? key : fmt::format("{}.{}", row->table, key);
    if (std::ranges::find(kind.keys, written) == kind.keys.end()) kind.keys.push_back(written);
}

}  // namespace

std::vector<FollowerKind> follower_kinds() {
    std::vector<FollowerKind> all;
    for (const CamKind& cam : cam_kinds())
        for (const CamVariant& variant : cam.variants) {
            FollowerKind kind{cam.type, {}, variant.word, variant.swings, variant.touches_with, {}};
            if (!cam.choosing_key.empty())
                kind.chosen_by = fmt::format("{}.{}", cam.choosing_table, cam.choosing_key);
            for (const CamNumber& number : variant.numbers) add_key(kind, number);
            all.push_back(std::move(kind));
        }
    return all;
}

}  // namespace camopt::input
