// SPDX-License-Identifier: MIT
#include "profiles/kinds/cam_kinds.hpp"

#include "profiles/disk/disk_kind.hpp"
#include "profiles/inverse/inverse_kind.hpp"
#include "profiles/remote/remote_kind.hpp"
#include "profiles/spatial/spatial_kind.hpp"

#include <fmt/format.h>

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

std::string cam_types_text() {
    std::string text;
    const std::span<const CamKind> kinds = cam_kinds();
    for (std::size_t i = 0; i < kinds.size(); ++i)
        text += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 < kinds.size() ? ", " : " or ", kinds[i].type);
    return text;
}

}  // namespace camopt
