// SPDX-License-Identifier: MIT
#include "benchmarks/linear/clp_rival.hpp"

#include <Clp_C_Interface.h>
#include <chrono>
#include <memory>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double tolerance = 1e-9;

struct FreeModel {
    void operator()(Clp_Simplex* model) const { Clp_deleteModel(model); }
};
struct FreeOptions {
    void operator()(Clp_Solve* options) const { ClpSolve_delete(options); }
};
using Model = std::unique_ptr<Clp_Simplex, FreeModel>;
using Options = std::unique_ptr<Clp_Solve, FreeOptions>;

struct Method {
    const char* name;
    int solve;     // ClpSolve::SolveType: 0 dual, 1 primal, 4 barrier without crossover
    int presolve;  // ClpSolve::PresolveType: 0 on, 1 off
};
constexpr Method methods[] = {{"dual", 0, 1},
                              {"dual, presolved", 0, 0},
                              {"primal", 1, 1},
                              {"primal, presolved", 1, 0},
                              {"barrier, no crossover", 4, 1}};

const Method& method_of(const std::string& name) {
    for (const Method& method : methods)
        if (name == method.name) return method;
    return methods[0];
}

Model loaded(const LinearProgram& program) {
    Model model(Clp_newModel());
    Clp_setLogLevel(model.get(), 0);
    Clp_loadProblem(model.get(), static_cast<int>(program.cost.size()),
                    static_cast<int>(program.row_lower.size()), program.rows.outerIndexPtr(),
                    program.rows.innerIndexPtr(), program.rows.valuePtr(), program.x_lower.data(),
                    program.x_upper.data(), program.cost.data(), program.row_lower.data(),
                    program.row_upper.data());
    Clp_setPrimalTolerance(model.get(), tolerance);
    Clp_setDualTolerance(model.get(), tolerance);
    return model;
}

const char* status_word(int status) {
    constexpr const char* words[] = {"optimal", "primal infeasible", "dual infeasible", "stopped", "errors"};
    return status >= 0 && status < 5 ? words[status] : "unknown";
}

}  // namespace

std::vector<std::string> clp_methods() {
    std::vector<std::string> names;
    for (const Method& method : methods) names.emplace_back(method.name);
    return names;
}

std::string clp_version() {
    return Clp_Version();
}

RivalRun run_clp(const LinearProgram& program, const std::string& name, double most_seconds) {
    const Model model = loaded(program);
    const Options options(ClpSolve_new());
    const Method& method = method_of(name);
    ClpSolve_setSolveType(options.get(), method.solve, -1);
    ClpSolve_setPresolveType(options.get(), method.presolve, -1);
    Clp_setMaximumSeconds(model.get(), most_seconds);
    RivalRun run;
    const Clock::time_point begin = Clock::now();
    Clp_initialSolveWithOptions(model.get(), options.get());
    run.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    run.status = status_word(Clp_status(model.get()));
    run.iterations = Clp_numberIterations(model.get());
    run.x = Eigen::Map<const Eigen::VectorXd>(Clp_primalColumnSolution(model.get()), program.cost.size());
    return run;
}

}  // namespace camopt::benchmarks
