// SPDX-License-Identifier: MIT
// Tables of points: from pieces to the states at their joints, and back. What several formats share.
#pragma once

#include "output/plc/cam_pieces.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

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
