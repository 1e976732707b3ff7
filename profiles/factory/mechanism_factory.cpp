// SPDX-License-Identifier: MIT
#include "profiles/factory/mechanism_factory.hpp"

#include "core/errors.hpp"
#include "profiles/remote/remote_cam.hpp"

#include <fmt/format.h>

namespace camopt {

void complete_mechanism(Scene& scene) {
    if (!scene.mechanism) return;
    MechanismSpec& spec = *scene.mechanism;
    if (spec.type != "remote")
        throw InputError(fmt::format("cam.type: found \"{}\"; allowed: \"disk\" or \"remote\"", spec.type));
    spec.formulas = std::make_shared<RemoteCam>(spec);
    validate(scene);
}

}  // namespace camopt
