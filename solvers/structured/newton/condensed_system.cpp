// SPDX-License-Identifier: MIT
#include "solvers/structured/linearized_problem.hpp"
#include "solvers/structured/newton/newton_step.hpp"

namespace camopt::structured {

namespace {

// Private to condensed_system.cpp: the positions of the entries of the condensed matrix and their terms.

/// The lower triangle, with the equalities' entries in place and zeros elsewhere.
/// Entry terms[k].slot is Σ product · weight[source] over its terms, with weight = [K_l + K_u;
/// (K_l − K_u) d], plus what `hessian_slot` and `width_slot` add.
struct CondensedPattern {
    using Matrix = Eigen::SparseMatrix<double>;
    struct Term {
        int slot, source;
        double product;
    };
    CondensedPattern(const ConvexModel& model, const RangeRows& ranges, const Matrix& by_column);

    SymmetricFactor::Matrix lower;
    std::vector<Term> terms;
    std::vector<int> hessian_slot;  ///< of every entry of ∇²f
    std::vector<int> width_slot;    ///< the diagonal entry of every group's variable
};

using RowMajor = RangeRows::RowMajor;

/// Processes the matrix column by column.
class PatternBuilder {
 public:
    PatternBuilder(const ConvexModel& model, const RangeRows& ranges,
                   const CondensedPattern::Matrix& by_column)
        : model_(model),
          ranges_(ranges),
          by_column_(by_column),
          variables_(static_cast<int>(model.variables())),
          size_(variables_ + static_cast<int>(ranges.equalities.size())),
          owner_(static_cast<std::size_t>(size_), -1),
          slot_(owner_),
          group_of_(static_cast<std::size_t>(ranges.ranges()), -1),
          curved_(static_cast<std::size_t>(variables_)),
          groups_at_(static_cast<std::size_t>(variables_)) {
        for (std::size_t g = 0; g < ranges.groups.size(); ++g) {
            const RangeRows::Group& group = ranges.groups[g];
            std::fill(group_of_.begin() + group.first, group_of_.begin() + group.last, static_cast<int>(g));
            groups_at_[static_cast<std::size_t>(group.variable)].push_back(static_cast<int>(g));
        }
        for (std::size_t e = 0; e < model.hessian.columns.size(); ++e)
            curved_[static_cast<std::size_t>(model.hessian.columns[e])].push_back(static_cast<int>(e));
    }

    void run(CondensedPattern& out) {
        out.hessian_slot.resize(model_.hessian.rows.size());
        out.width_slot.resize(ranges_.groups.size());
        const auto entries = static_cast<std::size_t>(ranges_.matrix.nonZeros());
        out.terms.reserve(4 * entries);
        inner_.reserve(2 * entries);
        outer_.reserve(static_cast<std::size_t>(size_) + 1);
        for (int j = 0; j < size_; ++j) column(j, out);
        out.lower =
            Eigen::Map<const SymmetricFactor::Matrix>(size_, size_, static_cast<Eigen::Index>(inner_.size()),
                                                      outer_.data(), inner_.data(), values_.data());
    }

 private:
    void column(int j, CondensedPattern& out) {
        entries_.clear();
        claim(j, j);
        if (j < variables_) {
            each_entry(
                j, [&](int row, double) { claim(row, j); }, [&](int row, int, double) { claim(row, j); });
            for (const int e : curved_[static_cast<std::size_t>(j)])
                claim(model_.hessian.rows[static_cast<std::size_t>(e)], j);
        }
        std::ranges::sort(entries_);
        for (const int row : entries_) {
            slot_[static_cast<std::size_t>(row)] = static_cast<int>(inner_.size());
            inner_.push_back(row);
        }
        outer_.push_back(static_cast<int>(inner_.size()));
        values_.resize(inner_.size(), 0.0);
        if (j >= variables_) return;
        const auto at = [&](int row) { return slot_[static_cast<std::size_t>(row)]; };
        each_entry(
            j, [&](int row, double value) { values_[static_cast<std::size_t>(at(row))] = value; },
            [&](int row, int source, double product) {
                out.terms.push_back({at(row), source, product});
            });
        for (const int e : curved_[static_cast<std::size_t>(j)])
            out.hessian_slot[static_cast<std::size_t>(e)] =
                at(model_.hessian.rows[static_cast<std::size_t>(e)]);
        for (const int g : groups_at_[static_cast<std::size_t>(j)])
            out.width_slot[static_cast<std::size_t>(g)] = at(j);
    }

    void claim(int row, int column) {
        if (owner_[static_cast<std::size_t>(row)] == column) return;
        owner_[static_cast<std::size_t>(row)] = column;
        entries_.push_back(row);
    }

