// SPDX-License-Identifier: MIT
// The rows of [tolerance].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;

const Range percents = Range::between(0.0, 100.0);

KeyPlace motion_place(std::size_t order) {
    return stored_in(&Scene::tolerance, &ToleranceSpec::motion, order);
}

KeyPlace number_place(const std::string& name, bool percent) {
    KeyPlace place;
    place.assign = [=](Scene& scene, const KeyValue& value, const KeyAt&) {
        if (scene.tolerance) scene.tolerance->numbers[name] = {std::get<double>(value), percent};
    };
    place.value = [=](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        if (!scene.tolerance) return std::nullopt;
        const auto own = scene.tolerance->numbers.find(name);
        if (own == scene.tolerance->numbers.end() || own->second.percent != percent) return std::nullopt;
        return own->second.size;
    };
    return place;
}

}  // namespace

// A row is read as a row.
// clang-format off
Rows of_tolerance() {
    return {
        called("profile error", {"tolerance", "profile", number, profile_error, not_negative, {}, "0",
         "The largest error of the follower's displacement by that of the profile, to either side.", motion_place(0)}),
        called("slope error", {"tolerance", "slope", number, slope_error, not_negative, {}, "0",
         "The largest error of its derivative by the cam angle.", motion_place(1)}),
        called("acceleration error", {"tolerance", "acceleration", number, acceleration_error, not_negative, {}, "not bounded",
         "The largest error of the second derivative. Without it limits on acceleration, radii and forces leave it out, and say so.",
         motion_place(2)}),
        {"tolerance", "preload", number, force_or_moment, not_negative, {}, "0", "± of `forces.preload`.", number_place("preload", false),
         Availability::needs_forces},
        {"tolerance", "preload_percent", number, plain, percents, {}, "0", "The same in parts of it.", number_place("preload", true),
         Availability::needs_forces, "preload"},
        {"tolerance", "spring_rate", number, spring_rate, not_negative, {}, "0", "± of `forces.spring_rate`.",
         number_place("spring_rate", false), Availability::needs_forces},
        {"tolerance", "spring_rate_percent", number, plain, percents, {}, "0", "The same in parts of it.",
         number_place("spring_rate", true), Availability::needs_forces, "spring_rate"},
    };
}
// clang-format on

KeyRow tolerance_of(const KeyRow& dimension, std::string_view meaning) {
    return {"tolerance",
            dimension.name,
            number,
            dimension.spellings,
            not_negative,
            {},
            "0",
            meaning,
            number_place(std::string(dimension.name), false)};
}

}  // namespace camopt::key_rows
