// SPDX-License-Identifier: MIT
#include "bindings/c/control.hpp"

#include "bindings/c/failure.hpp"
#include "bindings/c/structs.hpp"

#include <string>

namespace camopt::c {

SolveControl CallbackControl::control() {
    SolveControl control;
    // Also without `cancel`: a callback that threw stops the search.
    if (options_.cancel != nullptr || options_.progress != nullptr)
        control.stop_requested = [this] { return asked_to_stop(); };
    if (options_.progress != nullptr)
        control.progress = [this](const Progress& progress) { report(progress); };
    return control;
}

bool CallbackControl::asked_to_stop() {
    // Once said is said: a callback that changes its mind would leave a search half stopped.
    if (!stopped() && options_.cancel != nullptr)
        call([&] { stopped_ = options_.cancel(options_.user) != 0; });
    return stopped();
}

void CallbackControl::report(const Progress& progress) {
    call([&] {
        const std::string text(progress.message);
        const camopt_progress shown{sizeof(camopt_progress),
                                    text.c_str(),
                                    seconds(),
                                    progress.round.value_or(0),
                                    number_or_absent(progress.incumbent),
                                    number_or_absent(progress.bound),
                                    number_or_absent(progress.violation)};
        options_.progress(&shown, options_.user);
    });
}

double CallbackControl::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

void CallbackControl::finish() const {
    if (!thrown_) return;
    try {
        std::rethrow_exception(thrown_);
    } catch (const std::exception& error) {
        throw Failure(CAMOPT_ERROR_CALLBACK, std::string("a callback threw: ") + error.what());
    } catch (...) {
        throw Failure(CAMOPT_ERROR_CALLBACK, "a callback threw an exception that is not a std::exception");
    }
}

}  // namespace camopt::c
