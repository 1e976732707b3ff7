// SPDX-License-Identifier: MIT
#include "input/follower_kinds.hpp"

#include "input/scene_keys.hpp"
#include "input/spatial_reader.hpp"
#include "scene/inverse_spec.hpp"
#include "scene/remote_spec.hpp"
#include "scene/spatial_spec.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::input {
namespace {

/// Adds nothing for an empty name, or one twice.
void add_key(FollowerKind& kind, std::string_view table, std::string_view name) {
    for (const KeyRow& row : scene_keys()) {
        if (row.table != table || row.name != name || name.empty()) continue;
        const std::string key = row.key(row.spellings.front());
        const std::string written = table == "cam" ? key : fmt::format("{}.{}", table, key);
        if (std::ranges::find(kind.keys, written) == kind.keys.end()) kind.keys.push_back(written);
    }
}

const char* touched_with(ContactKind contact) {
    if (contact == ContactKind::roller) return "a roller";
    return contact == ContactKind::flat ? "a flat face" : "a knife edge";
}

void add_disks(std::vector<FollowerKind>& all) {
    for (const Follower& follower : followers) {
        FollowerKind kind{
            "disk", "cam.follower", follower.name, follower.oscillates, touched_with(follower.contact), {}};
        for (int i = 0; i < dimension_count; ++i)
            if (const auto which = static_cast<DimensionIndex>(i); follower.has(which))
                add_key(kind, "cam", name_of(which));
        if (follower.has_face_width) add_key(kind, "cam", "face_half_width");
        all.push_back(std::move(kind));
    }
}

void add_linkages(std::vector<FollowerKind>& all) {
    using enum RemoteLinkage;
    for (const RemoteLinkage linkage :
         {lever, lever_coupler_slider, lever_coupler_lever, lever_coupler_lever_coupler_slider}) {
        FollowerKind kind{"remote", "linkage.type", name_of(linkage), output_swings(linkage), "a roller", {}};
        for (int i = 0; i < remote_dimension_count; ++i)
            if (const auto which = static_cast<RemoteDimension>(i); has_dimension(linkage, which))
                add_key(kind, table_of(which), name_of(which));
        all.push_back(std::move(kind));
    }
}

void add_drums(std::vector<FollowerKind>& all) {
    using enum SpatialFollower;
    for (const SpatialFollower follower : {barrel, cylindrical_rotating, cylindrical_translating}) {
        FollowerKind kind{"cylindrical",    "cam.follower",         "rotating",
                          swings(follower), "a roller in a groove", {}};
        if (follower == barrel) kind = {"barrel", "", "barrel", true, "the rollers of an index", {}};
        if (follower == cylindrical_translating) kind.word = "translating";
        for (int i = 0; i < spatial_number_count; ++i)
            add_key(kind, "cam", spatial_key(follower, static_cast<SpatialNumber>(i)));
        all.push_back(std::move(kind));
    }
}

void add_inverse(std::vector<FollowerKind>& all) {
    FollowerKind kind{"inverse", "", "inverse", false, "a roller, in a guide of the moving body", {}};
    for (int i = 0; i < inverse_number_count; ++i)
        add_key(kind, "cam", name_of_number(static_cast<InverseNumber>(i)));
    all.push_back(std::move(kind));
}

}  // namespace

std::vector<FollowerKind> follower_kinds() {
    std::vector<FollowerKind> all;
    add_disks(all);
    add_linkages(all);
    add_drums(all);
    add_inverse(all);
    return all;
}

}  // namespace camopt::input
