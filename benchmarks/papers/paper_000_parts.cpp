// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_000_parts.hpp"

#include "core/text/parsing.hpp"
#include "core/units.hpp"

namespace camopt::feeding_paper {

using units::degree, units::inch;

const ColumnInfo& column_info(int column) {
    static constexpr std::array<ColumnInfo, columns> table = {{{"L", "in", inch},
                                                               {"θ", "deg", degree},
                                                               {"θ′", "rad/s", 1.0},
                                                               {"θ″", "rad/s²", 1.0},
                                                               {"Y", "in", inch},
                                                               {"Y′", "in/s", inch},
                                                               {"Y″", "in/s²", inch}}};
    return table[static_cast<std::size_t>(column)];
}

std::span<const PrintedRow> printed_rows() {
    static constexpr std::array<PrintedRow, 13> table = {{
        {"0.0", {"1.500", "0.00", "0.000", "0.0", "-0.656", "0.0", "0"}, false},
        {"0.087", {"5.276", "0.00", "-0.043", "-143.4", "-0.656", "0.67", "2236"}, true},
        {"0.128", {"9.689", "-6.00", "-4.49", "-107.1", "1.125", "86.0", "2097"}, true},
        {"0.130", {"9.900", "-6.90", "-4.51", "278.4", "1.256", "80.0", "-479"}, true},
        {"0.150", {"12.765", "-9.00", "-0.157", "168.1", "2.042", "2.8", "-2985"}, true},
        {"0.152", {"13.000", "-9.00", "0.00", "0.0", "2.039", "0.0", "0"}, false},
        {"0.163", {"12.765", "-9.00", "0.00", "0.0", "2.039", "0.0", "0"}, false},
        {"0.164", {"12.529", "-8.98", "0.332", "382.8", "2.033", "-5.9", "-6800"}, true},
        {"0.178", {"9.488", "-6.21", "7.193", "652.4", "1.171", "-127.5", "-11160"}, true},
        {"0.179", {"9.290", "-5.78", "7.344", "-254.0", "1.039", "-129.7", "4978"}, true},
        {"0.205", {"5.000", "0.00", "0.016", "-345.9", "-0.656", "-0.3", "5395"}, true},
        {"0.206", {"4.875", "0.00", "0.00", "0.0", "-0.656", "0.0", "0"}, false},
        {"0.258", {"1.500", "0.00", "0.00", "0.0", "-0.656", "0.0", "0"}, false},
    }};
    return table;
}

std::span<const Misprint> misprints() {
    static constexpr std::array<Misprint, 9> table = {{
        {"0.128", theta, -6.06, -6.05, "goes with Y = 1.125 and with arc 1"},
        {"0.128", theta_velocity, -4.86, -4.85, "Y′ = 86.0 over the slope dY/dθ"},
        {"0.128", feeder_acceleration, 2085.0, 2090.0, "every rocker that fits; perhaps 2087"},
        {"0.130", distance, 9.8925, 9.8935, "the roller's time base; arcs fit far worse with 9.900"},
        {"0.130", theta, -6.49, -6.47, "goes with Y = 1.256"},
        {"0.130", feeder_acceleration, -4850.0, -4750.0, "a lost digit"},
        {"0.150", theta, -9.0145, -9.0055,
         "Y = 2.042 of this row; the other end rows have 2.039: arc 2 is about 0.01 deg off the 9 deg line"},
        {"0.152", distance, 13.0025, 13.0035, "the roller's time base"},
        {"0.205", distance, 5.0055, 5.0065, "the roller's time base"},
    }};
    return table;
}

double instant_of(std::string_view time) {
    constexpr double sample_step = 0.00158;  // s, the hundredth part of the forward stroke
    const double printed = required_number(time);
    return printed < turning_time ? sample_step * std::round(printed / sample_step) : printed;
}

std::array<double, columns> computed_row(const PrintedRow& row) {
    const double time = instant_of(row.time);
    const FeederState state = stroke_at(time).at(time);
    const FollowerState& y = state.feeder;
    std::array<double, columns> values = {state.roller.distance,
                                          state.body.angle,
                                          state.body.velocity,
                                          state.body.acceleration,
                                          y.s,
                                          y.velocity,
                                          y.acceleration};
    for (int i = 0; i < columns; ++i) values[static_cast<std::size_t>(i)] /= column_info(i).unit_value;
    return values;
}

double half_digit(std::string_view printed) {
    const auto point = printed.find('.');
    const auto decimals = point == std::string_view::npos ? 0 : static_cast<int>(printed.size() - point - 1);
    return 0.5 * std::pow(10.0, -decimals);
}

Agreement agreement() {
    constexpr double rounding = 1.0 + 1e-9;  // a value on the edge of the rounding is inside
    Agreement result;
    for (const PrintedRow& row : printed_rows()) {
        if (!row.moving) continue;
        const auto values = computed_row(row);
        for (int i = theta; i < columns; ++i) {
            const std::string_view words = row.cells[static_cast<std::size_t>(i)];
            const double printed = required_number(words), half = half_digit(words);
            const double difference = std::abs(values[static_cast<std::size_t>(i)] - printed);
            ++result.entries;
            if (difference <= half * rounding) ++result.rounded;
            if (difference <= 5.0 * half || difference <= 0.003 * std::abs(printed)) ++result.close;
        }
    }
    return result;
}

}  // namespace camopt::feeding_paper
