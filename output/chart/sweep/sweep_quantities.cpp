// SPDX-License-Identifier: MIT
#include "output/chart/sweep/sweep_quantities.hpp"

#include "core/units.hpp"
#include "output/view/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

SweepQuantity figure_quantity(SweepFigure figure, const std::string& symbol) {
    const std::string name = words_of(name_of(figure));
    return {symbol.empty() ? name : name + " " + symbol, symbol.empty() ? name : symbol,
            [figure](const SweepRow& row) { return row.figure(figure); }};
}

SweepQuantity dimension_quantity(DimensionIndex dimension, LengthUnit unit) {
    const std::string title = fmt::format("{} ({})", words_of(name_of(dimension)), name_of(unit));
    return {title, title, [dimension, unit](const SweepRow& row) -> std::optional<double> {
                const std::optional<double>& metres = row.dimension(dimension);
                return metres ? std::optional(*metres / metres_of(unit)) : std::nullopt;
            }};
}

// Viridis (S. van der Walt, N. Smith, CC0) at sixteen even places.
constexpr std::array<const char*, colour_steps> colours = {
    "#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e", "#2a788e", "#23888e",
    "#1f988b", "#22a884", "#35b779", "#54c568", "#7ad151", "#a5db36", "#d2e21b", "#fde725"};
constexpr double bar_height = 8;

}  // namespace

SweepQuantity objective_quantity() {
    return {"objective", "f", [](const SweepRow& row) { return row.objective; }};
}

std::array<SweepQuantity, 3> peak_quantities() {
    return {figure_quantity(SweepFigure::velocity, "V"), figure_quantity(SweepFigure::acceleration, "A"),
            figure_quantity(SweepFigure::jerk, "J")};
}

std::vector<SweepQuantity> drawn_quantities(const SweepTable& table) {
    std::vector<SweepQuantity> quantities = {objective_quantity()};
    for (SweepQuantity& peak : peak_quantities()) quantities.push_back(std::move(peak));
    for (const CostTerm& term : cost_terms()) {
        if (term.kind == CostTerm::Kind::peak) continue;
        if (std::ranges::find(table.columns.criteria, term.name()) != table.columns.criteria.end())
            quantities.push_back(figure_quantity(term.figure, ""));
    }
    for (const DimensionIndex dimension : table.columns.dimensions)
        quantities.push_back(dimension_quantity(dimension, table.columns.length_unit));
    return quantities;
}

ValueRange range_of(std::span<const SweepRow> rows, const SweepQuantity& quantity) {
    ValueRange range;
    for (const SweepRow& row : rows) {
        if (!row.is_feasible()) continue;
        if (const std::optional<double> value = quantity.value(row)) range.add(*value);
    }
    return range;
}

bool spans_factors(const ValueRange& range) {
    constexpr double large_factor = 6.0;
    return !range.empty() && range.lower > 0.0 && range.upper > large_factor * range.lower;
}

PlotAxis axis_over(const ValueRange& range, double begin, double end) {
    constexpr double room = 0.05;
    if (!spans_factors(range)) {
        const ValueRange wide = range.padded(room);
        return {wide.lower, wide.upper, begin, end, false};
    }
    const double factor = std::pow(range.upper / range.lower, room);
    return {range.lower / factor, range.upper * factor, begin, end, true};
}

std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted) {
    std::vector<PlotTick> ticks;
    if (axis.logarithmic) {
        double power = std::pow(10.0, std::floor(std::log10(axis.lower)));
        while (power <= axis.upper) {
            for (const double digit : {1.0, 2.0, 5.0})
                if (axis.holds(digit * power)) ticks.push_back({digit * power, short_text(digit * power, 5)});
            power *= 10.0;
        }
        return ticks;
    }
    return labelled_ticks(axis.lower, axis.upper, wanted);
}

std::string colour_scale_style() {
    std::string style;
    for (int i = 0; i < colour_steps; ++i)
        style += fmt::format(".c{}{{fill:{}}}", i, colours[static_cast<std::size_t>(i)]);
    return style + ".bar-number{font-size:11px;fill:#444}.bar-number.right{text-anchor:end}";
}

std::string ColourScale::colour(double value) const {
    const double part = !(upper > lower) ? 0.5
                        : logarithmic    ? std::log(value / lower) / std::log(upper / lower)
                                         : (value - lower) / (upper - lower);
    return fmt::format("c{}", std::clamp(static_cast<int>(part * colour_steps), 0, colour_steps - 1));
}

void draw_colour_bar(SvgCanvas& canvas, const ColourScale& scale, double x, double y, double width) {
    const double step = width / colour_steps;
    for (int i = 0; i < colour_steps; ++i)
        canvas.rectangle(x + i * step, y, step + 0.3, bar_height, fmt::format("c{}", i));
    canvas.text(x, y + bar_height + 12, short_text(scale.lower, 4), "bar-number");
    canvas.text(x + width, y + bar_height + 12, short_text(scale.upper, 4), "bar-number right");
}

}  // namespace camopt
