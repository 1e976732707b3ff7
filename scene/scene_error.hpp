// SPDX-License-Identifier: MIT
// A fault of a scene as an exception: code that knows the scene's file adds file and line
// (input::fail_in_scene).
#pragma once

#include "core/errors.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// "member: found …; allowed: …"
class SceneError : public InputError {
 public:
    explicit SceneError(SceneFault fault);
    [[nodiscard]] const SceneFault& fault() const { return fault_; }

 private:
    SceneFault fault_;
};

/// "found …; allowed: …"
[[nodiscard]] std::string words_of(const SceneFault& fault);

}  // namespace camopt
