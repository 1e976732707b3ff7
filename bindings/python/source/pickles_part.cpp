// SPDX-License-Identifier: MIT
// Solutions and tables of sweeps in pickles: what another process makes the same value of.
//
// A solution is its scene, result.json and certificate.json, as a result folder is; and what they lack of a
// scene without a motion, which is short and kept as tuples.
#include "bindings/python/source/parts.hpp"
#include "report/json/result_reader.hpp"
#include "studies/restored/restored_solution.hpp"

#include <algorithm>
#include <camopt/result_json.hpp>
#include <pybind11/stl.h>
#include <string>
#include <tuple>
#include <vector>

namespace camopt::python {

namespace {

/// Of a struct the members that are kept, in their order.
auto members(auto& row) {
    using Row = std::remove_const_t<std::remove_reference_t<decltype(row)>>;
    if constexpr (std::is_same_v<Row, CompanionChange>) return std::tie(row.key, row.given, row.solved);
    if constexpr (std::is_same_v<Row, Relaxation>)
        return std::tie(row.key, row.given, row.needed, row.solved, row.ruled_out);
    if constexpr (std::is_same_v<Row, ConflictReport>)
        return std::tie(row.key, row.at, row.weight, row.remark);
    if constexpr (std::is_same_v<Row, Explanation>)
        return std::tie(row.any_motion, row.alone, row.set_points, row.finest, row.unsettled, row.seconds,
                        row.allowed, row.own_limit);
}

template <class Row>
py::tuple state_of(const Row& row) {
    return std::apply([](const auto&... all) { return py::make_tuple(all...); }, members(row));
}

template <class Row>
Row row_of(const py::handle& state) {
    Row row;
    std::size_t at = 0;
    const auto values = py::reinterpret_borrow<py::tuple>(state);
    std::apply(
        [&](auto&... all) {
            ((all = values[at++].template cast<std::remove_reference_t<decltype(all)>>()), ...);
        },
        members(row));
    return row;
}

template <class Row>
py::list states_of(const std::vector<Row>& rows) {
    py::list states;
    for (const Row& row : rows) states.append(state_of(row));
    return states;
}

template <class Row>
std::vector<Row> rows_of(const py::handle& states) {
    std::vector<Row> rows;
    for (const py::handle state : states) rows.push_back(row_of<Row>(state));
    return rows;
}

/// (relaxation, what changes along with each)
py::tuple relaxation_state(const std::vector<Relaxation>& rows) {
    py::list also;
    for (const Relaxation& row : rows) also.append(states_of(row.also));
    return py::make_tuple(states_of(rows), also);
}

std::vector<Relaxation> relaxation_of(const py::handle& state) {
    const auto parts = py::reinterpret_borrow<py::tuple>(state);
    std::vector<Relaxation> rows = rows_of<Relaxation>(parts[0]);
    const py::list also = parts[1];
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].also = rows_of<CompanionChange>(also[i]);
    return rows;
}

py::tuple state_of_solution(const SolvedScene& solved) {
    const Solution& solution = *solved.solution;
    py::object explanation = py::none();
    if (const auto& found = solution.explanation)
        explanation =
            py::make_tuple(state_of(*found), relaxation_state(found->together), static_cast<int>(found->end));
    return py::make_tuple(solved.given, result_json(solution, solved.origin),
                          certificate_json(solution.certificate), relaxation_state(solution.relaxation),
                          explanation, states_of(solution.conflict));
}

Explanation explanation_of(const py::tuple& state) {
    auto explanation = row_of<Explanation>(state[0]);
    explanation.together = relaxation_of(state[1]);
    explanation.end = static_cast<ExplanationEnd>(state[2].cast<int>());
    return explanation;
}

SolvedScene solution_of_state(const py::tuple& state) {
    constexpr const char* name = "pickled solution";
    SolvedScene solved;
    solved.given = state[0];
    const auto& read = solved.given.cast<const ReadScene&>();
    const auto scene = [&]() -> const Scene& { return read.scene; };
    const ResultRecord record =
        read_result(state[1].cast<std::string>(), name, scene, RecordedMotion::optional);
    Solution solution = restored_solution(read.scene, record);
    solution.certificate = certificate_of_text(state[2].cast<std::string>(), name);
    solution.relaxation = relaxation_of(state[3]);
    if (!state[4].is_none()) solution.explanation = explanation_of(state[4]);
    solution.conflict = rows_of<ConflictReport>(state[5]);
    solved.origin = read.origin();
    solved.solution = std::make_shared<const Solution>(std::move(solution));
    return solved;
}

}  // namespace

void add_pickles(py::class_<SolvedScene>& type) {
    // A solution does not change: a copy is the same.
    type.def(py::pickle(&state_of_solution, &solution_of_state))
        .def("__copy__", [](const SolvedScene& solved) { return solved; })
        .def(
            "__deepcopy__", [](const SolvedScene& solved, const py::dict&) { return solved; },
            py::arg("memo"));
}

}  // namespace camopt::python
