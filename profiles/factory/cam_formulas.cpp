// SPDX-License-Identifier: MIT
#include "profiles/factory/cam_formulas.hpp"

#include "profiles/kinds/cam_kinds.hpp"
#include "profiles/kinds/kind_rows.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {

std::shared_ptr<const CamMechanism> cam_formulas(const CamSpec& spec) {
    const std::span<const CamKind> kinds = cam_kinds();
    const auto kind = std::ranges::find(kinds, spec.type, &CamKind::type);
    if (kind == kinds.end())
        throw SceneError({"cam.type", fmt::format("\"{}\"", spec.type), quoted_choices(cam_types())});
    if (kind->formulas) return kind->formulas(spec);
    return kind_rows::All::formulas(static_cast<std::size_t>(kind - kinds.begin()), spec);
}

}  // namespace camopt
