// SPDX-License-Identifier: MIT
// The reference law, placed into the scene so that it can be compared with the optimum: the law itself on the
// rise, and for RR its mirror image, stretched to its own angle, on the return.
#pragma once

#include "core/motion.hpp"
#include "core/peaks.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <string>

namespace camopt {

struct ReferenceMotion {
    std::string title;  ///< for people: "modified sine"; empty where the reference is given as numbers
    std::unique_ptr<Motion> motion;
    Peaks peaks;  ///< of the whole motion in this scene, exact; infinite where they are
};

/// motion is empty where the reference is given as numbers, and for a program, whose normalised peaks compare
/// with the law's but which has no single curve beside it. Throws InputError for an unknown law.
[[nodiscard]] ReferenceMotion reference_motion(const Scene& scene);

}  // namespace camopt
