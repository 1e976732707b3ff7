// SPDX-License-Identifier: MIT
#include "scene/cam_mechanism.hpp"

#include "core/errors.hpp"
#include "core/text/list_text.hpp"
#include "core/units.hpp"
#include "scene/cam_flanks.hpp"

#include <fmt/format.h>

namespace camopt {

const char* name_of(Rotation value) {
    return value == Rotation::counterclockwise ? "counterclockwise" : "clockwise";
}

const char* name_of(Projection value) {
    return value == Projection::first_angle ? "first_angle" : "third_angle";
}

ForceSpec::Load ForceSpec::load_at(double angle, Side side) const {
    if (load.empty()) return {};
    if (load.size() == 1) return {load.front()[1], 0.0};
    const double first = load.front()[0];
    double at = angle - units::turn * std::floor((angle - first) / units::turn);
    if (side == Side::left && at == first) at += units::turn;
    const auto after = std::ranges::find_if(load, [&](const std::array<double, 2>& point) {
        return side == Side::left ? point[0] >= at : point[0] > at;
    });
    const std::array<double, 2>& begin = after == load.begin() ? load.front() : *(after - 1);
    const std::array<double, 2> end =
        after == load.end() ? std::array{first + units::turn, load.front()[1]} : *after;
    const double slope = end[0] > begin[0] ? (end[1] - begin[1]) / (end[0] - begin[0]) : 0.0;
    return {begin[1] + slope * (at - begin[0]), slope};
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

std::string written_name(const Dimension& value) {
    std::string name = value.key.substr(value.key.find('.') + 1);
    if (const Spelling* const unit = unit_of_key(value.key)) name.resize(name.size() - unit->suffix.size());
    return name;
}

int CamSpec::written_as(std::string_view name) const {
    const auto found = std::ranges::find_if(
        dimensions, [&](const CamDimension& one) { return written_name(one.value) == name; });
    return found == dimensions.end() ? -1 : static_cast<int>(found - dimensions.begin());
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
        throw InputError(
            fmt::format("cam.{}: found a dimension that this cam of type \"{}\" does not have; allowed: {}",
                        name, type, listed(dimensions, ", ", &CamDimension::name)));
    }
    found->value.low = value.low;
    found->value.high = value.high;
    if (value.key.empty()) return;
    found->value.key = value.key;
    found->value.unit = value.unit;
}

void refuse_quantity(std::string_view mechanism) {
    throw ModelError(fmt::format("quantity: a {} cam or follower has no such quantity", mechanism));
}

MechanismValue CamMechanism::pressure_excess(double limit, int sign, const MechanismState& state, int station,
                                             std::span<const int> active) const {
    return sign * std::cos(limit) * quantity(MechanismQuantity::pressure_numerator, state, station, active) +
           -std::sin(limit) * quantity(MechanismQuantity::pressure_denominator, state, station, active);
}

const LimitStructure& CamMechanism::limit_structure() const {
    static const LimitStructure none;
    return none;
}

std::optional<CamFlanks> CamMechanism::flanks(std::span<const double> /*dimensions*/) const {
    return std::nullopt;
}

std::optional<RollerGuide> CamMechanism::guide(std::span<const double> /*dimensions*/) const {
    return std::nullopt;
}

}  // namespace camopt
