// SPDX-License-Identifier: MIT
// A mechanism of a scene that is not a plain disk cam: its kind, its numbers, its choices. SI and radians.
#pragma once

#include "scene/cam_spec.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace camopt {

class CamMechanism;

/// A number of the mechanism, or a range in which the optimizer is free.
struct MechanismDimension {
    std::string name;  ///< "coupler"
    Dimension value;   ///< m or rad
    bool is_angle = false;
};

struct MechanismSpec {
    std::string type;  ///< "remote"
    Rotation rotation = Rotation::counterclockwise;
    std::vector<MechanismDimension> dimensions;  ///< all the kind knows, in its own order; unused ones are 0
    std::map<std::string, std::string> choices;  ///< "linkage" → "lever_coupler_slider", …
    /// The formulas. A scene file does not bring them: who reads one completes it (profiles/factory), and an
    /// embedder gives those of the one mechanism he links.
    std::shared_ptr<const CamMechanism> formulas;

    [[nodiscard]] std::vector<double> middle() const {
        std::vector<double> values;
        for (const MechanismDimension& dimension : dimensions) values.push_back(dimension.value.middle());
        return values;
    }
};

}  // namespace camopt
