// SPDX-License-Identifier: MIT
#include "shop/plc/table_check.hpp"

#include "core/text/parsing.hpp"
#include "core/version.hpp"
#include "report/csv/csv_line.hpp"
#include "report/json/json_text.hpp"
#include "report/view/columns.hpp"
#include "shop/plc/plc_export.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// A column that is a derivative of the motion, and its value where that derivative is 1 by degrees.
struct MotionColumn {
    int order = 0;
    double per_degree = 0.0;
};

std::optional<MotionColumn> motion_column(const TableColumn& column, const MotionSpec& motion,
                                          const MasterCurve& curve) {
    if ((column.need & ~(ColumnNeed::speed | ColumnNeed::length | ColumnNeed::angle)) != 0)
        return std::nullopt;
    for (std::size_t order = 0; order < 4; ++order) {
        TableRow row;
        row.motion.derivative[order] = 1.0;  // normalised
        const double value = column.value(motion, row);
        if (value != 0.0)
            return MotionColumn{
                static_cast<int>(order),
                value / curve.lift() * std::pow(curve.degrees_per_x(), static_cast<int>(order))};
    }
    return std::nullopt;
}

double number_of(const std::string& cell) {
    return number_in(cell).value_or(std::numeric_limits<double>::quiet_NaN());
}

/// The polynomial whose derivative of that order is the line through two rows; what lies below is not looked
/// at.
PolynomialPiece line_between(double begin, double end, double first, double second, int order) {
    PolynomialPiece piece{begin, end, std::vector<double>(static_cast<std::size_t>(order) + 2, 0.0)};
    const double factorial = std::tgamma(order + 1.0);
    piece.coefficients[static_cast<std::size_t>(order)] = first / factorial;
    piece.coefficients.back() = (second - first) / (end - begin) / (factorial * (order + 1));
    return piece;
}

class TableReader {
 public:
    TableReader(const Solution& solution, const UniformTable& table)
        : motion_(solution.scene.motion),
          curve_(solution.master_turn(), motion_),
          records_(csv_records(table.text, "table.csv")),
          columns_(columns_of(records_.front().cells)) {
        const auto angle = std::ranges::find(columns_, "theta_deg", &TableColumn::key);
        if (angle == columns_.end()) return;
        for (std::size_t i = 1; i < records_.size(); ++i)
            angles_.push_back(
                number_of(records_[i].cells[static_cast<std::size_t>(angle - columns_.begin())]));
    }

    [[nodiscard]] Json departures(Json& left_out) const {
        Json found = Json::object();
        const bool angles = has_angles();
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            const auto column = motion_column(*columns_[i], motion_, curve_);
            if (column && angles)
                found[columns_[i]->key] = departure(i, *column);
            else if (columns_[i]->key != "theta_deg")
                left_out.push_back(columns_[i]->key);
        }
        return found;
    }

 private:
    /// Few digits may give two rows the same angle.
    [[nodiscard]] bool has_angles() const {
        return angles_.size() > 1 && std::ranges::is_sorted(angles_, std::less_equal());
    }

    [[nodiscard]] double departure(std::size_t index, const MotionColumn& column) const {
        const auto value = [&](std::size_t row) {
            return number_of(records_[row + 1].cells[index]) / column.per_degree;
        };
        double largest = 0.0, first = value(0);
        for (std::size_t i = 0; i + 1 < angles_.size(); ++i) {
            const double second = value(i + 1);
            const PolynomialPiece piece =
                line_between(angles_[i], angles_[i + 1], first, second, column.order);
            const MasterStretch stretch{angles_[i], std::min(angles_[i + 1], curve_.end())};
            largest =
                std::max(largest, largest_difference(curve_, piece, stretch, column.order, largest).value);
            first = second;
        }
        return figure_not_exceeded(largest * std::abs(column.per_degree));
    }

    const MotionSpec& motion_;
    MasterCurve curve_;
    std::vector<CsvRecord> records_;
    Columns columns_;
    std::vector<double> angles_;
};

}  // namespace

TableCheck table_check(const Solution& solution, const UniformTable& table) {
    Json left_out = Json::array();
    const Json departures = TableReader(solution, table).departures(left_out);
    TableCheck check;
    for (const auto& [key, value] : departures.items())
        check.words += fmt::format(
            "{}{} {}", check.words.empty() ? "  straight lines between rows depart by at most " : ", ", key,
            short_text(value.get<double>(), 3));
    if (!check.words.empty()) check.words += "\n";
    check.json = export_check_json(solution, {{"camopt", version()},
                                              {"kind", "table"},
                                              {"file", "table.csv"},
                                              {"rule", "straight lines between the rows"},
                                              {"departure", departures},
                                              {"left_out", left_out}});
    return check;
}

}  // namespace camopt
