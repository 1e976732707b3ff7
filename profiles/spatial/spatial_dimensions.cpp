// SPDX-License-Identifier: MIT
#include "profiles/spatial/spatial_dimensions.hpp"

#include "core/word_of.hpp"

namespace camopt {

const char* name_of(SpatialDimension value) {
    return word_of<SpatialDimension::lateral_offset>(
        value, {"roller_radius", "arm_length", "center_distance", "lateral_offset"});
}

}  // namespace camopt
