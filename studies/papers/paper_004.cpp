// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"
#include "studies/papers/reference_table.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr int last_printed_row = 12;   // segments of Table 2
constexpr int compared_segments = 10;  // of Figs. 5 to 8
constexpr int printed_digits = 6, ours_digits = 9;

struct Pair {
    std::optional<double> printed, ours;

    [[nodiscard]] std::optional<double> difference() const {
        if (!printed || !ours) return {};
        return *ours - *printed;
    }
};

template <class Member>
Pair pair_of(const std::optional<PeakFigures>& printed, const std::optional<PeakFigures>& ours,
             Member member) {
    Pair pair;
    if (printed) pair.printed = (*printed).*member;
    if (ours) pair.ours = (*ours).*member;
    return pair;
}

std::optional<PeakFigures> optimum_of(const Solution& solution) {
    if (!solution.curve) return {};
    return PeakFigures{solution.peaks.velocity.value, solution.peaks.acceleration.value,
                       solution.peaks.jerk.value, solution.certificate.objective};
}

void add_pair_columns(PaperTable& table, const std::string& key, const std::string& title) {
    table.columns.push_back({key + "_printed", title + " printed", "", printed_digits});
    table.columns.push_back({key + "_ours", title + " ours", "", ours_digits});
}

void add_pair(std::vector<PaperCell>& row, const Pair& pair) {
    row.push_back(cell_of(pair.printed));
    row.push_back(cell_of(pair.ours));
}

void add_proof_columns(PaperTable& table) {
    table.columns.push_back({"proved_gap", "proved gap", "", 2});
    table.columns.push_back({"verdict", "verdict", ""});
}

void add_proof(std::vector<PaperCell>& row, const Certificate& certificate) {
    row.push_back(cell_of(certificate.gap));
    row.emplace_back(std::string(name_of(certificate.verdict)));
}

std::string limit_sentence(const LimitCurve& limit) {
    std::string text = fmt::format("No curve lies below the limit {:.9f}", limit.objective);
    if (limit.velocity && limit.acceleration && limit.jerk)
        text += fmt::format(", the objective at V = {:.7f}, A = {:.7f}, J = {:.7f}", *limit.velocity,
                            *limit.acceleration, *limit.jerk);
    return text + ".";
}

std::optional<double> percent_above(const std::optional<double>& value, double limit) {
    if (!value || !(limit > 0.0)) return {};
    return 100.0 * (*value / limit - 1.0);
}

PaperTable convergence_table(const ReferenceTable& reference) {
    PaperTable table{
        "table_2",
        "Table 2: peaks and objective of the best curve on n segments",
        "Ours: the optimum, with the verdict of its proof. Objective = 0.4 V/1.76 + 0.4 A/5.53 + "
        "0.2 J/69. " +
            limit_sentence(reference.limit),
        {{"segments", "n", ""}},
        {}};
    add_pair_columns(table, "velocity", "V");
    add_pair_columns(table, "acceleration", "A");
    add_pair_columns(table, "jerk", "J");
    add_pair_columns(table, "objective", "objective");
    table.columns.push_back({"difference", "difference", "", 2});
    table.columns.push_back({"above_limit_percent", "above the limit", "%", 3});
    add_proof_columns(table);
    table.columns.push_back({"remark", "remark", ""});
    for (const ConvergenceRow& row : reference.convergence) {
        const auto ours = optimum_of(row.optimum);
        const Pair objective = pair_of(row.printed, ours, &PeakFigures::objective);
        std::vector<PaperCell> cells = {static_cast<double>(row.segments)};
        add_pair(cells, pair_of(row.printed, ours, &PeakFigures::velocity));
        add_pair(cells, pair_of(row.printed, ours, &PeakFigures::acceleration));
        add_pair(cells, pair_of(row.printed, ours, &PeakFigures::jerk));
        add_pair(cells, objective);
        cells.push_back(cell_of(objective.difference()));
        cells.push_back(cell_of(percent_above(objective.ours, reference.limit.objective)));
        add_proof(cells, row.optimum.certificate);
        cells.emplace_back(row.note);
        table.rows.push_back(std::move(cells));
    }
    return table;
}

PaperTable points_table(const ReferenceTable& reference) {
    PaperTable table{"table_1",
                     "Table 1: the ordinates of the best curve",
                     "First half; the second follows from y(x) + y(1 − x) = 1. Where the best peaks leave "
                     "some freedom, ours is the curve of least ∫ y‴².",
                     {{"segments", "n", ""},
                      {"index", "i", ""},
                      {"x", "x", "", 6},
                      {"y_printed", "printed", "", 6},
                      {"y_ours", "ours", "", 9},
                      {"difference", "difference", "", 2},
                      {"remark", "remark", ""}},
                     {}};
    for (const ConvergenceRow& row : reference.convergence) {
        for (std::size_t i = 1; 2 * i <= row.printed_points.size(); ++i) {
            Pair pair{row.printed_points[i], {}};
            if (i < row.optimum_points.size()) pair.ours = row.optimum_points[i];
            const bool misprint = row.segments == compared_segments && i == 3;
            table.rows.push_back({static_cast<double>(row.segments), static_cast<double>(i),
                                  static_cast<double>(i) / row.segments, cell_of(pair.printed),
                                  cell_of(pair.ours), cell_of(pair.difference()),
                                  std::string(misprint ? "misprint: 0.1748 is consistent" : "")});
        }
    }
    return table;
}

