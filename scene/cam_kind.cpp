// SPDX-License-Identifier: MIT
#include "scene/cam_kind.hpp"

#include <algorithm>

namespace camopt {

bool CamKind::knows(std::string_view table, std::string_view key) const {
    const auto is_it = [&](const auto& entry) { return entry.table == table && entry.key == key; };
    if (table == "cam" && (key == "type" || (key == "rotation" && has_rotation))) return true;
    if (!choosing_key.empty() && table == choosing_table && key == choosing_key) return true;
    if (table.empty()) return key == choosing_table && key != "cam";
    return std::ranges::any_of(variants, [&](const CamVariant& variant) {
        return std::ranges::any_of(variant.numbers, is_it) || std::ranges::any_of(variant.choices, is_it);
    });
}

const CamVariant* CamKind::variant(std::string_view word) const {
    const auto found = std::ranges::find(variants, word, &CamVariant::word);
    return found == variants.end() ? nullptr : &*found;
}

}  // namespace camopt
