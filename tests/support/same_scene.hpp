// SPDX-License-Identifier: MIT
// Two scenes part by part, for tests of what is written and read again.
#pragma once

#include "scene/scene.hpp"

namespace camopt::testing_support {

/// The parts that differ, "motion cam"; empty: the scenes are equal to the last bit. Formulas, rules of
/// programs and how the numbers were written are not compared.
[[nodiscard]] inline std::string differing_parts(const Scene& one, const Scene& other) {
    std::string parts;
    const auto compare = [&](const char* name, bool same) {
        if (!same) parts += (parts.empty() ? "" : " ") + std::string(name);
    };
    const auto without_formulas = [](std::optional<DynamicsSpec> dynamics) {
        if (dynamics) dynamics->formulas.reset();
        return dynamics;
    };
    compare("title", one.title == other.title);
    compare("length_unit", one.length_unit == other.length_unit);
    compare("motion", one.motion == other.motion);
    compare("spline", one.spline == other.spline);
    compare("objective", one.objective == other.objective);
    compare("cam", one.cam.has_value() == other.cam.has_value());
    if (one.cam && other.cam) {
        compare("cam.type", one.cam->type == other.cam->type);
        compare("cam.rotation", one.cam->rotation == other.cam->rotation);
        compare("cam.dimensions", one.cam->dimensions == other.cam->dimensions);
        compare("cam.choices", one.cam->choices == other.cam->choices);
        compare("cam.face_half_width", one.cam->face_half_width == other.cam->face_half_width);
        compare("cam.face_radius", one.cam->face_radius == other.cam->face_radius);
    }
    compare("forces", one.forces == other.forces);
    compare("limits", one.limits == other.limits);
    compare("dynamics", without_formulas(one.dynamics) == without_formulas(other.dynamics));
    compare("drive", one.drive == other.drive);
    compare("measured", one.measured == other.measured);
    compare("measured_rows", one.measured_rows == other.measured_rows);
    compare("drawing", one.drawing == other.drawing);
    compare("solver", one.solver == other.solver);
    return parts;
}

}  // namespace camopt::testing_support
