// SPDX-License-Identifier: MIT
#include "linear/chain_factor.hpp"

#include "core/errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace camopt {
namespace {

using Matrix = SymmetricFactor::Matrix;
using Eigen::Index;
using Eigen::VectorXd;

// A pivot smaller than this part of its diagonal entry is round-off.
constexpr double rounding = 1e-14;

/// Column j of the chain: [ K_jj … K_{j+b,j} | border rows ], overwritten by [ pivot, L … | L of the border
/// ].
class ChainFactor final : public SymmetricFactor {
 public:
    explicit ChainFactor(ChainOrder order) : order_(std::move(order)) {}

    void analyse(const Matrix& lower, std::vector<int> signs) override;
    FactorOutcome factorize(const Matrix& lower, const VectorXd& shift) override;
    void solve_in_place(VectorXd& right_side) const override;
    [[nodiscard]] std::string_view name() const override { return "chain"; }

 private:
    [[nodiscard]] double* column(int j) { return values_.data() + static_cast<std::ptrdiff_t>(j) * stride_; }
    [[nodiscard]] const double* column(int j) const {
        return values_.data() + static_cast<std::ptrdiff_t>(j) * stride_;
    }
    [[nodiscard]] double* corner() { return values_.data() + corner_; }
    [[nodiscard]] double& border(int i, int j) {
        return values_[corner_ + static_cast<std::size_t>(i * widths_.border + j)];
    }
    [[nodiscard]] double border(int i, int j) const {
        return values_[corner_ + static_cast<std::size_t>(i * widths_.border + j)];
    }
    [[nodiscard]] std::uint32_t place_of(int low, int high) const;
    void load(const Matrix& lower, const VectorXd& shift);
    bool right_pivot(double& pivot, double original, int sign);
    void eliminate_single(int j);
    void eliminate_pair(int j);
    void eliminate_border();
    void divide_by_pivots(double* x) const;

