// SPDX-License-Identifier: MIT
// The figures a cam is judged by: extremes over every cam angle, found between the samples too.
#pragma once

#include "core/motion.hpp"
#include "profiles/sampling.hpp"
#include "scene/scene.hpp"
#include "studies/delivered/extremes_along.hpp"

#include <optional>

namespace camopt {

struct ForceSummary {
    CamExtreme least_force, largest_force;  ///< F (N) or M (N m), see ForceSpec
    CamExtreme torque;                      ///< largest |camshaft torque|, N m
    /// Infinite where the cam cannot be touched as designed (CamSummary::no_contact).
    std::optional<CamExtreme> normal_force;    ///< largest force along the normal, N
    std::optional<CamExtreme> hertz_pressure;  ///< Pa; with a contact width, not for a knife edge
};

struct CamSummary {
    CamExtreme pressure_angle;  ///< largest |φ|
    CamExtreme rise_pressure_angle,
        return_pressure_angle;       ///< of the parts where s' > 0, s' < 0; 0 where none
    CamExtreme rest_pressure_angle;  ///< where the follower is known to rest (rest_places.hpp)
    /// Least, of the cam surface; <= 0 is undercut. −infinity where a flat face turns back.
    CamExtreme convex_radius;
    std::optional<CamExtreme> concave_radius;  ///< least, > 0; none where the cam is nowhere concave
    /// Least; <= 0: undercut. Where an oscillating flat face turns back, 1 + σψ' in its place: not above 0
    /// either.
    CamExtreme regularity;
    CamExtreme contact_offset;  ///< largest magnitude on a flat face, else 0; may be infinite
    /// x of a place where the follower cannot touch the cam as designed: undercut, a face that turns back, a
    /// contact below the cam's centre. None where it can everywhere.
    std::optional<double> no_contact;
    std::optional<ForceSummary> forces;  ///< where the scene has forces and a speed

    [[nodiscard]] bool undercut() const { return !(regularity.value > 0.0); }
};

[[nodiscard]] CamSummary cam_summary(const DiskCam& cam, const Motion& motion, const Scene& scene);

}  // namespace camopt
