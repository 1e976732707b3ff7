// SPDX-License-Identifier: MIT
#include "report/chart/sweep/sweep_svg.hpp"

#include "report/csv/sweep_csv.hpp"
#include "studies/sweep/sweep_axis.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr std::array<const char*, 3> peak_weights = {"objective.velocity", "objective.acceleration",
                                                     "objective.jerk"};

SweepQuantity figure_quantity(SweepFigure figure, const std::string& symbol) {
    const std::string name = words_of(name_of(figure));
    return {symbol.empty() ? name : name + " " + symbol, symbol.empty() ? name : symbol,
            [figure](const SweepRow& row) { return row.figure(figure); }};
}

/// "base radius (mm)", of values in SI.
SweepQuantity unit_quantity(const std::string& name, const ShownUnit& unit,
                            const std::function<std::optional<double>(const SweepRow&)>& value) {
    const std::string title = fmt::format("{} ({})", name, unit.name);
    return {title, title, [unit, value](const SweepRow& row) {
                const std::optional<double> si = value(row);
                return si ? std::optional(unit.of(*si)) : std::nullopt;
            }};
}

/// None of a row that is not feasible.
std::optional<double> shown_value(const SweepQuantity& quantity, const SweepRow& row) {
    return row.is_feasible() ? quantity.value(row) : std::nullopt;
}

ColourScale scale_of(const SweepTable& table, const SweepQuantity& quantity, std::string title = "") {
    ColourScale scale{std::move(title), {}};
    for (const SweepRow& row : table.rows)
        if (const std::optional<double> value = shown_value(quantity, row)) scale.range.add(*value);
    return scale;
}

/// "failed r12": how a row without a motion is drawn.
std::string empty_class(const SweepRow& row) {
    return fmt::format("{} r{}", row.verdict == Verdict::failed ? "failed" : "shut", row.number);
}

std::string cell_class(const ColourScale& scale, const SweepQuantity& quantity, const SweepRow& row) {
    const std::optional<double> value = shown_value(quantity, row);
    return value ? fmt::format("cell {} r{}", scale.colour(*value), row.number) : empty_class(row);
}

std::string count_sentence(const SweepTable& table) {
    const auto count = [&](auto test) { return std::ranges::count_if(table.rows, test); };
    const auto optimal = count([](const SweepRow& row) { return row.verdict == Verdict::optimal; });
    const auto feasible = count([](const SweepRow& row) { return row.is_feasible(); });
    const auto failed = count([](const SweepRow& row) { return row.verdict == Verdict::failed; });
    const auto shut = count([](const SweepRow& row) { return row.verdict == Verdict::infeasible; });
    const auto front = count([](const SweepRow& row) { return row.on_front; });
    std::string text = fmt::format("{} rows: {} proved optimal", table.rows.size(), optimal);
    if (feasible > optimal) text += fmt::format(", {} feasible only", feasible - optimal);
    if (shut > 0) text += fmt::format(", {} proved infeasible", shut);
    if (failed > 0) text += fmt::format(", {} failed", failed);
    return text + fmt::format("; {} on the Pareto front", front);
}

/// Shares of V, A, J in the weights of a row; NaN where they are all 0.
std::array<double, 3> shares_of(const SweepTable& table, const SweepRow& row) {
    std::array<double, 3> shares{};
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const auto key = std::ranges::find(table.columns.keys, peak_weights[i]);
        shares[i] = row.settings[key - table.columns.keys.begin()];
    }
    const double sum = shares[0] + shares[1] + shares[2];
    for (double& share : shares) share /= sum;
    return shares;
}

