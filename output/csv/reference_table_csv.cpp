// SPDX-License-Identifier: MIT
#include "output/csv/reference_table_csv.hpp"

#include "output/csv/csv_line.hpp"
#include "output/words/tables/reference_table_rows.hpp"

#include <algorithm>
#include <cstddef>

namespace camopt {

namespace {

void add_figures(CsvLine& line, const std::optional<PeakFigures>& figures) {
    if (!figures) {
        line.blank(4);
        return;
    }
    line.number(figures->velocity).number(figures->acceleration).number(figures->jerk);
    line.number(figures->objective);
}

void add_proof(CsvLine& line, const Certificate& certificate) {
    line.number(certificate.lower_bound).number(certificate.gap);
    line.words(name_of(certificate.verdict)).words(name_of(certificate.reason));
}

std::string figure_columns(const std::string& prefix) {
    return prefix + "_velocity," + prefix + "_acceleration," + prefix + "_jerk," + prefix + "_objective";
}

}  // namespace

std::string optimum_points_csv(const ReferenceTable& table) {
    std::string text = "segments,index,x,y_printed,y_optimum\n";
    for (const ConvergenceRow& row : table.convergence) {
        const std::size_t points = std::max(row.printed_points.size(), row.optimum_points.size());
        for (std::size_t i = 0; i < points; ++i) {
            const auto ordinate = [i](const std::vector<double>& ordinates) {
                return i < ordinates.size() ? std::optional(ordinates[i]) : std::nullopt;
            };
            text += CsvLine{}
                        .count(row.segments)
                        .count(static_cast<long>(i))
                        .number(static_cast<double>(i) / row.segments)
                        .number(ordinate(row.printed_points))
                        .number(ordinate(row.optimum_points))
                        .finish();
        }
    }
    return text;
}

std::string convergence_csv(const ReferenceTable& table) {
    std::string text = "segments," + figure_columns("printed") + "," + figure_columns("points") +
                       ",points_end_acceleration," + figure_columns("corrected") + "," +
                       figure_columns("optimum") + ",lower_bound,gap,verdict,reason,any_curve_limit,note\n";
    for (const ConvergenceRow& row : table.convergence) {
        CsvLine line;
        line.count(row.segments);
        add_figures(line, row.printed);
        add_figures(line, row.points_exact);
        line.number(row.points_end_acceleration);
        add_figures(line, row.corrected_exact);
        add_figures(line, optimum_figures(row.optimum));
        add_proof(line, row.optimum.certificate);
        text += line.number(table.limit.objective).words(row.note).finish();
    }
    return text;
}

std::string laws_csv(const ReferenceTable& table) {
    std::string text = "name,key,printed_velocity,printed_acceleration,printed_jerk," +
                       figure_columns("exact") + ",loss_percent\n";
    for (const LawComparisonRow& row : table.laws) {
        CsvLine line;
        line.words(row.name).words(row.key);
        if (row.printed)
            line.number(row.printed->velocity).number(row.printed->acceleration).number(row.printed->jerk);
        else
            line.blank(3);
        add_figures(line, row.exact);
        text += line.number(row.loss_percent).finish();
    }
    return text;
}

std::string weights_csv(const ReferenceTable& table) {
    std::string text =
        "weight_velocity,weight_acceleration,weight_jerk,y4_printed,y4_optimum,printed_objective," +
        figure_columns("optimum") + ",lower_bound,gap,verdict,reason,any_curve_limit\n";
    for (const WeightEffectRow& row : table.weights) {
        CsvLine line;
        line.number(row.velocity).number(row.acceleration).number(row.jerk);
        line.number(row.printed_fourth_ordinate);
        line.number(row.optimum.curve ? std::optional(row.fourth_ordinate) : std::nullopt);
        line.number(row.printed_objective);
        add_figures(line, optimum_figures(row.optimum));
        add_proof(line, row.optimum.certificate);
        text += line.number(row.limit.objective).finish();
    }
    return text;
}

}  // namespace camopt
