// SPDX-License-Identifier: MIT
// Structured text (IEC 61131-3) as tables need it: literals, comments, assignments; and back.
//
//   Points[3].dX := 10.0;    an element and one of its fields
//   Cam.nElements := 33;     a field of no element
#pragma once

#include "shop/plc/cam_pieces.hpp"

namespace camopt {

/// "10.0", "1.5e-07": reads back as the same double; no minus before zero.
[[nodiscard]] std::string lreal_text(double value);
/// The same of a REAL.
[[nodiscard]] std::string real_text(float value);

/// "// line" each.
[[nodiscard]] std::string comment_lines(const std::vector<std::string>& lines);

struct StElements {
    std::map<int, std::map<std::string, std::string>> elements;  ///< index, field, value as written
    std::map<std::string, std::string> fields;                   ///< "Cam.nElements"

    /// Throws InputError where it is missing or no number.
    [[nodiscard]] double number(int index, const std::string& field) const;
    [[nodiscard]] float real(int index, const std::string& field) const;
    [[nodiscard]] double number(const std::string& field) const;
    [[nodiscard]] const std::string& word(int index, const std::string& field) const;
};

/// Every assignment of the text; of arrays the last index. Comments are left out. Throws InputError for an
/// element whose field is assigned twice.
[[nodiscard]] StElements read_assignments(std::string_view text);

/// Throws InputError where the text is no number. The decimal sign is a point, regardless of the locale.
[[nodiscard]] double number_of(std::string_view text);
[[nodiscard]] float real_of(std::string_view text);

/// The lines of a text without their ends.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

// Tables of points: from pieces to the states at their joints, and back. What several formats share.

/// The states at all joints: at the begin of each piece, and at the end of the last.
[[nodiscard]] std::vector<EndState> knots_of(const std::vector<CamPiece>& pieces);

/// The state at the end of a piece.
[[nodiscard]] EndState state_at_end(const CamPiece& piece);
[[nodiscard]] EndState state_at_begin(const CamPiece& piece);

/// Throws InputError for fewer than two.
[[nodiscard]] std::vector<CamPiece> quintics_between(const std::vector<EndState>& knots);
[[nodiscard]] std::vector<CamPiece> lines_between(const std::vector<EndState>& knots);

/// The numbers of a line. Throws InputError for another count of them.
[[nodiscard]] std::vector<double> numbers_between(std::string_view line, char separator, std::size_t count);

/// The piece halved at that part of its length: the same polynomial twice.
[[nodiscard]] std::vector<CamPiece> split_at(const CamPiece& piece, double part);

}  // namespace camopt