/// A quantity over the triangle of the weights of V (left), A (right) and J (top).
ChartPanel triangle_panel(const SweepTable& table, const SweepQuantity& quantity) {
    const double high = 0.5 * std::sqrt(3.0);
    // Half the distance of lattice neighbours, if the rows were a lattice of the whole triangle.
    const double divisions = 0.5 * (std::sqrt(8.0 * static_cast<double>(table.rows.size()) + 1.0) - 3.0);
    const double radius = 0.5 / std::max(divisions, 10.0);
    ChartPanel panel{
        .width = 270, .height = 270, .caption = quantity.title, .drawn_axes = false, .equal_scales = true};
    panel.frame.horizontal = {-0.06, 1.06};
    panel.frame.vertical = {-0.16, high + 0.06};
    panel.colours = scale_of(table, quantity);
    ChartSeries discs{Look::disc, "", {}, radius};
    for (const SweepRow& row : table.rows) {
        const auto [v, a, j] = shares_of(table, row);
        discs.points.push_back({a + 0.5 * j, high * j, cell_class(*panel.colours, quantity, row)});
    }
    panel.series = {{Look::line, "frame", {{0, 0}, {1, 0}, {0.5, high}, {0, 0}}}, std::move(discs)};
    ChartSeries corners{Look::label,      "", {{0, -radius, "", "V"}, {1, -radius, "", "A"}}, 0, "", "corner",
                        LabelSide::below, 14},
        top{Look::label, "", {{0.5 + radius, high, "", "J"}}, 0, "", "corner", LabelSide::beside, 14};
    panel.series.push_back(std::move(corners));
    panel.series.push_back(std::move(top));
    return panel;
}

/// Laws as diamonds, numbered as in their table.
void add_laws(ChartPanel& panel, const LawLosses& losses, std::size_t across, std::size_t up) {
    ChartSeries laws{
        .look = Look::diamond, .css = "law", .label_css = "law-number", .font = 10.5, .compared = true};
    for (const LawLoss& law : losses.laws)
        laws.points.push_back({law.peaks[across], law.peaks[up], "", std::to_string(laws.points.size() + 1)});
    panel.series.push_back(std::move(laws));
    set_axes(panel);
    const PlotAxis &x = panel.frame.horizontal, &y = panel.frame.vertical;
    std::string outside;
    for (const ChartPoint& law : panel.series.back().points)
        if (!x.holds(law.x) || !y.holds(law.y))
            outside += (outside.empty() ? "outside: laws " : ", ") + law.label;
    panel.series.insert(panel.series.begin(),
                        {Look::label, "", {{x.upper, y.upper, "", outside}}, 0, "", "law-number"});
}

/// Two peaks against one another, the third as colour: numbers of V, A, J.
ChartPanel plane_panel(const SweepPicture& picture, std::size_t across, std::size_t up, std::size_t colour) {
    const std::vector<SweepQuantity> all = drawn_quantities(picture.table);
    const SweepQuantity &x = all[across + 1], &y = all[up + 1], &third = all[colour + 1];
    ChartPanel panel{.place = across == 0 && up == 1 ? ChartPanel::Place::new_row : ChartPanel::Place::right,
                     .width = 310,
                     .height = 270,
                     .caption = fmt::format("{}–{}", x.symbol, y.symbol),
                     .by_factors = true};
    panel.colours = scale_of(picture.table, third, third.symbol);
    panel.frame.horizontal_title = x.title;
    panel.frame.vertical_title = y.title;
    ChartSeries off{Look::dot, "off-front", {}, 2.2}, front{Look::dot, "dot", {}, 3.6};
    for (const SweepRow& row : picture.table.rows) {
        const auto h = shown_value(x, row), v = shown_value(y, row), c = shown_value(third, row);
        if (!h || !v || !c) continue;
        const std::string number = fmt::format("r{}", row.number);
        if (row.on_front)
            front.points.push_back({*h, *v, panel.colours->colour(*c) + " " + number});
        else
            off.points.push_back({*h, *v, number});
    }
    panel.series = {std::move(off), std::move(front)};  // the front lies on top
    if (picture.losses != nullptr) add_laws(panel, *picture.losses, across, up);
    return panel;
}

std::string percent_words(const std::optional<double>& percent) {
    return percent ? change_text(100.0 + *percent, 100.0) : "–";
}

