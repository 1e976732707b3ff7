// SPDX-License-Identifier: MIT
// The delivered motion as electronic cams: the files, what reading them back as the controllers do found, and
// plc.json, which says it for programs.
//
// lossless: over one revolution s stays within 1e-12 of the lift, and s', s'', s''' within 1e-9 of their
// peaks (they magnify the rounding of s).
//
// plc.json: { "camopt", "scene", "master": {"unit", "end", "phase"}, "slave": {"unit", "lift", "travel",
// "closes"},
//   "formats": [{ "format", "file", "text_file", "controller", "rule", "numbers", "element", "count",
//   "limit",
//     "degree", "units": {"master_deg", "slave"}, "slave_at_start", "verdict", "drift_per_turn",
//     "loss": [{ "quantity": "s" | "v" | "a" | "j", "per_degree", "shown", "unit", "at_deg", "of_peak" }] }]
//     }
// NAME.check.json: the row of one format, "kind": "electronic cam", and its design (export_check_json).
// per_degree: slave units by degʳ. a and j are null where a table is made of straight lines. Figures of the
// loss are rounded up to three digits.
#pragma once

#include "report/document/run_origin.hpp"
#include "shop/plc/plc_formats.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

struct PlcResult {
    const PlcFormat* format = nullptr;
    int count = 0;
    PlcUnits units;
    std::array<std::optional<CamDifference>, 4> loss;  ///< slave units by degʳ, rounded up
    std::array<double, 4> of_peak{};                   ///< the same by the motion's own peak
    bool lossless = false;
    double drift_per_turn = 0.0;  ///< what whole units of the period add to each turn; slave units
};

struct PlcExport {
    std::vector<PlcResult> results;
    std::vector<FolderFile> files;  ///< plc.json the last
    std::string text;               ///< for the console
};

/// formats: keys of plc_formats(). Throws InputError for a key that is none, where the solution has no
/// motion, where a format holds fewer elements than needed, and where it cannot hold a jump that the motion
/// has.
[[nodiscard]] PlcExport plc_export(const Solution& solution, const std::vector<std::string>& formats,
                                   const PlcOptions& options);

/// The files alone, of each of these; empty without a format.
[[nodiscard]] std::vector<std::vector<FolderFile>> plc_files(std::span<const Solution> solutions,
                                                             const std::vector<std::string>& formats);

/// Throws InputError where a format holds fewer elements than every motion of the scene has: known before it
/// is solved.
void refuse_too_few_elements(const Scene& scene, const std::vector<std::string>& formats);

/// "codesys.check.json".
[[nodiscard]] std::string plc_check_name(const PlcFormat& format);

/// To three digits, away from zero.
[[nodiscard]] double figure_not_exceeded(double value);

/// What pieces that were read of a file of that format are off the motion.
[[nodiscard]] std::array<std::optional<CamDifference>, 4> plc_loss(const PlcFormat& format,
                                                                   const std::vector<PolynomialPiece>& pieces,
                                                                   const MasterCurve& curve);

}  // namespace camopt
