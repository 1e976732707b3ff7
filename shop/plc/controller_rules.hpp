// SPDX-License-Identifier: MIT
// What controllers make of the numbers of a file, and what some of them can hold: functions that rows of
// plc_formats.cpp name. Where the fields come from: docs/plc.md.
#pragma once

#include "shop/plc/plc_format.hpp"

namespace camopt {

// By the placeholders of elements. Each throws InputError for too few of them.

/// {x}, {s}, {v}, {a} of points.
[[nodiscard]] std::vector<PolynomialPiece> quintics_between_points(const PlcReading& reading);
/// {x}, {s}, {v}, {a}, {j} of points.
[[nodiscard]] std::vector<PolynomialPiece> septics_between_points(const PlcReading& reading);
/// {x}, {s} of points.
[[nodiscard]] std::vector<PolynomialPiece> lines_between_points(const PlcReading& reading);
/// {c0}, {c1}, … of pieces with {x}, else from the end of the piece before, to {to.x}, else to the next {x}
/// and {end.x}.
[[nodiscard]] std::vector<PolynomialPiece> polynomials(const PlcReading& reading);

// Siemens SIMATIC S7-1500T, library LCamHdl: an array of LCamHdl_typeAdvancedElement for
// LCamHdl_CreateCamAdvanced.
//
// Each element has its own s, s', s'' at both ends. camProfileType 5: a polynomial of degree 5; 2: a dwell.
// The block refuses an element whose following value does not change (status 16#820A), so a rest is a dwell,
// and a piece that comes back to where it began is cut in two.
[[nodiscard]] PlcTable siemens_table(const MasterCurve& curve, const PlcOptions& options,
                                     const PlcFormat& format);
[[nodiscard]] std::vector<PolynomialPiece> siemens_elements(const PlcReading& reading);
/// {profile}
[[nodiscard]] double siemens_number(const PlcTable& table, const PolynomialPiece& piece, double theta,
                                    std::string_view name);

// Omron NJ, NX, NY: nodes for MC_GenerateCamTable, which makes a cam table of points from them.
//
// Between two nodes the curve "polynomic 3" with the connecting velocities v (slave units per second, where a
// turn takes CycleTime); with T = CycleTime · (phase of the node − phase before) / (phase of the last):
//
//     d = d₀ + v₀ T t + (3 (d₁ − d₀) − (2 v₀ + v₁) T) t² + ((v₀ + v₁) T − 2 (d₁ − d₀)) t³,  0 <= t <= 1
//
// A point stands every PhasePitch from the node before and at the node. Between points the table is straight,
// so it has no acceleration. Phase 0, displacement 0 is its first point.
[[nodiscard]] std::vector<PolynomialPiece> omron_points(const PlcReading& reading);
/// {velocity}, {cycle}, {pitch}
[[nodiscard]] double omron_number(const PlcTable& table, const PolynomialPiece& piece, double theta,
                                  std::string_view name);

// B&R ACP10: MC_CAMPROFILE_TYP. Polynomials of degree 6 with REAL coefficients, periods as whole units.
//
//     y = a + b t + c t² + d t³ + e t⁴ + f t⁵ + g t⁶,  t = master − end of the polynomial before
//
// x: where a polynomial ends. The drive checks that the first a is 0, that x ascends to MasterPeriod, and
// that y there is SlavePeriod: a warning above a tenth of a unit, refused from one unit on.
[[nodiscard]] double br_master(double theta);
[[nodiscard]] PlcUnits br_units(const MasterCurve& curve);

}  // namespace camopt
