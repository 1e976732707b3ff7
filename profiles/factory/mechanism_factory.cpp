// SPDX-License-Identifier: MIT
#include "profiles/factory/mechanism_factory.hpp"

#include "core/errors.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/spatial/spatial_mechanism.hpp"

#include <fmt/format.h>

namespace camopt {

void complete_mechanism(Scene& scene) {
    if (!scene.mechanism) return;
    MechanismSpec& spec = *scene.mechanism;
    if (spec.type == "remote")
        spec.formulas = std::make_shared<RemoteCam>(spec);
    else if (spec.type == "barrel" || spec.type == "cylindrical")
        spec.formulas = spatial_mechanism(spec);
    else if (spec.type == "inverse")
        spec.formulas = inverse_mechanism(spec);
    else
        throw InputError(
            fmt::format("cam.type: found \"{}\"; allowed: \"disk\", \"remote\", \"barrel\", \"cylindrical\" "
                        "or \"inverse\"",
                        spec.type));
    validate(scene);
}

}  // namespace camopt
