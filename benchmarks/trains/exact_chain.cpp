// SPDX-License-Identifier: MIT
#include "benchmarks/trains/exact_chain.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace trains {

namespace {

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
using Quad = long double;  // 113 bits where there is no other type of them
static_assert(sizeof(long double) == 16, "no floating type of 113 bits");
#endif

constexpr int taylor_terms = 30;
constexpr int usual_places = 64;

struct QuadMatrix {
    std::size_t size;
    std::vector<Quad> entries;

    explicit QuadMatrix(std::size_t n) : size(n), entries(n * n, Quad(0)) {}
    Quad& at(std::size_t row, std::size_t column) { return entries[row * size + column]; }
    const Quad& at(std::size_t row, std::size_t column) const { return entries[row * size + column]; }
};

QuadMatrix product(const QuadMatrix& a, const QuadMatrix& b) {
    QuadMatrix result(a.size);
    for (std::size_t i = 0; i < a.size; ++i)
        for (std::size_t k = 0; k < a.size; ++k)
            for (std::size_t j = 0; j < a.size; ++j) result.at(i, j) += a.at(i, k) * b.at(k, j);
    return result;
}

double row_sum(const QuadMatrix& matrix) {
    double largest = 0.0;
    for (std::size_t i = 0; i < matrix.size; ++i) {
        double sum = 0.0;
        for (std::size_t j = 0; j < matrix.size; ++j) sum += std::abs(static_cast<double>(matrix.at(i, j)));
        largest = std::max(largest, sum);
    }
    return largest;
}

/// e^M: M / 2^s with a norm below 1/2, its series, squared s times.
QuadMatrix exponential(QuadMatrix matrix) {
    const int halvings =
        std::max(0, static_cast<int>(std::ceil(std::log2(std::max(row_sum(matrix), 1e-9)))) + 1);
    Quad scale = 1;
    for (int k = 0; k < halvings; ++k) scale /= 2;
    for (Quad& entry : matrix.entries) entry *= scale;
    QuadMatrix sum(matrix.size);
    for (std::size_t i = 0; i < matrix.size; ++i) sum.at(i, i) = 1;
    QuadMatrix term = sum;
    for (int k = 1; k <= taylor_terms; ++k) {
        term = product(term, matrix);
        for (std::size_t i = 0; i < term.entries.size(); ++i) {
            term.entries[i] /= k;
            sum.entries[i] += term.entries[i];
        }
    }
    for (int k = 0; k < halvings; ++k) sum = product(sum, sum);
    return sum;
}

/// (u, v, 1, x, x², …)' = this · (u, v, 1, x, x², …), from the very doubles of the chain.
QuadMatrix generator(const Chain& chain, const std::vector<double>& powers) {
    const std::size_t n = chain.masses.size();
    QuadMatrix result(2 * n + powers.size());
    const Quad frequency = chain.frequency;
    for (std::size_t i = 0; i < n; ++i) {
        result.at(i, n + i) = frequency;
        for (std::size_t k = 0; k < powers.size(); ++k)
            result.at(n + i, 2 * n + k) = -Quad(powers[k]) / (Quad(chain.size) * frequency);
        const Mass& own = chain.masses[i];
        for (std::size_t on = i == 0 ? 0 : i - 1; on <= i; ++on) {
            const Quad sign = (on == i ? Quad(-1) : Quad(1)) / Quad(chain.masses[on].mass);
            result.at(n + on, i) += sign * Quad(own.stiffness) / frequency;
            result.at(n + on, n + i) += sign * Quad(own.damping);
            if (i == 0) continue;
            result.at(n + on, i - 1) -= sign * Quad(own.stiffness) / frequency;
            result.at(n + on, n + i - 1) -= sign * Quad(own.damping);
        }
    }
    for (std::size_t k = 1; k < powers.size(); ++k) result.at(2 * n + k, 2 * n + k - 1) = static_cast<int>(k);
    return result;
}

std::vector<Quad> moved(const QuadMatrix& step, const std::vector<Quad>& state) {
    std::vector<Quad> next(step.size, Quad(0));
    for (std::size_t i = 0; i < step.size; ++i)
        for (std::size_t j = 0; j < step.size; ++j) next[i] += step.at(i, j) * state[j];
    return next;
}

void look(ExactResponse& found, const Chain& chain, const std::vector<Quad>& state) {
    const std::size_t n = chain.masses.size();
    found.output = static_cast<double>(state[n - 1]);
    found.rate = static_cast<double>(state[2 * n - 1]);
    found.largest_output = std::max(found.largest_output, std::abs(found.output));
    found.largest_rate = std::max(found.largest_rate, std::abs(found.rate));
    const Mass& first = chain.masses.front();
    const double pull = first.stiffness * static_cast<double>(state[0]) +
                        first.damping * chain.frequency * static_cast<double>(state[n]);
    found.largest_pull = std::max(found.largest_pull, pull);
}

}  // namespace

ExactResponse exact_response(const Chain& chain, const std::vector<InputPiece>& pieces, int places) {
    const std::size_t n = chain.masses.size();
    ExactResponse found;
    std::vector<Quad> resting(2 * n, Quad(0));
    for (const InputPiece& piece : pieces) {
        QuadMatrix step = generator(chain, piece.powers);
        for (Quad& entry : step.entries) entry *= Quad(piece.width) / places;
        step = exponential(std::move(step));
        std::vector<Quad> state = resting;
        state.resize(step.size, Quad(0));
        state[2 * n] = 1;
        for (std::size_t i = 0; i < n; ++i)
            state[n + i] -= Quad(piece.kick) / (Quad(chain.size) * Quad(chain.frequency));
        for (int place = 0; place < places; ++place) {
            state = moved(step, state);
            look(found, chain, state);
        }
        resting.assign(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(2 * n));
    }
    return found;
}

ExactResponse exact_response(const Chain& chain) {
    return exact_response(chain, {{1.0, {std::begin(input), std::end(input)}, 0.0}}, usual_places);
}

}  // namespace trains