/// Where the classical laws lie above the trade-off, one line a law: a table, the least losses as bars, and a
/// table beside them.
void add_law_table(Chart& chart, const LawLosses& losses) {
    ChartPanel left{.caption = "Laws above the trade-off"},
        bars{.place = ChartPanel::Place::right, .width = 110, .drawn_axes = false},
        right{.place = ChartPanel::Place::right};
    const auto add = [&](ChartPanel& table, const std::string& head, const auto& words) {
        const TextSide side = head.empty() || head.starts_with("law") ? TextSide::start : TextSide::end;
        ChartColumn column{head, side};
        for (const LawLoss& law : losses.laws)
            column.cells.push_back(
                {words(law), side == TextSide::start && !law.feasible ? "value faint" : "value"});
        table.columns.push_back(std::move(column));
    };
    const bool all_feasible = std::ranges::all_of(losses.laws, &LawLoss::feasible);
    int number = 0;
    add(left, "", [&](const LawLoss&) { return std::to_string(++number); });
    add(left, all_feasible ? "law" : "law (* violates a limit)",
        [](const LawLoss& law) { return law.title + (law.feasible ? "" : " *"); });
    add(left, "V", [](const LawLoss& law) { return fixed_text(law.peaks[0], 3); });
    add(left, "A", [](const LawLoss& law) { return fixed_text(law.peaks[1], 3); });
    add(left, "J", [](const LawLoss& law) { return fixed_text(law.peaks[2], 2); });
    add(left, "loss at the\nscene’s weights",
        [](const LawLoss& law) { return percent_words(law.loss_percent); });
    add(left, "least loss over\nall weights",
        [](const LawLoss& law) { return law.closest ? percent_words(law.closest->loss_percent) : "–"; });
    bars.frame.horizontal.upper = 1e-6;
    ChartSeries& least = bars.series.emplace_back(ChartSeries{Look::bar, "law-bar"});
    for (const LawLoss& law : losses.laws) {
        const double loss = law.closest ? std::max(law.closest->loss_percent, 0.0) : 0.0;
        least.points.push_back({loss, -0.5 - bars.rows++});
        bars.frame.horizontal.upper = std::max(bars.frame.horizontal.upper, loss);
    }
    add(right, "at the weights\nV / A / J", [](const LawLoss& law) {
        if (!law.closest) return std::string{};
        const PeakTriple& w = law.closest->weights;
        return fmt::format("{:.2f} / {:.2f} / {:.2f}", w[0], w[1], w[2]);
    });
    for (std::size_t peak = 0; peak < 3; ++peak)
        add(right, fmt::format("{} alone can\ndecrease by", "VAJ"[peak]), [&](const LawLoss& law) {
            return law.least[peak] ? change_text(*law.least[peak], law.peaks[peak]) : "–";
        });
    for (ChartPanel* panel : {&left, &bars, &right}) chart.panels.push_back(std::move(*panel));
}

double key_value(const SweepRow& row, int key) {
    return key < 0 ? static_cast<double>(row.number) : row.settings[static_cast<std::size_t>(key)];
}

std::vector<const SweepRow*> sorted_rows(const SweepTable& table, int key) {
    std::vector<const SweepRow*> rows;
    for (const SweepRow& row : table.rows) rows.push_back(&row);
    std::ranges::stable_sort(rows, {}, [&](const SweepRow* row) { return key_value(*row, key); });
    return rows;
}

/// Ascending, positive, and about evenly spaced only in their logarithms.
bool wants_logarithm(const std::vector<const SweepRow*>& rows, int key) {
    if (rows.size() < 3) return false;
    const double first = key_value(*rows.front(), key), last = key_value(*rows.back(), key);
    const double middle = key_value(*rows[rows.size() / 2], key);
    return first > 0.0 && last > 20.0 * first && middle < 0.2 * last;
}