    ChainOrder order_;
    int chain_rows_ = 0, border_rows_ = 0, band_ = 0, stride_ = 0;
    std::vector<int> signs_;                  ///< in the order of elimination
    std::vector<std::uint32_t> destination_;  ///< of every stored entry, in values_
    std::vector<double> values_;              ///< column after column, then the border's own square
    std::size_t corner_ = 0;                  ///< where that begins
    struct Diagonal {
        std::uint32_t place;  ///< in values_
        int row;              ///< of the matrix
        double shift_sign;    ///< 0 for pairs: their determinant is nonzero without a shift
    };
    std::vector<Diagonal> diagonal_places_;     ///< in the order of elimination
    std::vector<double> diagonal_;              ///< of the matrix, in the order of elimination
    std::vector<double> scaled_, scaled_next_;  ///< L D of the columns being eliminated
    std::vector<std::pair<double, double>>
        inverse_;             ///< of the pivots: 1/d, or the entries of a 2 x 2 inverse
    std::vector<int> place_;  ///< of every row in ordered_
    mutable VectorXd ordered_;
    ChainWidths widths_;
    ChainKernels kernels_{};
    FactorOutcome outcome_ = FactorOutcome::ok;
};

void ChainFactor::analyse(const Matrix& lower, std::vector<int> signs) {
    chain_rows_ = static_cast<int>(order_.sequence.size());
    border_rows_ = static_cast<int>(order_.border.size());
    if (lower.rows() != chain_rows_ + border_rows_ || lower.rows() != static_cast<Index>(signs.size()))
        throw ModelError("ChainFactor: not the matrix it was ordered for");
    // A pair needs one row more than its first column has.
    widths_ = padded({order_.half_bandwidth + 1, border_rows_});
    kernels_ = chain_kernels(widths_);
    band_ = widths_.band;
    stride_ = widths_.stride();
    // Columns past the end receive the updates outside the band, which are zeros.
    corner_ = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(chain_rows_ + band_ + 1);
    values_.assign(corner_ + static_cast<std::size_t>(widths_.border * widths_.border), 0.0);
    if (values_.size() > std::numeric_limits<std::uint32_t>::max())
        throw ModelError("ChainFactor: more entries than it can count");
    signs_.resize(signs.size());
    for (std::size_t i = 0; i < signs.size(); ++i)
        signs_[static_cast<std::size_t>(order_.position[i])] = signs[i];
    destination_.clear();
    for (int j = 0; j < lower.outerSize(); ++j)
        for (Matrix::InnerIterator entry(lower, j); entry; ++entry) {
            const int a = order_.position[static_cast<std::size_t>(entry.row())];
            const int b = order_.position[j];
            destination_.push_back(place_of(std::max(a, b), std::min(a, b)));
        }
    diagonal_places_.resize(signs.size());
    for (std::size_t row = 0; row < signs.size(); ++row) {
        const int at = order_.position[row];
        const bool paired =
            at < chain_rows_ && (order_.opens_pair[at] != 0 || (at > 0 && order_.opens_pair[at - 1] != 0));
        diagonal_places_[static_cast<std::size_t>(at)] = {place_of(at, at), static_cast<int>(row),
                                                          paired ? 0.0 : static_cast<double>(signs[row])};
    }
    diagonal_.resize(signs.size());
    inverse_.resize(chain_rows_);
    scaled_.assign(stride_, 0.0);
    scaled_next_.assign(stride_, 0.0);
    place_ = order_.position;  // zeros between chain and border receive the updates outside the band
    for (int& place : place_)
        if (place >= chain_rows_) place += band_;
    ordered_.setZero(chain_rows_ + band_ + widths_.border);
}

/// Of the entry in these rows, by the order of elimination; low >= high.
std::uint32_t ChainFactor::place_of(int low, int high) const {
    if (high >= chain_rows_)
        return static_cast<std::uint32_t>(corner_) +
               static_cast<std::uint32_t>((low - chain_rows_) * widths_.border + high - chain_rows_);
    const int below = low < chain_rows_ ? low - high : band_ + 1 + low - chain_rows_;
    return static_cast<std::uint32_t>(high) * static_cast<std::uint32_t>(stride_) +
           static_cast<std::uint32_t>(below);
}

void ChainFactor::load(const Matrix& lower, const VectorXd& shift) {
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

FactorOutcome ChainFactor::factorize(const Matrix& lower, const VectorXd& shift) {
    if (lower.nonZeros() != static_cast<Index>(destination_.size()) || shift.size() != lower.rows())
        throw ModelError("SymmetricFactor: not the analysed pattern");
    outcome_ = FactorOutcome::ok;
    load(lower, shift);
    for (int j = 0; j < chain_rows_; ++j) {
        if (order_.opens_pair[j] != 0)
            eliminate_pair(j++);
        else
            eliminate_single(j);
        if (outcome_ == FactorOutcome::not_finite || outcome_ == FactorOutcome::zero_pivot) return outcome_;
    }
    eliminate_border();
    return outcome_;
}

/// False: not to be used. A pivot of the wrong sign is round-off: it is recorded, and replaced by the
/// smallest value admissible for the diagonal entry.
bool ChainFactor::right_pivot(double& pivot, double original, int sign) {
    if (!std::isfinite(pivot)) {
        outcome_ = FactorOutcome::not_finite;
        return false;
    }
    const double least = rounding * original;
    if (pivot * sign > least) return true;
    if (pivot * sign < 0.0) outcome_ = FactorOutcome::wrong_sign;
    pivot = sign * std::max(least, std::abs(pivot));
    if (pivot != 0.0) return true;
    outcome_ = FactorOutcome::zero_pivot;
    return false;
}

void ChainFactor::eliminate_single(int j) {
    double* own = column(j);
    double pivot = own[0];
    if (!right_pivot(pivot, diagonal_[j], signs_[j])) return;
    const double inverse = 1.0 / pivot;
    inverse_[j] = {inverse, 0.0};
    own[0] = pivot;
    for (int k = 1; k < stride_; ++k) {
        scaled_[k] = own[k];
        own[k] *= inverse;
    }
    kernels_.subtract(own, own, scaled_.data(), corner(), widths_);
}

/// Columns j and j + 1 together: [ p e; e −n ] with inverse [ n e; e −p ] / (p n + e²).
void ChainFactor::eliminate_pair(int j) {
    double* first = column(j);
    double* second = column(j + 1);
    const double p = std::max(0.0, first[0]), n = std::max(0.0, -second[0]), e = first[1];
    const double determinant = p * n + e * e;
    if (!std::isfinite(determinant) || determinant == 0.0) {
        outcome_ = determinant == 0.0 ? FactorOutcome::zero_pivot : FactorOutcome::not_finite;
        return;
    }
    const double a = n / determinant, b = e / determinant, c = -p / determinant;
    inverse_[j] = {a, b};
    inverse_[j + 1] = {b, c};
    first[1] = 0.0;
    const auto divide = [&](double& u, double& v, double& scaled_u, double& scaled_v) {
        scaled_u = u;
        scaled_v = v;
        u = a * scaled_u + b * scaled_v;
        v = b * scaled_u + c * scaled_v;
    };
    // Row j + k is at k in column j and at k − 1 in column j + 1.
    for (int k = 2; k <= band_; ++k) divide(first[k], second[k - 1], scaled_[k], scaled_next_[k - 1]);
    second[band_] = scaled_next_[band_] = 0.0;
    for (int k = band_ + 1; k < stride_; ++k) divide(first[k], second[k], scaled_[k], scaled_next_[k]);
    kernels_.subtract(first, first, scaled_.data(), corner(), widths_);
    kernels_.subtract(second, second, scaled_next_.data(), corner(), widths_);
}

void ChainFactor::eliminate_border() {
    for (int k = 0; k < border_rows_; ++k) {
        double pivot = border(k, k);
        if (!right_pivot(pivot, diagonal_[chain_rows_ + k], signs_[chain_rows_ + k])) return;
        border(k, k) = pivot;
        for (int i = k + 1; i < border_rows_; ++i) {
            const double factor = border(i, k) / pivot;
            for (int t = i; t < border_rows_; ++t) border(t, i) -= factor * border(t, k);
        }
        for (int i = k + 1; i < border_rows_; ++i) border(i, k) /= pivot;
    }
}

void ChainFactor::solve_in_place(VectorXd& right_side) const {
    double* const x = ordered_.data();
    double* const bottom = x + chain_rows_ + band_;
    std::fill(x + chain_rows_, x + ordered_.size(), 0.0);
    for (std::size_t i = 0; i < place_.size(); ++i) x[place_[i]] = right_side[static_cast<Index>(i)];
    kernels_.forward(values_.data(), chain_rows_, x, bottom, widths_);
    divide_by_pivots(x);
    for (int k = 0; k < border_rows_; ++k)
        for (int i = k + 1; i < border_rows_; ++i) bottom[i] -= border(i, k) * bottom[k];
    for (int k = border_rows_ - 1; k >= 0; --k) {
        bottom[k] /= border(k, k);
        for (int i = k + 1; i < border_rows_; ++i) bottom[k] -= border(i, k) * bottom[i];
    }
    std::fill(x + chain_rows_, bottom, 0.0);
    kernels_.backward(values_.data(), chain_rows_, x, bottom, widths_);
    for (std::size_t i = 0; i < place_.size(); ++i) right_side[static_cast<Index>(i)] = x[place_[i]];
}

/// x = D⁻¹ x of the chain.
void ChainFactor::divide_by_pivots(double* x) const {
    for (int j = 0; j < chain_rows_; ++j) {
        if (order_.opens_pair[j] == 0) {
            x[j] *= inverse_[j].first;
            continue;
        }
        const double y = x[j], next = x[j + 1];
        x[j] = inverse_[j].first * y + inverse_[j].second * next;
        x[j + 1] = inverse_[j + 1].first * y + inverse_[j + 1].second * next;
        ++j;
    }
}

}  // namespace

std::unique_ptr<SymmetricFactor> make_chain_factor(const Matrix& lower, const std::vector<int>& signs) {
    std::optional<ChainOrder> order = chain_order(lower, signs);
    if (!order) return nullptr;
    auto factor = std::make_unique<ChainFactor>(std::move(*order));
    factor->analyse(lower, signs);
    return factor;
}

}  // namespace camopt
