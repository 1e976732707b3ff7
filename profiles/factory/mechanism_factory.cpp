// SPDX-License-Identifier: MIT
#include "profiles/factory/mechanism_factory.hpp"

#include "profiles/inverse/inverse_mechanism.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/remote/remote_spec.hpp"
#include "profiles/spatial/spatial_mechanism.hpp"
#include "profiles/spatial/spatial_spec.hpp"
#include "scene/scene_error.hpp"

#include <fmt/format.h>

#include <map>

namespace camopt {

namespace {

using Formulas = std::shared_ptr<const CamMechanism>;
using Maker = Formulas (*)(const MechanismSpec&);

/// The formulas of each kind: a new kind is its leaf and a line here.
const std::map<std::string, Maker>& makers() {
    static const std::map<std::string, Maker> all = {
        {remote_type,
         [](const MechanismSpec& spec) -> Formulas { return std::make_shared<RemoteCam>(spec); }},
        {barrel_type, [](const MechanismSpec& spec) -> Formulas { return spatial_mechanism(spec); }},
        {cylindrical_type, [](const MechanismSpec& spec) -> Formulas { return spatial_mechanism(spec); }},
        {inverse_type, [](const MechanismSpec& spec) -> Formulas { return inverse_mechanism(spec); }},
    };
    return all;
}

}  // namespace

void complete_mechanism(Scene& scene) {
    if (!scene.mechanism) return;
    MechanismSpec& spec = *scene.mechanism;
    if (const CamKind* const kind = cam_kind(spec.type); kind != nullptr && kind->formulas) {
        spec.formulas = kind->formulas(spec);
        validate(scene);
        return;
    }
    const auto found = makers().find(spec.type);
    if (found == makers().end())
        throw SceneError({"cam.type", fmt::format("\"{}\"", spec.type), quoted_choices(cam_types())});
    spec.formulas = found->second(spec);
    validate(scene);
}

}  // namespace camopt
