// SPDX-License-Identifier: MIT
#include "bindings/python/source/watch.hpp"

namespace camopt::python {

namespace {

// Taking the interpreter's lock from another busy thread costs up to 5 ms; people do not feel 20.
constexpr std::chrono::milliseconds between_looks{20};

}  // namespace

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
