// SPDX-License-Identifier: MIT
// Sweeps from Python: the rows of the command line's sweep, solved by threads of this process.
#include "bindings/python/source/parts.hpp"
#include "core/platform/workers.hpp"
#include "core/text/parsing.hpp"
#include "report/csv/csv_line.hpp"
#include "report/csv/sweep_csv.hpp"
#include "report/document/document_text.hpp"
#include "report/sweep/sweep_document.hpp"
#include "studies/pareto/sweep_front.hpp"
#include "studies/sweep/sweep_run.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <camopt/errors.hpp>
#include <camopt/sweep.hpp>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace camopt::python {

namespace {

// A sweep by threads of this process. The thread that called waits for them, answers Ctrl-C and calls the
// progress callback.
struct SweepTask {
    const ReadScene& given;
    SweepPlan plan;
    std::optional<int> chunk;  ///< rows of a chunk; none: as the command line takes them
    int workers = 1;
};

/// What a function of the user's raises ends the sweep: a row that throws would be a failed row.
class OwnFaults {
 public:
    Scene watched(Scene scene) {
        for (OwnTerm& term : scene.own_terms) term.formula = told(std::move(term.formula));
        for (OwnLimit& limit : scene.own_limits) limit.formula = told(std::move(limit.formula));
        return scene;
    }
    [[nodiscard]] bool any() const { return any_; }
    /// Throws the first one.
    void rethrow() {
        const std::lock_guard lock(mutex_);
        if (first_) std::rethrow_exception(first_);
    }

 private:
    MotionFormula told(MotionFormula formula) {
        return [this, own = std::move(formula)](const MotionPoint& point) {
            try {
                return own(point);
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!first_) first_ = std::current_exception();
                any_ = true;
                throw;
            }
        };
    }

    std::mutex mutex_;
    std::exception_ptr first_;
    std::atomic<bool> any_{false};
};

/// Without the interpreter's lock. Where the watch stops it, the rows that were finished until then. Throws
/// InputError for a row that is wrong, before anything is solved.
SweepTable solve_sweep(const SweepTask& task, Watch& watch) {
    OwnFaults faults;
    SweepScenes scenes(task.plan, [&](std::span<const std::string> row) { return task.given.with(row); });
    SweepTable table;
    table.columns = check_rows(scenes);
    const Chunking chunking{task.plan.rows(), task.chunk.value_or(chunk_size_for(scenes))};
    const SolveControl control{[&] { return watch.stopped() || faults.any(); }, {}};
    std::mutex busy;
    std::size_t solved = 0, told = 0;
    PoolTask pool;
    for (int chunk = 0; chunk < chunking.count(); ++chunk) pool.units.push_back(chunk);
    pool.workers = task.workers;
    pool.work = [&](int chunk, const std::function<void(int)>& tell) {
        SweepScenes own(task.plan, [&](std::span<const std::string> row) {
            return faults.watched(task.given.with(row));
        });
        (void)solve_chunk(own, chunking.range(chunk), control, [&](const SweepRow& row) {
            const std::lock_guard lock(busy);
            table.rows.push_back(row);
            tell(row.number);
        });
        faults.rethrow();
    };
    pool.told = [&](int) { ++solved; };
    pool.tick = [&] {
        watch.look_for_signals();
        if (solved > told) watch.tell(solved, static_cast<std::size_t>(task.plan.rows()));
        told = solved;
    };
    pool.stop_requested = [&] { return watch.stopped(); };
    (void)run_workers(pool);
    std::ranges::sort(table.rows, {}, &SweepRow::number);
    return table;
}

/// Keys that vary together, and their points, one a row.
using Axis =
    std::pair<std::vector<std::string>, py::array_t<double, py::array::c_style | py::array::forcecast>>;

SweepAxis axis_of(const Axis& given) {
    const auto& [keys, values] = given;
    const std::string name = fmt::format("{}", fmt::join(keys, ", "));
    const auto columns = static_cast<py::ssize_t>(keys.size());
    const bool fits = values.ndim() == 2 ? values.shape(1) == columns : values.ndim() == 1 && columns == 1;
    if (!fits)
        throw InputError(
            fmt::format("{}: found an array of {} dimension(s); allowed: one value a row for a single key, "
                        "for several keys an array with a column each",
                        name, values.ndim()));
    if (values.size() == 0) throw InputError(fmt::format("{}: found no value; allowed: at least one", name));
    return {keys, std::vector<double>(values.data(), values.data() + values.size())};
}

/// A column of sweep.csv; an empty cell is NaN.
template <class Number>
py::array_t<Number> numbers_of(std::span<const CsvRecord> rows, std::size_t column) {
    py::array_t<Number> numbers(static_cast<py::ssize_t>(rows.size()));
    std::ranges::transform(rows, numbers.mutable_data(), [column](const CsvRecord& row) {
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        return static_cast<Number>(number_in(row.cells[column]).value_or(none));
    });
    return numbers;
}

