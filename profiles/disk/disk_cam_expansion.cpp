// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_cam_expansion.hpp"

#include "profiles/disk/disk_cam_formulas.hpp"

namespace camopt::expansion {
namespace {

using enum DimensionIndex;

// Position of the follower on the base circle, by the dimensions.

/// The start as a function of the prime radius (base radius without a roller) and further dimensions.
template <int count>
QuantityValue by_dimensions(const DiskCam& cam, const SecondOrder<count + 1>& start,
                            const std::array<DimensionIndex, static_cast<std::size_t>(count)>& further) {
    Jacobian<count + 1> jacobian = Jacobian<count + 1>::Zero();
    jacobian(0, column_of(base_radius)) = 1.0;
    if (has_roller(cam.follower)) jacobian(0, column_of(roller_radius)) = 1.0;
    int row = 0;
    for (const DimensionIndex dimension : further) jacobian(++row, column_of(dimension)) = 1.0;
    return Expansion<count + 1>(start).substituted(jacobian);
}

QuantityValue translating_roller_start(const DiskCam& cam, double prime_radius) {
    const auto prime = variable<2>(prime_radius, 0), offset_variable = variable<2>(cam[offset], 1);
    return by_dimensions<1>(cam, formulas::translating_roller_start(prime, offset_variable), {offset});
}

QuantityValue oscillating_roller_start(const DiskCam& cam, double prime_radius) {
    const auto prime = variable<3>(prime_radius, 0), distance = variable<3>(cam[center_distance], 1),
               arm = variable<3>(cam[arm_length], 2);
    return by_dimensions<2>(cam, formulas::oscillating_roller_start(prime, distance, arm),
                            {center_distance, arm_length});
}

QuantityValue oscillating_flat_start(const DiskCam& cam) {
    const auto base = variable<3>(cam[base_radius], 0), distance = variable<3>(cam[center_distance], 1),
               face = variable<3>(cam[face_offset], 2);
    return by_dimensions<2>(cam, formulas::oscillating_flat_start(base, distance, face),
                            {center_distance, face_offset});
}

}  // namespace

QuantityValue start_of(const DiskCam& cam) {
    switch (cam.follower) {
        case FollowerType::translating_roller:
            return translating_roller_start(cam, cam[base_radius] + cam[roller_radius]);
        case FollowerType::translating_knife:
            return translating_roller_start(cam, cam[base_radius]);
        case FollowerType::translating_flat:
            return variable_quantity(cam[base_radius], column_of(base_radius));
        case FollowerType::oscillating_roller:
            return oscillating_roller_start(cam, cam[base_radius] + cam[roller_radius]);
        case FollowerType::oscillating_flat:
            return oscillating_flat_start(cam);
    }
    throw ModelError("quantity: a follower of no known type");
}

}  // namespace camopt::expansion
