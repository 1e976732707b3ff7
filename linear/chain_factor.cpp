// SPDX-License-Identifier: MIT
#include "linear/chain_factor.hpp"

#include "linear/kernels.hpp"

#include <cstdint>

namespace camopt {
namespace {

using Matrix = SymmetricFactor::Matrix;
using Eigen::Index;
using Eigen::VectorXd;

// The smallest widths with unrolled loops that are at least the actual ones are used: missing entries are
// zeros.
constexpr std::array<int, 5> unrolled_bands = {4, 6, 8, 10, 12};
constexpr int unrolled_border = 4;

FactorOutcome outcome_of(ChainOutcome outcome) {
    switch (outcome) {
        case ChainOutcome::ok:
            return FactorOutcome::ok;
        case ChainOutcome::zero_pivot:
            return FactorOutcome::zero_pivot;
        case ChainOutcome::wrong_sign:
            return FactorOutcome::wrong_sign;
        case ChainOutcome::not_finite:
            return FactorOutcome::not_finite;
    }
    throw ModelError("ChainFactor: unknown outcome");
}

/// Column j of the chain: [ K_jj … K_{j+b,j} | border rows ], overwritten by [ pivot, L … | L of the border
/// ].
class ChainFactor final : public SymmetricFactor {
 public:
    explicit ChainFactor(ChainOrder order) : order_(std::move(order)) {}

    void analyse(const Matrix& lower, std::vector<int> signs) override {
        const int count = matrix_.count = static_cast<int>(order_.sequence.size());
        matrix_.border_rows = static_cast<int>(order_.border.size());
        if (lower.rows() != count + matrix_.border_rows || lower.rows() != static_cast<Index>(signs.size()))
            throw ModelError("ChainFactor: not the matrix it was ordered for");
        choose_widths();
        // Columns past the end receive the updates outside the band, which are zeros.
        corner_ = static_cast<std::size_t>(stride()) * static_cast<std::size_t>(count + matrix_.band + 1);
        values_.assign(corner_ + static_cast<std::size_t>(matrix_.border * matrix_.border), 0.0);
        if (values_.size() > std::numeric_limits<std::uint32_t>::max())
            throw ModelError("ChainFactor: more entries than it can count");
        destination_.clear();
        destination_.reserve(static_cast<std::size_t>(lower.nonZeros()));
        for (int j = 0; j < lower.outerSize(); ++j)
            for (Matrix::InnerIterator entry(lower, j); entry; ++entry) {
                const int a = order_.position[entry.row()];
                const int b = order_.position[j];
                destination_.push_back(place_of(std::max(a, b), std::min(a, b)));
            }
        find_diagonal(signs);
        inverse_.resize(3 * static_cast<std::size_t>(count));
        place_ = order_.position;
        for (int& place : place_) place += place < count ? 1 : 1 + matrix_.band;
        ordered_.assign(
            1 + static_cast<std::size_t>(count) + static_cast<std::size_t>(matrix_.band + matrix_.border),
            0.0);
        matrix_.columns = values_.data();
        matrix_.corner = values_.data() + corner_;
        matrix_.opens_pair = order_.opens_pair.data();
        matrix_.signs = signs_.data();
        matrix_.diagonal = diagonal_.data();
        matrix_.inverse = inverse_.data();
    }
    FactorOutcome factorize(const Matrix& lower, const VectorXd& shift) override {
        if (lower.nonZeros() != static_cast<Index>(destination_.size()) || shift.size() != lower.rows())
            throw ModelError("SymmetricFactor: not the analysed pattern");
        load(lower, shift);
        return outcome_of(loops_.eliminate(matrix_));
    }
    void solve_in_place(VectorXd& right_side) const override {
        double* const x = ordered_.data() + 1;
        double* const bottom = x + matrix_.count + matrix_.band;
        double* const end = ordered_.data() + ordered_.size();
        std::fill(x + matrix_.count, end, 0.0);
        for (std::size_t i = 0; i < place_.size(); ++i)
            ordered_[place_[i]] = right_side[static_cast<Index>(i)];
        loops_.forward(matrix_, x, bottom);
        for (int k = 0; k < matrix_.border_rows; ++k)
            for (int i = k + 1; i < matrix_.border_rows; ++i) bottom[i] -= border(i, k) * bottom[k];
        for (int k = matrix_.border_rows - 1; k >= 0; --k) {
            bottom[k] /= border(k, k);
            for (int i = k + 1; i < matrix_.border_rows; ++i) bottom[k] -= border(i, k) * bottom[i];
        }
        std::fill(x + matrix_.count, bottom, 0.0);
        loops_.backward(matrix_, x, bottom);
        for (std::size_t i = 0; i < place_.size(); ++i)
            right_side[static_cast<Index>(i)] = ordered_[place_[i]];
    }
    [[nodiscard]] std::string_view name() const override { return "chain"; }

