// SPDX-License-Identifier: MIT
// The table of controllers: one row a format. Whatever lists, writes, reads back or documents them iterates.
//
// A row makes pieces of the motion (what the controller can hold), writes them, and reads its own text back
// as the controller does: its number types, its degree, its rule between points. A new format is a source in
// formats/ and a row.
#pragma once

#include "shop/plc/cam_pieces.hpp"

namespace camopt {

/// What one unit of the numbers in a file is.
struct PlcUnits {
    double master = 1.0;  ///< deg
    double slave = 1.0;   ///< mm, of a swinging output deg
};

struct PlcOptions {
    std::optional<int> points = {};  ///< evenly over the turn; none: the motion's own joints
};

/// What a writer is given.
struct PlcTable {
    std::vector<CamPiece> pieces;  ///< deg, mm or deg
    PlcUnits units;
    double slave_at_start = 0.0;      ///< what was taken off every slave position; mm or deg
    std::optional<double> speed;      ///< deg/s of the master, where the scene has one
    std::vector<std::string> header;  ///< lines of comment
};

enum class PlcCount { points, pieces };

struct PlcFormat {
    std::string key;         ///< "codesys"
    std::string file;        ///< "codesys.st"
    std::string controller;  ///< "CODESYS SoftMotion, MC_CAM_REF of type XYVA"
    std::string rule;        ///< between the elements: "quintics between the points"
    std::string numbers;     ///< "LREAL (float64)"
    int degree = 5;          ///< of what the controller makes between two joints
    PlcCount counted = PlcCount::points;
    std::string element;            ///< what is counted: "points", "segments", "polynomials"
    std::optional<int> limit = {};  ///< of them
    std::string limit_words = {};   ///< who holds no more: "a cam read from a file"
    std::string limit_note = {};    ///< "library parameter ..."; mostly empty
    int shared = 0;  ///< highest derivative of which a point has one for both sides: no jump of it is held
    bool straight_lines = false;  ///< acceleration and jerk have no meaning
    bool relative = false;        ///< slave positions count from the first
    bool whole_periods = false;   ///< the travel of a turn is a whole number of slave units
    std::string text_file = {};   ///< a second file with the same numbers; mostly empty

    PlcTable (*prepare)(const MasterCurve& curve, const PlcOptions& options,
                        const PlcFormat& format) = nullptr;
    std::string (*write)(const PlcTable& table) = nullptr;
    /// Throws InputError for a text that is no such file.
    std::vector<CamPiece> (*read)(std::string_view text, const PlcUnits& units) = nullptr;
    std::string (*write_text)(const PlcTable& table) = nullptr;
    std::vector<CamPiece> (*read_text)(std::string_view text, const PlcUnits& units) = nullptr;

    [[nodiscard]] int count_of(const std::vector<CamPiece>& pieces) const {
        return static_cast<int>(pieces.size()) + (counted == PlcCount::points ? 1 : 0);
    }
    /// The most pieces that a fit may make.
    [[nodiscard]] int most_pieces() const;
};

[[nodiscard]] const std::vector<PlcFormat>& plc_formats();
/// Throws InputError naming the keys there are.
[[nodiscard]] const PlcFormat& plc_format(std::string_view key);
[[nodiscard]] std::vector<std::string> plc_format_keys();

/// Of a table whose slave positions count from the first: takes that off, and remembers it.
void count_from_start(PlcTable& table);

/// FitOptions of the row, then fitted_pieces.
[[nodiscard]] PlcTable fitted_table(const MasterCurve& curve, const PlcOptions& options,
                                    const PlcFormat& format);

// The rows of plc_format.hpp, a source each. Where the fields come from: docs/plc.md.

[[nodiscard]] PlcFormat codesys_format();
[[nodiscard]] PlcFormat twincat_format();
[[nodiscard]] PlcFormat siemens_format();
[[nodiscard]] PlcFormat br_format();
[[nodiscard]] PlcFormat rockwell_format();
[[nodiscard]] PlcFormat omron_format();
[[nodiscard]] PlcFormat lenze_format();
[[nodiscard]] PlcFormat coefficient_csv_format();

}  // namespace camopt
