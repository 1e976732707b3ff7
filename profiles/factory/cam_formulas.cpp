// SPDX-License-Identifier: MIT
#include "profiles/factory/cam_formulas.hpp"

#include "profiles/disk/disk_cam.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Maker = std::shared_ptr<const CamMechanism> (*)(const CamSpec&);

/// The formulas of each kind: a new kind needs its leaf and a line here.
const std::map<std::string, Maker>& makers() {
    static const std::map<std::string, Maker> all = {
        {disk_type, disk_formulas},        {remote_type, remote_mechanism},
        {barrel_type, spatial_mechanism},  {cylindrical_type, spatial_mechanism},
        {inverse_type, inverse_mechanism},
    };
    return all;
}

}  // namespace

std::shared_ptr<const CamMechanism> cam_formulas(const CamSpec& spec) {
    if (const CamKind* const kind = cam_kind(spec.type); kind != nullptr && kind->formulas)
        return kind->formulas(spec);
    const auto found = makers().find(spec.type);
    if (found == makers().end())
        throw SceneError({"cam.type", fmt::format("\"{}\"", spec.type), quoted_choices(cam_types())});
    return found->second(spec);
}

}  // namespace camopt
