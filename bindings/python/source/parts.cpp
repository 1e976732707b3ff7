// SPDX-License-Identifier: MIT
#include "bindings/python/source/parts.hpp"

#include "core/errors.hpp"
#include "core/text/parsing.hpp"

#include <algorithm>
#include <camopt/errors.hpp>
#include <camopt/scene_file.hpp>

namespace camopt::python {

namespace {

/// Messages about a setting begin with the option of the command line that it would have come from; here
/// there is none.
std::string without_option(std::string_view message) {
    constexpr std::string_view option = "--set ";
    if (message.starts_with(option)) message.remove_prefix(option.size());
    return std::string(message);
}

/// A weight for the reader, which has no own terms to look at, and taken back after it.
constexpr const char* stand_in = "objective.velocity=1";

Scene read(const std::string& text, const std::string& source, std::vector<std::string> settings,
           const OwnRules& own) {
    const bool weighed = std::ranges::any_of(
        settings, [](const std::string& setting) { return setting.starts_with("objective.velocity="); });
    const bool stands_in = own.alone && !weighed;
    if (stands_in) settings.emplace_back(stand_in);
    try {
        Scene scene = scene_of_toml(text, settings, source);
        if (stands_in) scene.objective.velocity = 0.0;
        scene.own_terms = own.terms;
        scene.own_limits = own.limits;
        validate(scene);
        return scene;
    } catch (const UnavailableError& error) {
        throw UnavailableError(without_option(error.what()));
    } catch (const InputError& error) {
        throw InputError(without_option(error.what()));
    }
}

/// What stands before the separator, and no longer in `rest`.
std::string_view taken(std::string_view& rest, char separator) {
    const std::size_t end = rest.find(separator);
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    return part;
}

// Taking the interpreter's lock from another busy thread costs up to 5 ms; people do not feel 20.
constexpr std::chrono::milliseconds between_looks{20};

}  // namespace

ReadScene::ReadScene(std::string toml, std::string source_name, std::vector<std::string> all_settings,
                     OwnRules own_rules)
    : text(std::move(toml)),
      source(std::move(source_name)),
      settings(std::move(all_settings)),
      own(std::move(own_rules)),
      scene(read(text, source, settings, own)) {}

Scene ReadScene::with(std::span<const std::string> more) const {
    std::vector<std::string> all = settings;
    all.insert(all.end(), more.begin(), more.end());
    return read(text, source, all, own);
}

std::string ReadScene::toml() const {
    return input::scene_with_overrides(text, source, settings);
}

RunOrigin ReadScene::origin() const {
    const bool complete = own.terms.empty() && own.limits.empty();
    return {source, "", complete ? toml() : ""};
}

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

SolveControl Watch::control() {
    SolveControl control;
    control.stop_requested = [this] {
        if (stopped_) return true;
        const Clock::time_point now = Clock::now();
        if (now - looked_ < between_looks) return false;
        looked_ = now;
        return look_for_signals();
    };
    if (wants_progress())
        control.progress = [this](const Progress& now) {
            tell(ProgressValue{std::string(now.message), now.round, now.incumbent, now.bound, now.violation});
        };
    return control;
}

bool Watch::look_for_signals() {
    if (stopped_) return true;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) {
        py::error_already_set error;
        keep(error);
    }
    return stopped_;
}

void Watch::keep(py::error_already_set& error) {
    if (stopped_) return;
    raised_ = error.value();
    if (raised_.is_none()) raised_ = error.type()();
    if (error.trace()) PyException_SetTraceback(raised_.ptr(), error.trace().ptr());
    stopped_ = true;
}

void Watch::raise_what_came(const char* name, const py::object& found) {
    if (!stopped_) return;
    if (PyObject_SetAttrString(raised_.ptr(), name, found.ptr()) != 0) PyErr_Clear();  // it takes none
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised_.ptr())), raised_.ptr());
    throw py::error_already_set();
}

}  // namespace camopt::python
