// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "linear/rank_revealing_qr.hpp"

#include <SuiteSparseQR.hpp>

namespace camopt::internal {
namespace {

/// CHOLMOD's workspace, started and finished with the object.
class Workspace {
 public:
    Workspace() {
        cholmod_l_start(&common_);
        common_.print = 0;
    }
    ~Workspace() { cholmod_l_finish(&common_); }
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;
    cholmod_common* get() { return &common_; }

 private:
    cholmod_common common_{};
};

/// Non-owning view of `matrix` with its indices widened to SuiteSparse's.
struct WideView {
    explicit WideView(const Eigen::SparseMatrix<double>& matrix)
        : starts(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1),
          rows(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros()),
          values(matrix.valuePtr(), matrix.valuePtr() + matrix.nonZeros()) {
        header.nrow = static_cast<std::size_t>(matrix.rows());
        header.ncol = static_cast<std::size_t>(matrix.cols());
        header.nzmax = values.size();
        header.p = starts.data();
        header.i = rows.data();
        header.x = values.data();
        header.stype = 0;
        header.itype = CHOLMOD_LONG;
        header.xtype = CHOLMOD_REAL;
        header.dtype = CHOLMOD_DOUBLE;
        header.sorted = 1;
        header.packed = 1;
    }
    std::vector<SuiteSparse_long> starts, rows;
    std::vector<double> values;
    cholmod_sparse header{};
};

TriangularFactor copied(const cholmod_sparse& upper, const SuiteSparse_long* permutation) {
    const auto* starts = static_cast<const SuiteSparse_long*>(upper.p);
    const auto* rows = static_cast<const SuiteSparse_long*>(upper.i);
    const auto* values = static_cast<const double*>(upper.x);
    const auto columns = static_cast<SuiteSparse_long>(upper.ncol);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(starts[columns]));
    TriangularFactor result;
    for (SuiteSparse_long j = 0; j < columns; ++j) {
        result.column.push_back(static_cast<int>(permutation == nullptr ? j : permutation[j]));
        for (SuiteSparse_long p = starts[j]; p < starts[j + 1]; ++p)
            entries.emplace_back(static_cast<int>(rows[p]), static_cast<int>(j), values[p]);
    }
    result.upper.resize(static_cast<Eigen::Index>(upper.nrow), static_cast<Eigen::Index>(columns));
    result.upper.setFromTriplets(entries.begin(), entries.end());
    return result;
}

}  // namespace

TriangularFactor triangular_factor(const Eigen::SparseMatrix<double>& matrix, double tolerance,
                                   ColumnOrder order) {
    Workspace workspace;
    WideView view(matrix);
    cholmod_sparse* upper = nullptr;
    SuiteSparse_long* permutation = nullptr;
    const int ordering = order == ColumnOrder::natural ? SPQR_ORDERING_FIXED : SPQR_ORDERING_DEFAULT;
    const SuiteSparse_long rank = SuiteSparseQR<double>(ordering, tolerance, SuiteSparse_long{0},
                                                        &view.header, &upper, &permutation, workspace.get());
    const auto release_upper = [&](cholmod_sparse* m) { cholmod_l_free_sparse(&m, workspace.get()); };
    const auto release_permutation = [&](SuiteSparse_long* p) {
        cholmod_l_free(view.header.ncol, sizeof(SuiteSparse_long), p, workspace.get());
    };
    const std::unique_ptr<cholmod_sparse, decltype(release_upper)> hold_upper(upper, release_upper);
    const std::unique_ptr<SuiteSparse_long, decltype(release_permutation)> hold_permutation(
        permutation, release_permutation);
    if (rank < 0 || upper == nullptr) throw ModelError("SuiteSparseQR failed: out of memory");
    return copied(*upper, permutation);
}

}  // namespace camopt::internal
