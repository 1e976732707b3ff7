// SPDX-License-Identifier: MIT
// SUNDIALS: CVODE's BDF of orders 1 to 5, and ARKODE's singly diagonally implicit Runge-Kutta method of order
// 5, both with the Jacobian of the chain and dense linear algebra.
#include "benchmarks/trains/integrators.hpp"

#include <arkode/arkode_arkstep.h>
#include <cmath>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace trains {

namespace {

struct Problem {
    const Chain& chain;
    const std::vector<double> jacobian;
    long count = 0;
};

int rates_of(realtype x, N_Vector state, N_Vector rate, void* data) {
    auto& problem = *static_cast<Problem*>(data);
    if (++problem.count > most_evaluations) return -1;
    problem.chain.rates(x, N_VGetArrayPointer(state), N_VGetArrayPointer(rate));
    return 0;
}

int jacobian_of(realtype, N_Vector, N_Vector, SUNMatrix out, void* data, N_Vector, N_Vector, N_Vector) {
    const auto& problem = *static_cast<const Problem*>(data);
    const std::size_t n = problem.chain.states();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            SM_ELEMENT_D(out, static_cast<sunindextype>(i), static_cast<sunindextype>(j)) =
                problem.jacobian[i * n + j];
    return 0;
}

void quiet(int, const char*, const char*, char*, void*) {}

/// What both methods need, freed at the end.
struct Parts {
    SUNContext context = nullptr;
    N_Vector state = nullptr;
    SUNMatrix matrix = nullptr;
    SUNLinearSolver solver = nullptr;

    explicit Parts(std::size_t states) {
        const auto n = static_cast<sunindextype>(states);
        SUNContext_Create(nullptr, &context);
        state = N_VNew_Serial(n, context);
        N_VConst(0.0, state);
        matrix = SUNDenseMatrix(n, n, context);
        solver = SUNLinSol_Dense(state, matrix, context);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        SUNLinSolFree(solver);
        SUNMatDestroy(matrix);
        N_VDestroy(state);
        SUNContext_Free(&context);
    }
};

Run run_of(const Parts& parts, const Problem& problem, int flag) {
    if (problem.count > most_evaluations) return {{}, problem.count, "too many evaluations"};
    if (flag < 0) return {{}, problem.count, "flag " + std::to_string(flag)};
    const double* const begin = N_VGetArrayPointer(parts.state);
    return {std::vector<double>(begin, begin + problem.chain.states()), problem.count, "ok"};
}

Run backward_differences(const Chain& chain, double tolerance) {
    Problem problem{chain, chain.jacobian()};
    const Parts parts(chain.states());
    void* memory = CVodeCreate(CV_BDF, parts.context);
    CVodeSetErrHandlerFn(memory, quiet, nullptr);
    CVodeInit(memory, rates_of, 0.0, parts.state);
    CVodeSStolerances(memory, tolerance, tolerance);
    CVodeSetUserData(memory, &problem);
    CVodeSetLinearSolver(memory, parts.solver, parts.matrix);
    CVodeSetJacFn(memory, jacobian_of);
    CVodeSetMaxNumSteps(memory, most_evaluations);
    CVodeSetStopTime(memory, 1.0);
    realtype at = 0.0;
    const int flag = CVode(memory, 1.0, parts.state, &at, CV_NORMAL);
    CVodeFree(&memory);
    return run_of(parts, problem, flag);
}

Run diagonally_implicit(const Chain& chain, double tolerance) {
    Problem problem{chain, chain.jacobian()};
    const Parts parts(chain.states());
    void* memory = ARKStepCreate(nullptr, rates_of, 0.0, parts.state, parts.context);
    ARKStepSetErrHandlerFn(memory, quiet, nullptr);
    ARKStepSetOrder(memory, 5);
    ARKStepSStolerances(memory, tolerance, tolerance);
    ARKStepSetUserData(memory, &problem);
    ARKStepSetLinearSolver(memory, parts.solver, parts.matrix);
    ARKStepSetJacFn(memory, jacobian_of);
    ARKStepSetLinear(memory, 0);
    ARKStepSetMaxNumSteps(memory, most_evaluations);
    ARKStepSetStopTime(memory, 1.0);
    realtype at = 0.0;
    const int flag = ARKStepEvolve(memory, 1.0, parts.state, &at, ARK_NORMAL);
    ARKStepFree(&memory);
    return run_of(parts, problem, flag);
}

}  // namespace

std::vector<Integrator> sundials_integrators() {
    const std::vector<double> tolerances = {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13};
    return {{"BDF (CVODE)", true, false, tolerances, backward_differences},
            {"DIRK 5 (ARKODE)", true, false, tolerances, diagonally_implicit}};
}

}  // namespace trains
