// SPDX-License-Identifier: MIT
#include "profiles/kinds/cam_kinds.hpp"

#include "profiles/disk/disk_kind.hpp"
#include "profiles/inverse/inverse_kind.hpp"
#include "profiles/remote/remote_kind.hpp"
#include "profiles/spatial/spatial_kind.hpp"

#include <algorithm>
#include <array>

namespace camopt {

std::span<const CamKind> cam_kinds() {
    static const std::array kinds = {disk_kind(), remote_kind(), barrel_kind(), cylindrical_kind(),
                                     inverse_kind()};
    return kinds;
}

const CamKind* cam_kind(std::string_view type) {
    const auto found = std::ranges::find(cam_kinds(), type, &CamKind::type);
    return found == cam_kinds().end() ? nullptr : &*found;
}

std::vector<std::string_view> cam_types() {
    std::vector<std::string_view> types;
    for (const CamKind& kind : cam_kinds()) types.emplace_back(kind.type);
    return types;
}

}  // namespace camopt
