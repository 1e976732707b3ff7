// SPDX-License-Identifier: MIT
#include "output/plc/formats/knots.hpp"

#include "core/errors.hpp"
#include "core/text/split_text.hpp"
#include "output/plc/structured_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

void check_knots(const std::vector<EndState>& knots) {
    if (knots.size() < 2)
        throw InputError(
            fmt::format("an electronic cam: found {} points; allowed: two or more", knots.size()));
}

EndState state_of_piece(const CamPiece& piece, double theta) {
    return {theta, value_of(piece, theta, 0), value_of(piece, theta, 1), value_of(piece, theta, 2)};
}

}  // namespace

EndState state_at_begin(const CamPiece& piece) {
    return state_of_piece(piece, piece.begin);
}

EndState state_at_end(const CamPiece& piece) {
    return state_of_piece(piece, piece.end);
}

std::vector<EndState> knots_of(const std::vector<CamPiece>& pieces) {
    std::vector<EndState> knots;
    for (const CamPiece& piece : pieces) knots.push_back(state_at_begin(piece));
    if (!pieces.empty()) knots.push_back(state_at_end(pieces.back()));
    return knots;
}

std::vector<CamPiece> quintics_between(const std::vector<EndState>& knots) {
    check_knots(knots);
    std::vector<CamPiece> pieces;
    for (std::size_t i = 1; i < knots.size(); ++i) pieces.push_back(quintic_between(knots[i - 1], knots[i]));
    return pieces;
}

std::vector<CamPiece> lines_between(const std::vector<EndState>& knots) {
    check_knots(knots);
    std::vector<CamPiece> pieces;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const EndState &from = knots[i - 1], &to = knots[i];
        pieces.push_back({from.theta, to.theta, {from.s, (to.s - from.s) / (to.theta - from.theta)}});
    }
    return pieces;
}

std::vector<double> numbers_between(std::string_view line, char separator, std::size_t count) {
    std::vector<double> numbers;
    constexpr std::string_view nothing;  // blanks around a number are none of it
    for (const std::string_view part : split_text(line, separator, nothing))
        numbers.push_back(number_of(part));
    if (numbers.size() != count)
        throw InputError(
            fmt::format("an electronic cam: found {} numbers in a line; allowed: {}", numbers.size(), count));
    return numbers;
}

std::vector<CamPiece> split_at(const CamPiece& piece, double part) {
    const double middle = piece.begin + part * (piece.end - piece.begin);
    return {{piece.begin, middle, piece.coefficients}, {middle, piece.end, polynomial_about(piece, middle)}};
}

}  // namespace camopt
