// SPDX-License-Identifier: MIT
// A clock for tests of time limits: it advances by a step whenever it is read, and every solver reads it once
// an iteration. A limit of N steps then ends a solve after N readings, on every machine.
#pragma once

#include "solvers/solver.hpp"

namespace camopt::testing_support {

struct CountingClock {
    double step = 1.0;  ///< seconds
    long readings = 0;

    /// It sets no limit: Scene::solver.max_seconds ends a solve. The clock must outlive it.
    [[nodiscard]] SolveControl control() {
        SolveControl control;
        control.deadline = Deadline::after(1e15, [this] { return step * static_cast<double>(++readings); });
        return control;
    }
};

}  // namespace camopt::testing_support
