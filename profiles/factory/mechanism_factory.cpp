// SPDX-License-Identifier: MIT
#include "profiles/factory/mechanism_factory.hpp"

#include "core/errors.hpp"
#include "profiles/factory/cam_kinds.hpp"

#include <fmt/format.h>

namespace camopt {

void complete_mechanism(Scene& scene) {
    if (!scene.mechanism) return;
    MechanismSpec& spec = *scene.mechanism;
    const CamKind* const kind = cam_kind(spec.type);
    if (!kind || !kind->formulas)
        throw InputError(fmt::format("cam.type: found \"{}\"; allowed: {}", spec.type, cam_types_text()));
    spec.formulas = kind->formulas(spec);
    validate(scene);
}

}  // namespace camopt
