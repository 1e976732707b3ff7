// SPDX-License-Identifier: MIT
//
// Terms and limits on the response of an elastic follower train, as linear rules.
//
//   residual              Σ_modes |r_k · X(end)| <= level, for every direction φ:
//                         Σ Re(e^{−iφ_k} r_k · X) <= level
//   dynamic_acceleration  ± x''_n <= level, at every x
//   contact force         least − F <= 0, at every x
//
// at every speed of the range. X is linear in the motion, so each is a linear row for its setting, and the
// residual's rows together are a second-order cone. setting = (speed, event, then directions or the sign).
#pragma once

#include "objectives/response/train_figures.hpp"
#include "objectives/rules/model.hpp"
#include "scene/limit_table.hpp"

#include <mutex>

namespace camopt {

enum class ResponseKind { residual, acceleration, contact_force };

/// The largest over events and speeds. value in lifts, lifts by x²; of the contact force the least, N or N m.
struct WorstResponse {
    double value = 0.0;
    double speed = 0.0;  ///< rad/s
    double at = 0.0;     ///< x; of the residual where its event ends
};
[[nodiscard]] WorstResponse worst_response(const Scene& scene, ResponseKind kind, const Motion& motion);
/// The same of one rise from rest, of a law on [0, 1].
[[nodiscard]] WorstResponse worst_response_of_rise(const Scene& scene, ResponseKind kind, const Motion& law);

/// The divisor of a term: the number of the scene, or the reference law's own. Throws InputError if the law
/// has none (it does not vibrate at this speed).
[[nodiscard]] double response_reference(const Scene& scene, const ResponseTerm& term);
[[nodiscard]] ResponseKind kind_of(ResponseFigure figure);

/// Adds the terms and limits of the scene's dynamics, if any.
void add_response_rules(CamModel& model, const Scene& scene);

}  // namespace camopt