    /// Entries of column j on and below the diagonal: of_equality(row, value), of_term(row, source,
    /// product).
    template <typename OfEquality, typename OfTerm>
    void each_entry(int j, OfEquality&& of_equality, OfTerm&& of_term) const {
        const auto count = static_cast<int>(ranges_.ranges());
        for (Eigen::SparseMatrix<double>::InnerIterator own(by_column_, j); own; ++own) {
            const auto row = static_cast<int>(own.row());
            if (row >= count) {
                of_equality(variables_ + row - count, own.value());
                continue;
            }
            for (RowMajor::InnerIterator other(ranges_.matrix, row); other; ++other)
                if (other.col() >= j)
                    of_term(static_cast<int>(other.col()), row, own.value() * other.value());
            const int group = group_of_[static_cast<std::size_t>(row)];
            if (group < 0) continue;
            const int width = ranges_.groups[static_cast<std::size_t>(group)].variable;
            if (width > j) of_term(width, count + row, own.value());
        }
        for (const int g : groups_at_[static_cast<std::size_t>(j)]) {
            const RangeRows::Group& group = ranges_.groups[static_cast<std::size_t>(g)];
            for (auto row = static_cast<int>(group.first); row < static_cast<int>(group.last); ++row)
                for (RowMajor::InnerIterator other(ranges_.matrix, row); other; ++other)
                    if (other.col() > j) of_term(static_cast<int>(other.col()), count + row, other.value());
        }
    }

    const ConvexModel& model_;
    const RangeRows& ranges_;
    const CondensedPattern::Matrix& by_column_;  ///< ranges_.matrix
    int variables_, size_;
    std::vector<int> owner_, slot_, group_of_;
    std::vector<std::vector<int>> curved_, groups_at_;
    std::vector<int> entries_, inner_, outer_ = {0};
    std::vector<double> values_;
};

CondensedPattern::CondensedPattern(const ConvexModel& model, const RangeRows& ranges,
                                   const Matrix& by_column) {
    PatternBuilder(model, ranges, by_column).run(*this);
}

using Eigen::Index;
using Eigen::VectorXd;
using RowMajor = RangeRows::RowMajor;

constexpr double largest_shift = 1e-4;  // of entries near 1: a larger shift makes the factor useless
constexpr double shift_growth = 1e3;  // a breakdown is rare; few retries matter more than the smallest shift
constexpr int most_refinements = 6;
constexpr double worthwhile = 0.3;  // a refinement that gains less is the last
// A factor whose first solve leaves this part of the allowed residual needs no residual of the next ones.
constexpr double trustworthy = 0.05;

/// The terms as a matrix that makes the entries of `lower` out of the weights.
CompressedRows assembly_of(const CondensedPattern& pattern) {
    std::vector<int> count(static_cast<std::size_t>(pattern.lower.nonZeros()), 0);
    for (const CondensedPattern::Term& term : pattern.terms) ++count[static_cast<std::size_t>(term.slot)];
    std::vector<int> names, next(count.size(), 0);
    CompressedRows::Entries entries{{0}, std::vector<int>(pattern.terms.size()), {}};
    for (std::size_t slot = 0; slot < count.size(); ++slot) {
        if (count[slot] == 0) continue;
        names.push_back(static_cast<int>(slot));
        next[slot] = entries.begin.back();
        entries.begin.push_back(entries.begin.back() + count[slot]);
    }
    entries.values.resize(pattern.terms.size());
    for (const CondensedPattern::Term& term : pattern.terms) {
        const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(term.slot)]++);
        entries.columns[place] = term.source;
        entries.values[place] = term.product;
    }
    return {entries, names};
}

}  // namespace

CondensedSystem::CondensedSystem(const ConvexModel& model, const RangeRows& ranges, FactorKind kind,
                                 double shift)
    : model_(model), ranges_(ranges), first_shift_(shift), shift_(shift), rows_(ranges.matrix) {
    const Eigen::SparseMatrix<double> by_column = ranges.matrix;
    columns_ = CompressedRows(Eigen::Map<const RowMajor>(by_column.cols(), by_column.rows(),
                                                         by_column.nonZeros(), by_column.outerIndexPtr(),
                                                         by_column.innerIndexPtr(), by_column.valuePtr()));
    CondensedPattern pattern(model, ranges, by_column);
    assembly_ = assembly_of(pattern);
    lower_.swap(pattern.lower);
    hessian_slot_ = std::move(pattern.hessian_slot);
    width_slot_ = std::move(pattern.width_slot);
    std::vector<int> signs(static_cast<std::size_t>(lower_.rows()), 1);
    std::fill(signs.begin() + model.variables(), signs.end(), -1);
    factor_ = make_symmetric_factor(kind, lower_, signs);
    divide_into_segments();
    const Index unknowns = lower_.rows(), rows = ranges.matrix.rows();
    weight_.resize(ranges.sides());
    joined_.setZero(rows);
    sums_.setZero(static_cast<Index>(segments_.size()));
    rest_.resize(unknowns);
    step_ = {VectorXd(unknowns), VectorXd(rows), VectorXd(ranges.sides())};
    shifts_.resize(unknowns);
}

