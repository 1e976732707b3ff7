// SPDX-License-Identifier: MIT
#include "output/words/display_scale.hpp"

#include "core/units.hpp"

#include <cmath>
#include <cstddef>

namespace camopt {

namespace {

void fill_factors(DerivativeScale& scale, double output, double per_x) {
    for (std::size_t r = 0; r < scale.factor.size(); ++r)
        scale.factor[r] = output / std::pow(per_x, static_cast<int>(r));
}

DerivativeScale scale_by_angle(const MotionSpec& motion) {
    DerivativeScale scale;
    if (motion.lift_is_angle) {
        fill_factors(scale, motion.lift / units::degree, motion.unit_angle() / units::degree);
        scale.unit = {"deg", "deg/deg", "deg/deg²", "deg/deg³"};
        scale.column = {"s_deg", "ds_deg_deg", "dds_deg_deg2", "ddds_deg_deg3"};
    } else {
        fill_factors(scale, motion.lift / units::millimetre, motion.unit_angle());
        scale.unit = {"mm", "mm/rad", "mm/rad²", "mm/rad³"};
        scale.column = {"s_mm", "ds_mm_rad", "dds_mm_rad2", "ddds_mm_rad3"};
    }
    return scale;
}

DerivativeScale scale_by_time(const MotionSpec& motion, double seconds_per_x) {
    DerivativeScale scale;
    if (motion.lift_is_angle) {
        fill_factors(scale, motion.lift / units::degree, seconds_per_x);
        scale.unit = {"deg", "deg/s", "deg/s²", "deg/s³"};
        scale.column = {"s_deg", "v_deg_s", "a_deg_s2", "j_deg_s3"};
    } else {
        fill_factors(scale, motion.lift / units::millimetre, seconds_per_x);
        scale.unit = {"mm", "mm/s", "mm/s²", "mm/s³"};
        scale.column = {"s_mm", "v_mm_s", "a_mm_s2", "j_mm_s3"};
    }
    return scale;
}

}  // namespace

DisplayScale display_scale(const MotionSpec& motion) {
    DisplayScale scale;
    scale.degrees_per_x = motion.unit_angle() / units::degree;
    scale.by_angle = scale_by_angle(motion);
    if (motion.speed) {
        scale.seconds_per_x = motion.unit_angle() / *motion.speed;
        scale.by_time = scale_by_time(motion, scale.seconds_per_x);
    }
    return scale;
}

}  // namespace camopt
