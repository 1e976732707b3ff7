// SPDX-License-Identifier: MIT
// The formulas of every kind of cam. The only code that depends on all of them; a program with a single kind
// does not link it.
#pragma once

#include "scene/cam_mechanism.hpp"

namespace camopt {

/// CamSpec::make for any kind, including those added by the program (add_cam_kind). Throws InputError for an
/// unknown type or choice.
[[nodiscard]] std::shared_ptr<const CamMechanism> cam_formulas(const CamSpec& spec);

}  // namespace camopt