py::object words_of(std::span<const CsvRecord> rows, std::size_t column) {
    py::list words;
    for (const CsvRecord& row : rows) words.append(row.cells[column]);
    return py::module_::import("numpy").attr("array")(words, py::arg("dtype") = "str");
}

/// The columns of sweep.csv, name by name.
py::dict dictionary(const SweepTable& table) {
    static const std::set<std::string_view> words = {"verdict", "reason", "active_limits", "proof"},
                                            counts = {"row", "iterations", "exchange_rounds",
                                                      "profile_points"};
    const std::vector<CsvRecord> records = csv_records(sweep_csv(table), "sweep.csv");
    const std::span rows = std::span(records).subspan(1);
    py::dict columns;
    for (std::size_t i = 0; i < records.front().cells.size(); ++i) {
        const std::string& name = records.front().cells[i];
        const bool counted = counts.contains(name) || name.ends_with("_evaluations");
        columns[name.c_str()] = words.contains(name)     ? words_of(rows, i)
                                : name == "pareto_front" ? numbers_of<bool>(rows, i)
                                : counted                ? numbers_of<py::ssize_t>(rows, i)
                                                         : py::object(numbers_of<double>(rows, i));
    }
    return columns;
}

SweepTable swept(const ReadScene& given, const std::vector<Axis>& axes, std::optional<int> chunk, int workers,
                 py::object progress) {
    std::vector<SweepAxis> all(axes.size());
    std::ranges::transform(axes, all.begin(), axis_of);
    if (workers < 1) throw InputError(fmt::format("workers: found {}; allowed: 1 or more", workers));
    if (chunk && *chunk < 1) throw InputError(fmt::format("chunk: found {}; allowed: 1 or more", *chunk));
    Watch watch(std::move(progress));
    SweepTable table;
    {
        const py::gil_scoped_release others_run;
        table = solve_sweep({given, sweep_grid(all), chunk, workers}, watch);
        mark_front(table);
        watch.look_for_signals();
    }
    watch.raise_what_came("table", py::cast(table));
    return table;
}

}  // namespace

void add_sweeps(py::module_& module) {
    py::class_<SweepTable>(module, "SweepTable", "The rows of a sweep, by number: one solve each.")
        .def(py::pickle(
            [](const SweepTable& table) {
                return py::make_tuple(sweep_csv(table), table.columns.criteria,
                                      static_cast<int>(table.columns.length_unit));
            },
            [](const py::tuple& state) {
                SweepTable table = read_sweep_csv(state[0].cast<std::string>(), "pickled sweep");
                table.columns.criteria = state[1].cast<std::vector<std::string>>();
                table.columns.length_unit = static_cast<LengthUnit>(state[2].cast<int>());
                return table;
            }))
        .def("__len__", [](const SweepTable& table) { return table.rows.size(); })
        .def_property_readonly(
            "keys", [](const SweepTable& table) { return table.columns.keys; }, "The keys that vary.")
        .def(
            "to_dict", [](const SweepTable& table) { return dictionary(table); },
            "The columns {name: array}, those of sweep.csv: pandas.DataFrame(table.to_dict()) is the "
            "table.\n\n"
            "A number that does not exist (the peaks of an infeasible row) is NaN.")
        .def(
            "csv", [](const SweepTable& table) { return sweep_csv(table); },
            "The text of sweep.csv, as `camopt sweep` writes it.")
        .def(
            "summary", [](const SweepTable& table) { return console_text(sweep_summary(table)); },
            "The sweep in a few lines.")
        .def("__str__", [](const SweepTable& table) { return console_text(sweep_summary(table)); });
    module.def(
        "sweep", &swept, py::arg("scene"), py::arg("axes"), py::arg("chunk") = py::none(),
        py::arg("workers") = 1, py::arg("progress") = py::none(),
        "Solves every point of the grid of the axes [(keys, values), …]. progress: called with (done, all).");
    module.def(
        "varied_key",
        [](const std::string& text) {
            const SweepAxis axis = varied_key(text);
            return py::make_tuple(axis.keys, py::array_t<double>(static_cast<py::ssize_t>(axis.values.size()),
                                                                 axis.values.data()));
        },
        py::arg("text"), "Keys and values of \"KEY=a:b:count\", \"KEY=a:b:count:log\" or \"KEY=v1,v2,…\".");
    module.def(
        "simplex",
        [](int divisions) {
            const SweepAxis axis = simplex_weights(divisions);
            const auto columns = static_cast<py::ssize_t>(axis.keys.size());
            py::array_t<double> values({static_cast<py::ssize_t>(axis.points()), columns});
            std::copy(axis.values.begin(), axis.values.end(), values.mutable_data());
            return py::make_tuple(axis.keys, values);
        },
        py::arg("divisions"),
        "Keys and values of all weights i/N, j/N, k/N of velocity, acceleration and jerk with i + j + k = "
        "N.");
}

}  // namespace camopt::python