 private:
    [[nodiscard]] double border(int i, int j) const {
        return values_[corner_ + static_cast<std::size_t>(i * matrix_.border + j)];
    }
    /// Of the entry in these rows, by the order of elimination; low >= high.
    [[nodiscard]] std::uint32_t place_of(int low, int high) const {
        if (high >= matrix_.count)
            return static_cast<std::uint32_t>(corner_) +
                   static_cast<std::uint32_t>((low - matrix_.count) * matrix_.border + high - matrix_.count);
        const int below = low < matrix_.count ? low - high : matrix_.band + 1 + low - matrix_.count;
        return static_cast<std::uint32_t>(high) * static_cast<std::uint32_t>(stride()) +
               static_cast<std::uint32_t>(below);
    }
    [[nodiscard]] int stride() const { return 1 + matrix_.band + matrix_.border; }
    void choose_widths() {
        // A pair needs one row more than its first column has.
        matrix_.band = order_.half_bandwidth + 1;
        matrix_.border = matrix_.border_rows;
        const std::span bands(unrolled_bands);
        const auto wide = std::ranges::lower_bound(bands, matrix_.band);
        if (wide != bands.end() && matrix_.border_rows <= unrolled_border) {
            matrix_.band = *wide;
            if (matrix_.border_rows > 0) matrix_.border = unrolled_border;
        }
        loops_ = linear_kernels().chain(matrix_.band, matrix_.border);
    }
    void find_diagonal(const std::vector<int>& signs) {
        signs_.resize(signs.size());
        diagonal_places_.resize(signs.size());
        for (std::size_t row = 0; row < signs.size(); ++row) {
            const int at = order_.position[row];
            const bool paired = at < matrix_.count &&
                                (order_.opens_pair[at] != 0 || (at > 0 && order_.opens_pair[at - 1] != 0));
            signs_[at] = signs[row];
            diagonal_places_[at] = {place_of(at, at), static_cast<int>(row), paired ? 0.0 : signs_[at]};
        }
        diagonal_.resize(signs.size());
    }
    void load(const Matrix& lower, const VectorXd& shift) {
        std::fill(values_.begin(), values_.end(), 0.0);
        const double* source = lower.valuePtr();
        for (std::size_t k = 0; k < destination_.size(); ++k) values_[destination_[k]] = source[k];
        for (std::size_t k = 0; k < diagonal_places_.size(); ++k) {
            const Diagonal& diagonal = diagonal_places_[k];
            double& entry = values_[diagonal.place];
            diagonal_[k] = std::abs(entry);
            entry += diagonal.shift_sign * shift[diagonal.row];
        }
    }

    ChainOrder order_;
    ChainMatrix matrix_;  ///< of the arrays below
    ChainLoops loops_{};
    std::vector<double> signs_;               ///< in the order of elimination
    std::vector<std::uint32_t> destination_;  ///< of every stored entry, in values_
    std::vector<double> values_;              ///< column after column, then the border's own square
    std::size_t corner_ = 0;                  ///< where that begins
    struct Diagonal {
        std::uint32_t place;  ///< in values_
        int row;              ///< of the matrix
        double shift_sign;    ///< 0 for pairs: their determinant is nonzero without a shift
    };
    std::vector<Diagonal> diagonal_places_;  ///< in the order of elimination
    std::vector<double> diagonal_;           ///< of the matrix, in the order of elimination
    std::vector<double> inverse_;            ///< see ChainMatrix
    std::vector<int> place_;                 ///< of every row in ordered_
    mutable std::vector<double> ordered_;    ///< a zero, the chain, zeros as wide as the band, the border
};

}  // namespace

std::unique_ptr<SymmetricFactor> make_chain_factor(const Matrix& lower, const std::vector<int>& signs) {
    std::optional<ChainOrder> order = chain_order(lower, signs);
    if (!order) return nullptr;
    auto factor = std::make_unique<ChainFactor>(std::move(*order));
    factor->analyse(lower, signs);
    return factor;
}

}  // namespace camopt