/// A quantity over one key (or over the row number where key < 0).
ChartPanel lines_panel(const SweepTable& table, const SweepQuantity& quantity, int key) {
    const std::vector<const SweepRow*> rows = sorted_rows(table, key);
    ChartPanel panel{.height = 210};
    ChartSeries bound{Look::line, "limit-line"}, line{Look::line, "row-line"},
        dots{Look::dot, "row-dot", {}, 3.0};
    for (const SweepRow* row : rows) {
        const double x = key_value(*row, key), none = std::numeric_limits<double>::quiet_NaN();
        const std::optional<double> value = shown_value(quantity, *row);
        line.points.push_back({x, value.value_or(none)});
        if (value)
            dots.points.push_back(
                {x, *value, fmt::format("{}r{}", row->on_front ? "" : "off ", row->number)});
        if (quantity.symbol == "f")
            bound.points.push_back({x, row->is_feasible() ? row->any_curve_limit.value_or(none) : none});
    }
    panel.series = {std::move(bound), std::move(line), std::move(dots)};
    panel.frame.horizontal.logarithmic = wants_logarithm(rows, key);
    panel.frame.horizontal_title = key < 0 ? "row" : table.columns.keys[static_cast<std::size_t>(key)];
    set_axes(panel);
    const PlotAxis& axis = panel.frame.horizontal;
    const auto between = [&](std::size_t i) {  // as it is seen: the middle of two neighbours
        if (i == 0 || i == rows.size()) return i == 0 ? axis.lower : axis.upper;
        const double before = key_value(*rows[i - 1], key), after = key_value(*rows[i], key);
        return axis.logarithmic ? std::sqrt(before * after) : 0.5 * (before + after);
    };
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i]->is_feasible())
            panel.series.push_back({Look::band, empty_class(*rows[i]), {{between(i)}, {between(i + 1)}}});
    return panel;
}

std::vector<double> values_of(const SweepTable& table, int key) {
    std::vector<double> values;
    for (const SweepRow& row : table.rows) values.push_back(key_value(row, key));
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// The two keys of the plan take every pair of their values once.
bool is_map(const SweepTable& table) {
    if (table.columns.keys.size() != 2) return false;
    const std::size_t x = values_of(table, 0).size(), y = values_of(table, 1).size();
    return x > 1 && y > 1 && x * y == table.rows.size();
}

/// A value at each of the places 0, 1, 2 … of an axis; of many only some.
std::vector<PlotTick> place_ticks(const std::vector<double>& values) {
    std::vector<PlotTick> ticks;
    const std::size_t stride = values.size() <= 8 ? 1 : values.size() / 6 + 1;
    for (std::size_t i = 0; i < values.size(); i += stride)
        ticks.push_back({static_cast<double>(i), short_text(values[i], 4)});
    return ticks;
}

/// A quantity over two keys that form a grid.
ChartPanel map_panel(const SweepTable& table, const SweepQuantity& quantity) {
    const std::vector<double> xs = values_of(table, 1), ys = values_of(table, 0);
    ChartPanel panel{.height = 300, .colours = scale_of(table, quantity)};
    panel.frame = {{-0.5, static_cast<double>(xs.size()) - 0.5},
                   {-0.5, static_cast<double>(ys.size()) - 0.5},
                   place_ticks(xs),
                   place_ticks(ys),
                   table.columns.keys[1],
                   table.columns.keys[0]};
    ChartSeries cells{Look::cell, "", {}, 0.5};
    const auto place = [](const std::vector<double>& values, double value) {
        return static_cast<double>(std::ranges::lower_bound(values, value) - values.begin());
    };
    for (const SweepRow& row : table.rows)
        cells.points.push_back({place(xs, row.settings[1]), place(ys, row.settings[0]),
                                cell_class(*panel.colours, quantity, row)});
    panel.series = {std::move(cells)};
    return panel;
}

}  // namespace

