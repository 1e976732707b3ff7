// SPDX-License-Identifier: MIT
#include "shop/plc/plc_format.hpp"

#include <fmt/format.h>

namespace camopt {

std::optional<double> PlcNumbers::find(std::string_view name) const {
    for (const auto& [placeholder, value] : all)
        if (placeholder.substr(0, placeholder.find(':')) == name) return value;
    return std::nullopt;
}

double PlcNumbers::at(std::string_view name) const {
    if (const auto value = find(name)) return *value;
    throw ModelError(fmt::format("a template of an electronic cam has no {{{}}}", name));
}

int PlcFormat::most_pieces() const {
    constexpr int without_limit = 1000;
    if (!limit) return without_limit;
    return *limit - (counted == PlcCount::points ? 1 : 0);
}

std::vector<std::string> PlcFormat::files() const {
    return text_file.empty() ? std::vector{file} : std::vector{file, text_file};
}

PlcTable prepared_table(const MasterCurve& curve, const PlcOptions& options, const PlcFormat& format) {
    if (format.prepare) return format.prepare(curve, options, format);
    PlcTable table;
    table.pieces = fitted_pieces(curve, {.degree = format.degree,
                                         .points = options.points ? options.points : format.points,
                                         .most = format.most_pieces(),
                                         .master = format.master});
    if (format.units) table.units = format.units(curve);
    if (format.relative) {
        table.units.start = table.pieces.front().coefficients.front();
        for (PolynomialPiece& piece : table.pieces) piece.coefficients.front() -= table.units.start;
    }
    return table;
}

}  // namespace camopt
