// SPDX-License-Identifier: MIT
#include "solvers/structured/structured_solver.hpp"

#include "solvers/backend_support.hpp"
#include "solvers/structured/linear_rows_solver.hpp"
#include "solvers/structured/sequential_solver.hpp"

#include <new>

namespace camopt {
namespace {

/// glibc returns freed memory to the system beyond a threshold that follows the largest block freed so far. A
/// sequence of solves would fetch the same pages again and again, which takes longer than the solves.
void keep_freed_memory() {
    constexpr std::size_t bytes = std::size_t{16} << 20;
    static const bool once = [] {
        ::operator delete(::operator new(bytes, std::nothrow));
        return true;
    }();
    static_cast<void>(once);
}

class StructuredSolver final : public Solver {
 public:
    std::string_view name() const override { return "structured"; }
    BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start, const BackendOptions& options,
                           const SolveControl& control) const override {
        keep_freed_memory();
        const NlpShape& shape = problem.shape();
        static const SolverEntry entry = structured_entry();
        check_backend_input(entry, problem, start, options);
        const bool linear =
            std::all_of(shape.rows.begin(), shape.rows.end(), [](const RowKind& row) { return row.linear; });
        if (!shape.convex || !linear)
            return structured::sequential_minimize(problem, start, options, control);
        return structured::linear_rows_minimize(problem, start, options, control);
    }
};

}  // namespace

std::unique_ptr<Solver> make_structured_solver() {
    return std::make_unique<StructuredSolver>();
}

}  // namespace camopt
