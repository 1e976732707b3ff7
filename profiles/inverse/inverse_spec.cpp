// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_spec.hpp"

#include "core/text/quantity_text.hpp"
#include "scene/cam_kind.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {

const char* name_of_number(InverseNumber value) {
    static constexpr std::array<const char*, inverse_number_count> names = {
        "roller_radius", "roller_rest",    "roller_end",     "roller_angle",  "roller_from", "pin_distance",
        "pin_angle",     "rocker_pivot_x", "rocker_pivot_y", "feeder_offset", "feeder_start"};
    return names[static_cast<std::size_t>(value)];
}

CamSpec blank_inverse_spec() {
    CamSpec spec;
    spec.type = inverse_type;
    for (int i = 0; i < inverse_number_count; ++i) {
        const auto number = static_cast<InverseNumber>(i);
        const bool angle = number == InverseNumber::roller_angle || number == InverseNumber::pin_angle;
        spec.dimensions.push_back({name_of_number(number), {}, angle});
    }
    return spec;
}

namespace {

using enum KeyType;
using namespace spellings;

// A row is read as a row.
// clang-format off
std::vector<KeyRow> inverse_rows() {
    return {
        {"cam", "roller_rest", number_or_range, length, not_negative, {}, "required for inverse",
         "Distance from the body's pivot at which the roller started from rest; from there its acceleration is "
         "constant."},
        {"cam", "roller_end", number_or_range, length, positive, {}, "required for inverse",
         "The same at the end of the roller's stroke."},
        {"cam", "roller_angle", number_or_range, angle, positive, {}, "required for inverse",
         "Cam angle of that stroke, from rest to its end."},
        {"cam", "roller_return_angle", number, angle, positive, {}, "none",
         "Cam angle in which the roller returns from its end to rest, with constant deceleration: the output then runs "
         "its curve backwards in this time, and its velocity and acceleration there are reported."},
        {"cam", "roller_from", number_or_range, length, positive, {}, "required for inverse",
         "The same distance where the rise begins; between rest and end."},
        {"cam", "pin_distance", number_or_range, length, positive, {}, "required for inverse",
         "From the body's pivot, the origin, to its pin in the rocker's slot."},
        {"cam", "pin_angle", number_or_range, angle, any, {}, "0",
         "Of the pin from the body's x axis."},
        {"cam", "rocker_pivot_x", number_or_range, length, any, {}, "required for inverse",
         "Of the pivot of the slotted rocker."},
        {"cam", "rocker_pivot_y", number_or_range, length, any, {}, "0", "The same."},
        {"cam", "feeder_offset", number_or_range, length, any, {}, "required for inverse",
         "From the rocker's pivot to the line along y on which the feeder slides; not 0."},
        {"cam", "feeder_start", number_or_range, length, any, {}, "required for inverse",
         "y of the feeder at displacement 0."},
    };
}
// clang-format on

constexpr const char* return_key = "roller_return_angle";

/// Its return, behind the numbers of the kind: what is left of the revolution at most.
CamSpec with_return(CamSpec spec, const std::map<std::string, double>& given) {
    const auto found = given.find(return_key);
    if (found == given.end()) return spec;
    const Dimension& forward = spec.dimensions[static_cast<std::size_t>(InverseNumber::roller_angle)].value;
    constexpr double rounding = 1e-6;  // rad: angles that fill the revolution
    if (found->second + forward.low > units::turn + rounding)
        throw SceneError({fmt::format("cam.{}", return_key), angle_text(found->second),
                          fmt::format("at most {}, what the forward stroke leaves of the revolution",
                                      angle_text(units::turn - forward.low))});
    CamDimension dimension{return_key, Dimension(found->second), true};
    dimension.value.key = fmt::format("cam.{}_deg", return_key);
    dimension.value.unit = units::degree;
    spec.dimensions.push_back(std::move(dimension));
    return spec;
}

/// What a scene need not say.
std::optional<double> default_of(InverseNumber number) {
    if (number == InverseNumber::pin_angle || number == InverseNumber::rocker_pivot_y) return 0.0;
    return std::nullopt;
}

}  // namespace

std::optional<double> return_angle(const CamSpec& spec) {
    const Dimension* const back = spec.find(return_key);
    return back == nullptr ? std::nullopt : std::optional(back->low);
}

CamKind inverse_kind() {
    CamKind kind;
    kind.type = inverse_type;
    kind.spoken = "an inverse cam with its feeder";
    CamVariant feeder{
        kind.type, "an inverse cam", false, "a roller, in a guide of the moving body", {}, {}, [] {
            return blank_inverse_spec();
        }};
    for (int i = 0; i < inverse_number_count; ++i) {
        const auto number = static_cast<InverseNumber>(i);
        feeder.numbers.push_back({"cam", name_of_number(number), true, default_of(number), 0.0, i});
    }
    feeder.numbers.push_back({"cam", return_key});
    kind.variants = {feeder};
    kind.add_given = with_return;
    kind.lift_remark = ", the stroke of its feeder";
    kind.has_rotation = false;
    kind.only_drd = true;
    kind.rows = inverse_rows();
    return kind;
}

}  // namespace camopt