PaperTable laws_table(const ReferenceTable& reference) {
    PaperTable table{"table_3",
                     "Table 3: the classical laws",
                     "Ours: exact peaks. Loss: objective above that of the best curve on 12 segments. Empty: "
                     "infinite, or not defined by the paper.",
                     {{"law", "law", ""}},
                     {}};
    add_pair_columns(table, "velocity", "V");
    add_pair_columns(table, "acceleration", "A");
    add_pair_columns(table, "jerk", "J");
    table.columns.push_back({"loss_percent", "loss", "%", 4});
    for (const LawComparisonRow& law : reference.laws) {
        std::vector<PaperCell> cells = {law.name};
        add_pair(cells, pair_of(law.printed, law.exact, &PeakFigures::velocity));
        add_pair(cells, pair_of(law.printed, law.exact, &PeakFigures::acceleration));
        add_pair(cells, pair_of(law.printed, law.exact, &PeakFigures::jerk));
        cells.push_back(cell_of(law.loss_percent));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

PaperTable weights_table(const ReferenceTable& reference) {
    PaperTable table{
        "table_4",
        "Table 4: the effect of the weights on 10 segments",
        "Objectives under the row's own weights; printed: that of the paper's corrected points.",
        {{"weight_velocity", "α", ""}, {"weight_acceleration", "β", ""}, {"weight_jerk", "γ", ""}},
        {}};
    add_pair_columns(table, "fourth_ordinate", "y4");
    add_pair_columns(table, "objective", "objective");
    table.columns.push_back({"limit", "limit of all curves", "", ours_digits});
    add_proof_columns(table);
    for (const WeightEffectRow& row : reference.weights) {
        std::vector<PaperCell> cells = {row.velocity, row.acceleration, row.jerk};
        const bool solved = row.optimum.curve.has_value();
        add_pair(cells, {row.printed_fourth_ordinate,
                         solved ? std::optional(row.fourth_ordinate) : std::optional<double>{}});
        add_pair(cells, pair_of(PeakFigures{0, 0, 0, row.printed_objective}, optimum_of(row.optimum),
                                &PeakFigures::objective));
        cells.emplace_back(row.limit.objective);
        add_proof(cells, row.optimum.certificate);
        table.rows.push_back(std::move(cells));
    }
    return table;
}

/// A derivative of a motion from its begin to `end`, its steps as steps.
PaperSeries series_of(const std::string& title, const Motion& motion, std::size_t order, double end) {
    constexpr int points_a_piece = 24;
    PaperSeries series{title, {}, {}};
    const auto add = [&](double x, Side side) {
        series.x.push_back(x);
        series.y.push_back(motion.at(x, side).derivative[order]);
    };
    const std::vector<double> breaks = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < breaks.size() && breaks[i] < end; ++i) {
        const double begin = breaks[i], stop = std::min(breaks[i + 1], end);
        for (int k = 0; k <= points_a_piece; ++k)
            add(k == points_a_piece ? stop : begin + (stop - begin) * k / points_a_piece,
                k == 0 ? Side::right : Side::left);
    }
    return series;
}

constexpr std::array<const char*, 4> order_symbols = {"y", "y′", "y″", "y‴"};

std::vector<PaperFigure> figures_of(const ReferenceTable& reference) {
    std::vector<PaperFigure> figures;
    for (std::size_t order = 0; order < derivative_names.size(); ++order) {
        PaperFigure figure{fmt::format("figure_{}", order + 1),
                           fmt::format("Fig. {}: convergence of the {}", order + 1, derivative_names[order]),
                           "x",
                           order_symbols[order],
                           {}};
        for (const ConvergenceRow& row : reference.convergence)
            if (row.segments <= last_printed_row && row.optimum.curve)
                figure.series.push_back(
                    series_of(fmt::format("n = {}", row.segments), *row.optimum.curve, order, 0.5));
        figures.push_back(std::move(figure));
    }
    const auto law = make_law("modified_sine");
    for (std::size_t order = 0; order < derivative_names.size(); ++order) {
        PaperFigure figure{fmt::format("figure_{}", order + 5),
                           fmt::format("Fig. {}: {}, best cubic of {} segments and modified sine", order + 5,
                                       derivative_names[order], compared_segments),
                           "x",
                           order_symbols[order],
                           {}};
        for (const ConvergenceRow& row : reference.convergence)
            if (row.segments == compared_segments && row.optimum.curve)
                figure.series.push_back(series_of("best cubic", *row.optimum.curve, order, 1.0));
        figure.series.push_back(series_of("modified sine", *law, order, 1.0));
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace

PaperReport paper_004_report(const ReferenceTable& table) {
    PaperReport report;
    report.id = "004";
    report.title = "Optimum cam curves by cubic splines";
    report.source = "T.-Y. Shon, M.-Y. Yang, \"Synthesis of Optimum CAM Curve by Cubic Spline\", 1994";
    report.introduction =
        "Rise between two dwells; C2 cubic spline on n equal segments with y(x) + y(1 − x) = 1. V, A, J are "
        "the largest |y'|, |y''|, |y'''|.";
    report.tables = {points_table(table), convergence_table(table), laws_table(table), weights_table(table)};
    report.figures = figures_of(table);
    report.notes = table.notes;
    for (const std::string& row : unproved_rows(table)) report.faults.push_back("not proved optimal: " + row);
    return report;
}

}  // namespace camopt
