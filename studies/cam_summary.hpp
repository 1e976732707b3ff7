// SPDX-License-Identifier: MIT
// The figures a cam is judged by: extremes over every cam angle, found between the samples too.
#pragma once

#include "core/motion.hpp"
#include "core/scene.hpp"
#include "profiles/sampling.hpp"
#include "studies/extremes_along.hpp"

#include <optional>

namespace camopt {

struct ForceSummary {
    CamExtreme least_force, largest_force;     ///< F (N) or M (N m), see ForceSpec
    CamExtreme torque;                         ///< largest |camshaft torque|, N m
    std::optional<CamExtreme> normal_force;    ///< largest force along the normal, N
    std::optional<CamExtreme> hertz_pressure;  ///< Pa; with a contact width, not for a knife edge
};

struct CamSummary {
    CamExtreme pressure_angle;  ///< largest |φ|
    CamExtreme rise_pressure_angle,
        return_pressure_angle;                 ///< of the parts where s' > 0, s' < 0; 0 where none
    CamExtreme convex_radius;                  ///< least, of the cam surface; <= 0 is undercut
    std::optional<CamExtreme> concave_radius;  ///< least, > 0; none where the cam is nowhere concave
    CamExtreme regularity;                     ///< least; <= 0: undercut
    CamExtreme contact_offset;                 ///< largest magnitude on a flat face, else 0
    std::optional<ForceSummary> forces;        ///< where the scene has forces and a speed

    [[nodiscard]] bool undercut() const { return !(regularity.value > 0.0); }
};

[[nodiscard]] CamSummary cam_summary(const DiskCam& cam, const Motion& motion, const Scene& scene);

}  // namespace camopt