/// Ranges in no group come first.
void CondensedSystem::divide_into_segments() {
    int done = 0;
    const auto add = [&](int variable, Index last) {
        if (last > done) segments_.push_back({variable, done, static_cast<int>(last)});
        done = static_cast<int>(last);
    };
    for (const RangeRows::Group& group : ranges_.groups) {
        add(-1, group.first);
        add(group.variable, group.last);
    }
    add(-1, ranges_.ranges());
    layout_ = {segments_.data(),
               static_cast<int>(segments_.size()),
               static_cast<int>(ranges_.ranges()),
               ranges_.width.data(),
               ranges_.limit.data(),
               ranges_.present.data()};
}

bool CondensedSystem::factorize(const std::vector<double>& hessian, SidePoint pass) {
    hessian_ = &hessian;
    curvature_ = pass.curvature;
    trusted_ = false;
    pass.weight = weight_.data();
    pass.squares = sums_.data();
    passes_.point(layout_, pass);
    double* values = lower_.valuePtr();
    for (const int slot : hessian_slot_) values[slot] = 0.0;
    for (const int slot : width_slot_) values[slot] = 0.0;
    assembly_.multiply(weight_.data(), values);
    for (std::size_t e = 0; e < hessian.size(); ++e) values[hessian_slot_[e]] += hessian[e];
    std::size_t group = 0;
    for (std::size_t s = 0; s < segments_.size(); ++s)
        if (segments_[s].variable >= 0) values[width_slot_[group++]] += sums_[static_cast<Index>(s)];
    for (shift_ = first_shift_; shift_ <= largest_shift; shift_ *= shift_growth) {
        shifts_.setConstant(shift_);
        const FactorOutcome outcome = factor_->factorize(lower_, shifts_);
        // A wrong sign is round-off, since the matrix is quasi-definite: the residual of the solve decides.
        if (outcome == FactorOutcome::ok || outcome == FactorOutcome::wrong_sign) return true;
    }
    return false;
}

void CondensedSystem::add_transposed(double factor, const double* lambda, const double* base, double* out) {
    std::copy_n(lambda, ranges_.equal_to.size(), joined_.data() + ranges_.ranges());
    columns_.add_product(factor, joined_.data(), base, out);
    for (std::size_t s = 0; s < segments_.size(); ++s)
        if (segments_[s].variable >= 0) out[segments_[s].variable] += factor * sums_[static_cast<Index>(s)];
}

/// The unknowns of one solve with the factor, for the right-hand side rest_.
void CondensedSystem::apply_factor(NewtonUnknowns& out) {
    out.all = rest_;
    factor_->solve_in_place(out.all);
    rows_.multiply(out.all.data(), out.image.data());
}

/// rest_ = the residual of the equations in p and q; its largest entry. products() are those of at.nu.
double CondensedSystem::residual(const NewtonRightSide& right_side, const NewtonUnknowns& at) {
    const Index n = model_.variables(), equalities = ranges_.equal_to.size();
    add_transposed(-1.0, at.all.data() + n, right_side.all.data(), rest_.data());
    const SparsityPattern& pattern = model_.hessian;
    for (std::size_t e = 0; e < hessian_->size(); ++e) {
        const int row = pattern.rows[e], column = pattern.columns[e];
        rest_[row] -= (*hessian_)[e] * at.all[column];
        if (row != column) rest_[column] -= (*hessian_)[e] * at.all[row];
    }
    rest_.tail(equalities) = right_side.all.tail(equalities) - at.image.tail(equalities);
    return finite(rest_) ? largest(rest_) : infinity;
}

CondensedSystem::Accuracy CondensedSystem::solve(const NewtonRightSide& right_side, double goal,
                                                 NewtonUnknowns& out) {
    // With f = 0 the forces are in the right-hand side: p + Cᵀ(f_l − f_u) + Wᵀ(f_l + f_u).
    const Index equalities = ranges_.equal_to.size();
    rest_.tail(equalities).setZero();
    add_transposed(1.0, rest_.data() + model_.variables(), right_side.all.data(), rest_.data());
    rest_.tail(equalities) = right_side.all.tail(equalities);
    apply_factor(out);
    const auto multipliers = [&](const NewtonUnknowns& from, const VectorXd& base, double sign,
                                 VectorXd& nu) {
        passes_.multipliers(layout_, {from.all.data(), from.image.data(), curvature_, base.data(), sign,
                                      nu.data(), products()});
    };
    multipliers(out, right_side.force, -1.0, out.nu);
    if (trusted_) return {};
    double rest = residual(right_side, out);
    trusted_ = rest <= trustworthy * goal;
    for (int k = 0; k < most_refinements && rest > goal && std::isfinite(rest); ++k) {
        apply_factor(step_);
        multipliers(step_, out.nu, 1.0, step_.nu);
        step_.all += out.all;
        step_.image += out.image;
        const double now = residual(right_side, step_);
        if (!(now < rest)) break;
        std::swap(out, step_);
        const bool last = now > worthwhile * rest;
        rest = now;
        if (last) break;
    }
    return {rest, rest <= goal};
}

}  // namespace camopt::structured
