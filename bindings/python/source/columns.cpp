// SPDX-License-Identifier: MIT
#include "bindings/python/source/columns.hpp"

#include "core/errors.hpp"
#include "core/text/parsing.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt::python {

namespace {

/// What stands before the separator, and no longer in `rest`.
std::string_view taken(std::string_view& rest, char separator) {
    const std::size_t end = rest.find(separator);
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    return part;
}

}  // namespace

pybind11::dict columns_of_csv(std::string_view csv, double empty) {
    std::vector<std::string> names;
    std::string_view head = taken(csv, '\n');
    while (!head.empty()) names.emplace_back(taken(head, ','));
    std::vector<std::vector<double>> columns(names.size());
    while (!csv.empty()) {
        std::string_view line = taken(csv, '\n');
        for (std::vector<double>& column : columns) {
            const std::string_view cell = taken(line, ',');
            const std::optional<double> value = cell.empty() ? empty : number_in(cell);
            if (!value) throw ModelError("a table of numbers holds \"" + std::string(cell) + "\"");
            column.push_back(*value);
        }
    }
    pybind11::dict table;
    for (std::size_t i = 0; i < names.size(); ++i)
        table[names[i].c_str()] =
            pybind11::array_t<double>(static_cast<pybind11::ssize_t>(columns[i].size()), columns[i].data());
    return table;
}

}  // namespace camopt::python
