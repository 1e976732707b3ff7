// SPDX-License-Identifier: MIT
#include "scene/cam_spec.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

const char* name_of(Rotation value) {
    return value == Rotation::counterclockwise ? "counterclockwise" : "clockwise";
}

std::shared_ptr<const CamMechanism> CamSpec::formulas() const {
    if (!make)
        throw InputError(
            fmt::format("cam: found a cam of type \"{}\" without formulas; allowed: one that was read, "
                        "or that its kind has made (disk_spec, remote_spec, …)",
                        type));
    return make(*this);
}

std::vector<double> CamSpec::middle() const {
    std::vector<double> values;
    values.reserve(dimensions.size());
    for (const CamDimension& dimension : dimensions) values.push_back(dimension.value.middle());
    return values;
}

const Dimension* CamSpec::find(std::string_view name) const {
    const auto found = std::ranges::find(dimensions, name, &CamDimension::name);
    return found == dimensions.end() ? nullptr : &found->value;
}

std::string CamSpec::choice(const std::string& name) const {
    const auto found = choices.find(name);
    return found == choices.end() ? std::string() : found->second;
}

void refuse_choice(const std::string& name, const std::string& found, const std::string& allowed) {
    throw InputError(fmt::format("{}: found \"{}\"; allowed: {}", name, found, allowed));
}

void CamSpec::set(std::string_view name, const Dimension& value) {
    const auto found = std::ranges::find(dimensions, name, &CamDimension::name);
    if (found == dimensions.end()) {
        std::string names;
        for (const CamDimension& dimension : dimensions)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", dimension.name);
        throw InputError(
            fmt::format("cam.{}: found a dimension that this cam of type \"{}\" does not have; allowed: {}",
                        name, type, names));
    }
    found->value.low = value.low;
    found->value.high = value.high;
    if (value.key.empty()) return;
    found->value.key = value.key;
    found->value.unit = value.unit;
}

}  // namespace camopt
