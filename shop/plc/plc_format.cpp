// SPDX-License-Identifier: MIT
#include "shop/plc/plc_format.hpp"

#include <fmt/ranges.h>

namespace camopt {

int PlcFormat::most_pieces() const {
    constexpr int without_limit = 1000;
    if (!limit) return without_limit;
    return *limit - (counted == PlcCount::points ? 1 : 0);
}

const std::vector<PlcFormat>& plc_formats() {
    static const std::vector<PlcFormat> formats = {
        codesys_format(),  twincat_format(), siemens_format(), br_format(),
        rockwell_format(), omron_format(),   lenze_format(),   coefficient_csv_format()};
    return formats;
}

std::vector<std::string> plc_format_keys() {
    std::vector<std::string> keys;
    for (const PlcFormat& format : plc_formats()) keys.push_back(format.key);
    return keys;
}

const PlcFormat& plc_format(std::string_view key) {
    const auto found = std::ranges::find(plc_formats(), key, &PlcFormat::key);
    if (found != plc_formats().end()) return *found;
    throw InputError(
        fmt::format("--plc: found \"{}\"; allowed: {}", key, fmt::join(plc_format_keys(), ", ")));
}

void count_from_start(PlcTable& table) {
    table.slave_at_start = table.pieces.front().coefficients.front();
    for (CamPiece& piece : table.pieces) piece.coefficients.front() -= table.slave_at_start;
}

PlcTable fitted_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat& format) {
    PlcTable table;
    table.pieces = fitted_pieces(
        curve,
        {.degree = format.degree == 3 ? 3 : 5, .points = options.points, .most = format.most_pieces()});
    return table;
}

}  // namespace camopt
