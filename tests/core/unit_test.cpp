// SPDX-License-Identifier: MIT
// The grammar of units: factors are compared with numbers computed by hand.
#include "core/unit.hpp"

#include <gtest/gtest.h>

namespace camopt::unit_test {

TEST(Units, FactorFollowsFromTheSymbols) {
    EXPECT_DOUBLE_EQ(unit_named<"mm/s^3">.factor, 0.001);
    EXPECT_DOUBLE_EQ(unit_named<"in/rad^2">.factor, 0.0254);
    EXPECT_DOUBLE_EQ(unit_named<"mm/deg">.factor, 0.05729577951308232);  // 0.001 · 180/π
    EXPECT_DOUBLE_EQ(unit_named<"mm/deg^2">.factor, 3.282806350011744);
    EXPECT_DOUBLE_EQ(unit_named<"mm/deg^3">.factor, 188.09094881441945);
    EXPECT_DOUBLE_EQ(unit_named<"in/deg">.factor, 1.455312799632291);
    EXPECT_DOUBLE_EQ(unit_named<"deg/deg">.factor, 1.0);
    EXPECT_DOUBLE_EQ(unit_named<"deg/deg^2">.factor, 57.29577951308232);
    EXPECT_DOUBLE_EQ(unit_named<"rad/rad^3">.factor, 1.0);
    EXPECT_DOUBLE_EQ(unit_named<"crank deg">.factor, 0.008726646259971648);  // π/360
    EXPECT_DOUBLE_EQ(unit_named<"rpm">.factor, 0.10471975511965977);
    EXPECT_DOUBLE_EQ(unit_named<"mm/rev">.factor, 0.00015915494309189535);
    EXPECT_DOUBLE_EQ(unit_named<"N/mm">.factor, 1000.0);
    EXPECT_DOUBLE_EQ(unit_named<"N m/deg">.factor, 57.29577951308232);
    EXPECT_DOUBLE_EQ(unit_named<"lbf in">.factor, 0.11298482902761671);
    EXPECT_DOUBLE_EQ(unit_named<"lbf/in">.factor, 175.12683524647645);
    EXPECT_DOUBLE_EQ(unit_named<"lb/in^3">.factor, 27679.904710203125);
    EXPECT_DOUBLE_EQ(unit_named<"g/cm^3">.factor, 1000.0);
    EXPECT_NEAR(unit_named<"ksi">.factor, 6894757.293168361, 1e-8);
    EXPECT_EQ(unit_named<"">.factor, 1.0);
}

struct Written {
    const Spelling& unit;
    const char *suffix, *name, *sign;
};

TEST(Units, SymbolsGiveSuffixNameAndSign) {
    const std::array rows = {Written{unit_named<"m/s^2">, "_m_s2", "m/s^2", "m/s²"},
                             Written{unit_named<"mm/rad^3">, "_mm_rad3", "mm/rad^3", "mm/rad³"},
                             Written{unit_named<"um">, "_um", "um", "µm"},
                             Written{unit_named<"Hz">, "_hz", "Hz", "Hz"},
                             Written{unit_named<"crank deg">, "_crank_deg", "crank deg", "crank deg"},
                             Written{unit_named<"N m">, "_nm", "N m", "N m"},
                             Written{unit_named<"N/m">, "_n_m", "N/m", "N/m"},
                             Written{unit_named<"N m s/rad">, "_nm_s_rad", "N m s/rad", "N m s/rad"},
                             Written{unit_named<"lbf in/rad">, "_lbf_in_rad", "lbf in/rad", "lbf in/rad"},
                             Written{unit_named<"kg m^2">, "_kg_m2", "kg m^2", "kg m²"},
                             Written{unit_named<"in/rev">, "_in_per_rev", "in/rev", "in/rev"},
                             Written{unit_named<"">, "", "", ""}};
    for (const auto& [unit, suffix, name, sign] : rows) {
        EXPECT_EQ(unit.suffix, suffix);
        EXPECT_EQ(unit.unit, name);
        EXPECT_EQ(unit.sign, sign);
    }
}

TEST(Units, QuantitiesAreComparedAcrossSystems) {
    EXPECT_EQ(unit_named<"mm/s">.quantity, unit_named<"in/s">.quantity);
    EXPECT_EQ(unit_named<"N m">.quantity, unit_named<"lbf in">.quantity);
    EXPECT_EQ(unit_named<"rpm">.quantity, unit_named<"rad/s">.quantity);
    EXPECT_NE(unit_named<"mm/s">.quantity, unit_named<"mm/rad">.quantity);
    EXPECT_NE(unit_named<"N m">.quantity, unit_named<"N/m">.quantity);
    EXPECT_NE(unit_named<"deg">.quantity, unit_named<"crank deg">.quantity);
    EXPECT_EQ(unit_named<"mm/deg">.system, UnitSystem::metric);
    EXPECT_EQ(unit_named<"lbf/in">.system, UnitSystem::imperial);
    EXPECT_EQ(unit_named<"deg/s">.system, UnitSystem::both);
}

std::string_view unit_of(std::string_view key) {
    const Spelling* const unit = unit_of_key(key);
    return unit != nullptr ? unit->unit : "none";
}

TEST(Units, KeyEndsInItsUnit) {
    EXPECT_EQ(unit_of("limits.velocity_mm_rad"), "mm/rad");
    EXPECT_EQ(unit_of("limits.acceleration_rad_rad2"), "rad/rad^2");
    EXPECT_EQ(unit_of("motion.rise_crank_deg"), "crank deg");
    EXPECT_EQ(unit_of("cam.base_radius_m"), "m");
    EXPECT_EQ(unit_of("dynamics.stiffness_n_m"), "N/m");
    EXPECT_EQ(unit_of("dynamics.stiffness_n_m_rad"), "N m/rad");
    EXPECT_EQ(unit_of("forces.preload_nm"), "N m");
    EXPECT_EQ(unit_of("forces.spring_rate_lbf_in"), "lbf/in");
    EXPECT_EQ(unit_of("limits.torque_max_lbf_in"), "lbf in");
    EXPECT_EQ(unit_of("drawing.density_lb_in3"), "lb/in^3");
    EXPECT_EQ(unit_of("drive.transmission_mm_per_rev"), "mm/rev");
    EXPECT_EQ(unit_of("limits.undercut_margin"), "none");
    EXPECT_EQ(unit_of("limits.cam_radius_min"), "none");
}

}  // namespace camopt::unit_test