std::vector<SweepQuantity> drawn_quantities(const SweepTable& table) {
    if (table.columns.machine) {
        std::vector<SweepQuantity> of_machine = {
            unit_quantity("speed", rpm_shown, [](const SweepRow& row) { return row.machine.speed; })};
        of_machine.push_back({"total objective", "f", [](const SweepRow& row) { return row.objective; }});
        return of_machine;
    }
    std::vector<SweepQuantity> quantities = {
        {"objective", "f", [](const SweepRow& row) { return row.objective; }},
        figure_quantity(SweepFigure::velocity, "V"),
        figure_quantity(SweepFigure::acceleration, "A"),
        figure_quantity(SweepFigure::jerk, "J")};
    for (const CostTerm& term : cost_terms()) {
        if (term.kind == CostTerm::Kind::peak) continue;
        if (std::ranges::find(table.columns.criteria, term.name()) != table.columns.criteria.end())
            quantities.push_back(figure_quantity(term.figure, ""));
    }
    const LengthUnit unit = table.columns.length_unit;
    const ShownUnit length = length_shown(unit);
    for (const DimensionIndex dimension : table.columns.dimensions)
        quantities.push_back(
            unit_quantity(words_of(name_of(dimension)), length,
                          [dimension](const SweepRow& row) { return row.dimension(dimension); }));
    for (const SweepCamColumn& column : sweep_cam_columns()) {
        const auto value = [&column](const SweepRow& row) { return row.cam.*column.value; };
        // A flat face has no concave radius and may have a pressure angle of 0, cams in space have no radii.
        if (table.columns.cam() && std::ranges::any_of(table.rows, [&](const SweepRow& row) {
                return value(row).value_or(0.0) != 0.0;
            }))
            quantities.push_back(unit_quantity(
                column.title, column.file_unit == &degrees_shown ? degrees_shown : length, value));
    }
    for (const SweepDriveColumn& column : sweep_drive_columns())
        if (table.columns.drive)
            quantities.push_back(unit_quantity(
                column.title,
                column.file_unit == &rpm_shown ? rpm_shown : shown_units(MotionSpec(), unit).torque,
                [&column](const SweepRow& row) { return row.drive.*column.value; }));
    return quantities;
}

bool is_weight_sweep(const SweepTable& table) {
    const std::vector<std::string>& keys = table.columns.keys;
    return std::ranges::all_of(keys, [](const std::string& key) { return is_weight_key(key); }) &&
           std::ranges::all_of(peak_weights,
                               [&](const char* key) { return std::ranges::find(keys, key) != keys.end(); });
}

Chart sweep_chart(const SweepPicture& picture) {
    const SweepTable& table = picture.table;
    const bool weights = is_weight_sweep(table), map = is_map(table), lines = table.columns.keys.size() == 1;
    Chart chart{
        picture.scene.title.empty() ? "Sweep" : picture.scene.title,
        {count_sentence(table),
         weights ? "Triangles: the weight of a peak grows towards its corner. Planes: colour marks the "
                   "Pareto front, grey dots lie off it, diamonds are the laws of the table."
                 : "Shaded: proved infeasible. Red with a cross: failed. Dashed: the lower bound for every "
                   "curve. Rings: rows off the Pareto front."}};
    const std::vector<SweepQuantity> quantities = drawn_quantities(table);
    for (std::size_t i = 0; weights && i < 4; ++i) {
        chart.panels.push_back(triangle_panel(table, quantities[i]));
        if (i > 0) chart.panels.back().place = ChartPanel::Place::right;
    }
    if (weights || (!lines && !map && !table.columns.machine)) {
        for (const auto& [across, up, colour] : {std::array<std::size_t, 3>{0, 1, 2}, {1, 2, 0}, {0, 2, 1}})
            if (!scale_of(table, quantities[across + 1]).range.empty())
                chart.panels.push_back(plane_panel(picture, across, up, colour));
        if (picture.losses != nullptr && !picture.losses->laws.empty()) add_law_table(chart, *picture.losses);
    }
    for (std::size_t i = 0; !weights && i < quantities.size(); ++i) {
        ChartPanel& panel = chart.panels.emplace_back(
            map ? map_panel(table, quantities[i]) : lines_panel(table, quantities[i], lines ? 0 : -1));
        panel.width = 500;
        panel.caption = quantities[i].title;
        if (i % 2 == 1) panel.place = ChartPanel::Place::right;
    }
    return chart;
}

}  // namespace camopt
