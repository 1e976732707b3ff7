// SPDX-License-Identifier: MIT
// The formulas of every kind of cam: the one place that knows them all. A program that links a single kind
// does without it.
#pragma once

#include "scene/cam_mechanism.hpp"
#include "scene/cam_spec.hpp"

#include <memory>

namespace camopt {

/// What CamSpec::make may be of any kind, the program's own (add_cam_kind) among them. Throws InputError for
/// a type or a choice that does not exist.
[[nodiscard]] std::shared_ptr<const CamMechanism> cam_formulas(const CamSpec& spec);

}  // namespace camopt
