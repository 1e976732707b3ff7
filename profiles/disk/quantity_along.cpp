// SPDX-License-Identifier: MIT
#include "profiles/disk/quantity_along.hpp"

#include "profiles/disk/disk_sides.hpp"
#include "profiles/disk/quantity_text.hpp"

namespace camopt {
namespace {

struct SourceAlong : StateAlong {
    const DiskCam& cam;

    [[nodiscard]] RangeAlong rest() const { return {rest_position(cam)}; }
    [[nodiscard]] RangeAlong flank_offset() const { return {surface_offset(cam, 0)}; }
    [[nodiscard]] RangeAlong number(DimensionIndex which) const { return {cam[which]}; }
};

}  // namespace

RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which) {
    return formulas::quantity_of_first_side<RangeAlong>(cam, SourceAlong{state, cam}, which);
}

}  // namespace camopt
