// SPDX-License-Identifier: MIT
#include "splines/design_forms.hpp"

#include "core/errors.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <fmt/format.h>

namespace camopt {

namespace {

constexpr std::array<const char*, 4> prime = {"y", "y'", "y''", "y'''"};

std::vector<int> consecutive(int first, int count) {
    std::vector<int> numbers(count);
    for (int k = 0; k < count; ++k) numbers[k] = first + k;
    return numbers;
}

/// Rows of the `orders` x … matrix: y, y', … of a polynomial with p + 1 terms at t.
Eigen::MatrixXd state_of_monomials(int degree, double t, int orders) {
    Eigen::MatrixXd state = Eigen::MatrixXd::Zero(orders, degree + 1);
    for (int order = 0; order < orders; ++order) {
        for (int m = order; m <= degree; ++m) {
            double factor = 1.0;
            for (int r = 0; r < order; ++r) factor *= m - r;
            state(order, m) = factor * std::pow(t, m - order);
        }
    }
    return state;
}

// ---- states
// ---------------------------------------------------------------------------------------------------

/// Cubic from (y, y', y'') at the left and y'' at the right: y''' = (y''_{i+1} − y''_i) / h.
LocalMap cubic_state_map(int segment, double h) {
    LocalMap map{{3 * segment, 3 * segment + 1, 3 * segment + 2, 3 * segment + 5},
                 Eigen::MatrixXd::Zero(4, 4),
                 Eigen::VectorXd::Zero(4)};
    map.matrix(0, 0) = 1.0;
    map.matrix(1, 1) = 1.0;
    map.matrix(2, 2) = 0.5;
    map.matrix(3, 2) = -1.0 / (6.0 * h);
    map.matrix(3, 3) = 1.0 / (6.0 * h);
    return map;
}

/// Quintic Hermite: (y, y', y'') at both ends.
LocalMap quintic_state_map(int segment, double h) {
    LocalMap map{consecutive(3 * segment, 6), Eigen::MatrixXd::Zero(6, 6), Eigen::VectorXd::Zero(6)};
    map.matrix(0, 0) = 1.0;
    map.matrix(1, 1) = 1.0;
    map.matrix(2, 2) = 0.5;
    const double h2 = h * h;
    const double h3 = h2 * h;
    map.matrix.row(3) << -10.0 / h3, -6.0 / h2, -1.5 / h, 10.0 / h3, -4.0 / h2, 0.5 / h;
    map.matrix.row(4) << 15.0 / (h3 * h), 8.0 / h3, 1.5 / h2, -15.0 / (h3 * h), 7.0 / h3, -1.0 / h2;
    map.matrix.row(5) << -6.0 / (h3 * h2), -3.0 / (h3 * h), -0.5 / h3, 6.0 / (h3 * h2), -3.0 / (h3 * h),
        0.5 / h3;
    return map;
}

/// Septic Hermite: (y, y', y'', y''') at both ends. Column c holds the derivative c mod 4 of one of them.
LocalMap septic_state_map(int segment, double h) {
    constexpr double a = 1.0 / 6.0, b = 2.0 / 3.0;
    constexpr std::array<std::array<double, 8>, 4> upper = {{{-35, -20, -5, -b, 35, -15, 2.5, -a},
                                                             {84, 45, 10, 1, -84, 39, -7, 0.5},
                                                             {-70, -36, -7.5, -b, 70, -34, 6.5, -0.5},
                                                             {20, 10, 2, a, -20, 10, -2, a}}};
    LocalMap map{consecutive(4 * segment, 8), Eigen::MatrixXd::Zero(8, 8), Eigen::VectorXd::Zero(8)};
    map.matrix.diagonal().head<4>() << 1.0, 1.0, 0.5, a;
    for (int k = 0; k < 4; ++k)
        for (int c = 0; c < 8; ++c) map.matrix(4 + k, c) = upper[k][c] / std::pow(h, 4 + k - c % 4);
    return map;
}

/// Derivatives of a state at a breakpoint: y, y', y'', of degree 7 y''' too.
int orders_of_state(const SplineSpace& space) {
    return space.degree() == 7 ? 4 : 3;
}

/// Whether symmetry leaves the continuity of the derivative of `order` to be imposed at the mirror image of
/// `doubled_place` (2 · breakpoint; odd for the middle of a segment): left of the middle always, right of it
/// never, and in the middle only where mirroring changes the derivative's sign.
bool needs_continuity(const DesignRequest& request, int order, int doubled_place) {
    if (request.symmetry == Symmetry::none) return true;
    const int middle = request.space.segments();
    if (doubled_place != middle) return doubled_place < middle;
    return (request.symmetry == Symmetry::odd) == (order % 2 == 0);
}

void add_continuity_rows(DesignForm& form, const DesignRequest& request) {
    const SplineSpace& space = request.space;
    for (int i = 0; i < space.segments(); ++i) {
        const double h = space.width(i);
        const std::string place = fmt::format(" at x = {:.6g}", space.breakpoints()[i + 1]);
        const auto add = [&](AffineRow row, int order) {
            form.rows.push_back(
                {std::move(row), "continuity of derivative " + std::to_string(order) + place});
        };
        if (space.degree() == 3) {
            // y and y' at the right end are the next state's; y'' is by construction. The row belongs to the
            // segment.
            for (int order = 0; order < 2; ++order) {
                if (!needs_continuity(request, order, 2 * i + 1)) continue;
                const AffineRow next{0.0, {3 * (i + 1) + order}, {1.0}};
                add(combined(functional_of(form.maps[i], h, order), -1.0, next), order);
            }
        } else if (i + 1 < space.segments()) {
            for (int order = orders_of_state(space); order <= space.continuity(); ++order) {
                if (!needs_continuity(request, order, 2 * (i + 1))) continue;
                add(combined(functional_of(form.maps[i], h, order), -1.0,
                             functional_of(form.maps[i + 1], 0.0, order)),
                    order);
            }
        }
    }
}

DesignForm states_form(const DesignRequest& request) {
    const SplineSpace& space = request.space;
    const int p = space.degree(), orders = orders_of_state(space);
    if ((p != 3 && p != 5 && p != 7) || space.continuity() < orders - 1)
        throw InputError(
            fmt::format("design \"states\": found degree {} with continuity {}; allowed: degree 3 or "
                        "5 with continuity 2 or more, degree 7 with 3 or more",
                        p, space.continuity()));
    DesignForm form;
    const int last = space.segments();
    for (int i = 0; i <= last; ++i) {
        for (int order = 0; order < orders; ++order) {
            const bool end = (i == 0 || i == last) && order < 3;
            const auto& state = i == 0 ? request.begin_state : request.end_state;
            form.entries.push_back(
                {fmt::format("{}[{}]", prime[order], i), order, i, end, end ? state[order] : 0.0});
        }
    }
    for (int i = 0; i < last; ++i) {
        const double h = space.width(i);
        form.maps.push_back(p == 3   ? cubic_state_map(i, h)
                            : p == 5 ? quintic_state_map(i, h)
                                     : septic_state_map(i, h));
    }
    add_continuity_rows(form, request);
    return form;
}

// ---- coefficients
// ---------------------------------------------------------------------------------------------

void fix(DesignForm& form, int first, const Eigen::Vector3d& values) {
    for (int k = 0; k < 3; ++k) {
        form.entries[first + k].fixed = true;
        form.entries[first + k].value = values[k];
    }
}

void add_end_conditions(DesignForm& form, const DesignRequest& request, bool at_begin, int from_order) {
    const double at = at_begin ? request.space.begin() : request.space.end();
    const auto& state = at_begin ? request.begin_state : request.end_state;
    for (int order = from_order; order < 3; ++order) {
        form.leftover.push_back({at, order, at_begin ? Side::right : Side::left, state[order],
                                 fmt::format("{}({:.6g}) = {:.6g}", prime[order], at, state[order]), false});
    }
}

DesignForm coefficients_form(const DesignRequest& request) {
    const SplineSpace& space = request.space;
    const int p = space.degree();
    DesignForm form;
    for (int j = 0; j < space.dimension(); ++j) form.entries.push_back({fmt::format("c[{}]", j), 0, j});
    for (int i = 0; i < space.segments(); ++i) {
        form.maps.push_back({consecutive(space.first_basis_function(i), p + 1), monomials_of_basis(space, i),
                             Eigen::VectorXd::Zero(p + 1)});
    }
    const auto state = [](const std::array<double, 3>& values) {
        return Eigen::Vector3d(values[0], values[1], values[2]);
    };
    // Three control points at each end belong to its state alone, if there are six.
    const Eigen::MatrixXd first = state_of_monomials(p, 0.0, 3) * form.maps.front().matrix;
    fix(form, 0, first.leftCols<3>().partialPivLu().solve(state(request.begin_state)));
    if (space.dimension() >= 6) {
        const double h = space.width(space.segments() - 1);
        const Eigen::MatrixXd last = state_of_monomials(p, h, 3) * form.maps.back().matrix;
        fix(form, space.dimension() - 3, last.rightCols<3>().partialPivLu().solve(state(request.end_state)));
    } else {
        add_end_conditions(form, request, false, 0);
    }
    return form;
}

// ---- ordinates
// ------------------------------------------------------------------------------------------------

/// c = offset + M x for the interpolating spline: ordinates at the breakpoints, y' … of order (degree − 1) /
/// 2 at the ends.
struct Interpolation {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd offset;
};

/// Its x: the ordinates, around them y''' at both ends of degree 7, which the end states do not give.
Interpolation interpolation_of(const DesignRequest& request, int entries_of_form) {
    const SplineSpace& space = request.space;
    const int p = space.degree();
    const int n = space.segments();
    const int end_orders = (p - 1) / 2;
    const int size = space.dimension();
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right =
        Eigen::MatrixXd::Zero(size, entries_of_form + 1);  // columns: entries, then the known part
    int row = 0, entry = 0;
    const auto add_row = [&](int segment, double t, int order) {
        const Eigen::RowVectorXd values =
            state_of_monomials(p, t, end_orders + 1).row(order) * monomials_of_basis(space, segment);
        for (int k = 0; k <= p; ++k)
            entries.emplace_back(row, space.first_basis_function(segment) + k, values[k]);
        return row++;
    };
    const auto add_end = [&](int segment, double t, const std::array<double, 3>& state) {
        for (int order = 0; order <= end_orders; ++order) {
            const int own = add_row(segment, t, order);
            if (order < 3)
                right(own, entries_of_form) = state[order];
            else
                right(own, entry++) = 1.0;
        }
    };
    add_end(0, 0.0, request.begin_state);
    for (int i = 1; i < n; ++i) right(add_row(i, 0.0, 0), entry++) = 1.0;
    add_end(n - 1, space.width(n - 1), request.end_state);
    Eigen::SparseMatrix<double> collocation(size, size);
    collocation.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(collocation);
    const Eigen::MatrixXd solution = factor.solve(right);
    return {solution.leftCols(entries_of_form), solution.col(entries_of_form)};
}

DesignForm ordinates_form(const DesignRequest& request) {
    const SplineSpace& space = request.space;
    const int p = space.degree();
    if ((p != 3 && p != 5 && p != 7) || space.continuity() != p - 1)
        throw InputError(
            fmt::format("design \"ordinates\": found degree {} with continuity {}; allowed: degree 3, 5 or "
                        "7 with continuity degree − 1 (the ordinates alone do not fix a rougher spline)",
                        p, space.continuity()));
    DesignForm form;
    form.dense = true;
    const int n = space.segments();
    if (p == 7) form.entries.push_back({"y'''[0]", 3, 0});
    for (int i = 1; i < n; ++i) form.entries.push_back({fmt::format("y[{}]", i), 0, i});
    if (p == 7) form.entries.push_back({fmt::format("y'''[{}]", n), 3, n});
    const auto size = static_cast<int>(form.entries.size());
    const Interpolation interpolation = interpolation_of(request, size);
    const std::vector<int> all = consecutive(0, size);
    for (int i = 0; i < n; ++i) {
        const Eigen::MatrixXd basis = monomials_of_basis(space, i);
        const int first = space.first_basis_function(i);
        form.maps.push_back({all, basis * interpolation.matrix.middleRows(first, p + 1),
                             basis * interpolation.offset.segment(first, p + 1)});
    }
    const int built_in = (p - 1) / 2 + 1;
    add_end_conditions(form, request, true, built_in);
    // With symmetry the other end follows.
    if (request.symmetry == Symmetry::none) add_end_conditions(form, request, false, built_in);
    return form;
}

// ---- symmetry
// -------------------------------------------------------------------------------------------------

/// Every form mirrors entry by entry: index k corresponds to (last − k), with a sign for odd derivatives.
void add_symmetry_rows(DesignForm& form, const DesignRequest& request) {
    const bool odd = request.symmetry == Symmetry::odd;
    const double sum = request.begin_state[0] + request.end_state[0];
    const int count = static_cast<int>(form.entries.size());
    const int per_place = request.kind == DesignKind::states ? orders_of_state(request.space) : 1;
    for (int j = 0; j < count; ++j) {
        const int order = form.entries[j].order;
        const int mirrored = (count / per_place - 1 - j / per_place) * per_place + j % per_place;
        if (mirrored < j) continue;
        // Each derivative of the mirrored curve changes its sign once more.
        const double sign = (odd ? 1.0 : -1.0) * (order % 2 == 0 ? 1.0 : -1.0);
        if (mirrored == j && sign < 0.0) continue;
        AffineRow row{odd && order == 0 ? -sum : 0.0, {j, mirrored}, {1.0, sign}};
        if (mirrored == j) row = {row.offset, {j}, {2.0}};
        form.rows.push_back({std::move(row), fmt::format("symmetry of {}", form.entries[j].name)});
    }
}

}  // namespace

std::vector<PointCondition> rest_conditions(double x, Side side, int rest) {
    const char* const key = rest == 3 ? "spline.end_jerk" : "spline.rest";
    std::vector<PointCondition> conditions;
    for (int order = 3; order <= rest; ++order)
        conditions.push_back({x, order, side, 0.0, fmt::format("{} at x = {:.6g}", key, x), false});
    return conditions;
}

DesignForm raw_form(const DesignRequest& request) {
    DesignForm form;
    switch (request.kind) {
        case DesignKind::states:
            form = states_form(request);
            break;
        case DesignKind::coefficients:
            form = coefficients_form(request);
            break;
        case DesignKind::ordinates:
            form = ordinates_form(request);
            break;
        case DesignKind::automatic:
            throw ModelError("a design vector needs its form named: ordinates, coefficients or states");
    }
    if (request.symmetry != Symmetry::none) add_symmetry_rows(form, request);
    return form;
}

LocalMap without_fixed(LocalMap map, const DesignForm& form, const std::vector<int>& new_index) {
    LocalMap reduced{{}, {}, std::move(map.offset)};
    std::vector<int> kept;
    for (int k = 0; k < static_cast<int>(map.columns.size()); ++k) {
        const int entry = map.columns[k];
        if (form.entries[entry].fixed) {
            reduced.offset += map.matrix.col(k) * form.entries[entry].value;
        } else {
            reduced.columns.push_back(new_index[entry]);
            kept.push_back(k);
        }
    }
    reduced.matrix = map.matrix(Eigen::all, kept);
    return reduced;
}

AffineRow without_fixed(const AffineRow& row, const DesignForm& form, const std::vector<int>& new_index) {
    AffineRow reduced{row.offset, {}, {}};
    for (std::size_t k = 0; k < row.columns.size(); ++k) {
        const DesignEntry& entry = form.entries[row.columns[k]];
        if (entry.fixed) {
            reduced.offset += row.weights[k] * entry.value;
        } else {
            reduced.columns.push_back(new_index[row.columns[k]]);
            reduced.weights.push_back(row.weights[k]);
        }
    }
    return reduced;
}

}  // namespace camopt
