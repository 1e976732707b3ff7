// SPDX-License-Identifier: MIT
// A row of the table of controllers (plc_formats.hpp).
//
// It says what the controller can hold and what it makes of the numbers of a file: its degree, its rule
// between points. Its file is written and read back by the template of that name (plc_template.hpp).
#pragma once

#include "shop/plc/cam_pieces.hpp"

namespace camopt {

/// What one unit of the numbers in a file is, and what they count from.
struct PlcUnits {
    double master = 1.0;  ///< deg
    double slave = 1.0;   ///< mm, of a swinging output deg
    double start = 0.0;   ///< was taken off every slave position; mm or deg
};

struct PlcOptions {
    std::optional<int> points = {};  ///< evenly over the turn; none: the motion's own joints
};

/// What a writer is given.
struct PlcTable {
    std::vector<PolynomialPiece> pieces;  ///< deg, mm or deg
    PlcUnits units;
    std::optional<double> speed;      ///< deg/s of the master, where the scene has one
    std::vector<std::string> header;  ///< lines of comment
};

/// Numbers of a file by their placeholders ("to.s:REAL"); in deg, mm or deg.
struct PlcNumbers {
    std::vector<std::pair<std::string, double>> all;

    [[nodiscard]] std::optional<double> find(std::string_view name) const;
    /// Throws ModelError where the template has no such placeholder.
    [[nodiscard]] double at(std::string_view name) const;
};

/// What was read of a file.
struct PlcReading {
    std::vector<PlcNumbers> elements;
    PlcNumbers rest;
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
    bool straight_lines = false;     ///< acceleration and jerk have no meaning
    bool relative = false;           ///< slave positions count from the first
    bool whole_periods = false;      ///< the travel of a turn is a whole number of slave units
    std::optional<int> points = {};  ///< where PlcOptions has none
    std::string text_file = {};      ///< a second file with the same numbers; mostly empty

    /// What the controller makes of the numbers of a file.
    std::vector<PolynomialPiece> (*evaluate)(const PlcReading& reading) = nullptr;
    /// The next master position that the controller can hold; none: all.
    double (*master)(double theta) = nullptr;
    /// Of the numbers in the file; none: 1 deg, 1 mm or deg.
    PlcUnits (*units)(const MasterCurve& curve) = nullptr;
    /// Where the pieces are not simply fitted.
    PlcTable (*prepare)(const MasterCurve& curve, const PlcOptions& options,
                        const PlcFormat& format) = nullptr;
    /// A number of the template that is not of the motion alone.
    double (*own_number)(const PlcTable& table, const PolynomialPiece& piece, double theta,
                         std::string_view name) = nullptr;

    [[nodiscard]] std::vector<std::string> files() const;
    [[nodiscard]] int count_of(const std::vector<PolynomialPiece>& pieces) const {
        return static_cast<int>(pieces.size()) + (counted == PlcCount::points ? 1 : 0);
    }
    /// The most pieces that a fit may make.
    [[nodiscard]] int most_pieces() const;
};

/// The motion as the controller of the row can hold it.
[[nodiscard]] PlcTable prepared_table(const MasterCurve& curve, const PlcOptions& options,
                                      const PlcFormat& format);

}  // namespace camopt
