// SPDX-License-Identifier: MIT
#include "linear/chain_factor.hpp"

#include <numeric>

namespace camopt {
namespace {

using Matrix = SymmetricFactor::Matrix;

// Below this size a dense matrix is as fast as a chain.
constexpr int small = 20;
// A chain is narrow: for a wider band a general sparse factorization is cheaper.
constexpr int widest_band = 40;
constexpr int widest_border = 24;
/// A row is dense if it has at least `many` entries further than `far` from the diagonal.
struct Density {
    int far = 10, many = 6;
};
// Tried where the band comes out wider than this: of a short chain, a row over all of it has few far entries.
constexpr Density of_short_chain{4, 4};
constexpr int narrow_band = 11;
// A pivot partner is chosen among the entries of the row within this factor of the largest.
constexpr double large_entry = 0.3;

/// The columns of every row, both triangles, without the diagonal.
struct Graph {
    explicit Graph(const Matrix& lower) : begin(static_cast<std::size_t>(lower.rows()) + 1, 0) {
        const auto each = [&](auto&& visit) {
            for (int j = 0; j < lower.outerSize(); ++j)
                for (Matrix::InnerIterator entry(lower, j); entry; ++entry)
                    if (entry.row() != j) visit(static_cast<int>(entry.row()), j, std::abs(entry.value()));
        };
        each([&](int i, int j, double) {
            ++begin[static_cast<std::size_t>(i) + 1];
            ++begin[static_cast<std::size_t>(j) + 1];
        });
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        neighbour.resize(static_cast<std::size_t>(begin.back()));
        size.resize(neighbour.size());
        std::vector<int> next(begin.begin(), begin.end() - 1);
        each([&](int i, int j, double value) {
            const auto put = [&](int from, int to) {
                const auto place = static_cast<std::size_t>(next[from]++);
                neighbour[place] = to;
                size[place] = value;
            };
            put(i, j);
            put(j, i);
        });
    }
    [[nodiscard]] int degree(int row) const { return begin[static_cast<std::size_t>(row) + 1] - begin[row]; }
    /// Calls visit(neighbour, magnitude).
    template <typename Visit>
    void each_neighbour(int row, Visit&& visit) const {
        const auto from = static_cast<std::size_t>(begin[row]);
        const auto to = static_cast<std::size_t>(begin[static_cast<std::size_t>(row) + 1]);
        for (std::size_t p = from; p < to; ++p) visit(neighbour[p], size[p]);
    }

    std::vector<int> begin, neighbour;
    std::vector<double> size;
};

class Ordering {
 public:
    Ordering(const Matrix& lower, const std::vector<int>& signs)
        : graph_(lower), signs_(signs), rows_(static_cast<int>(lower.rows())) {}

    std::optional<ChainOrder> run() {
        const bool found = order_by(Density{});
        if (found && order_.half_bandwidth <= narrow_band) return std::move(order_);
        const ChainOrder first = std::exchange(order_, {});
        if (order_by(of_short_chain) && (!found || width_of(order_) < width_of(first)))
            return std::move(order_);
        return found ? std::optional(first) : std::nullopt;
    }

 private:
    static int width_of(const ChainOrder& order) {
        return order.half_bandwidth + static_cast<int>(order.border.size());
    }

    /// False: the band or the border would be wide.
    bool order_by(const Density& density) {
        find_border(density);
        if (static_cast<int>(order_.border.size()) > widest_border) return false;
        std::vector<int> chain;
        for (int row = 0; row < rows_; ++row)
            if (is_variable(row)) chain.push_back(row);
        lay_out(chain);
        if (order_.half_bandwidth > widest_band && rows_ > small) {
            lay_out(breadth_first(chain));
            if (order_.half_bandwidth > widest_band) return false;
        }
        for (std::size_t k = 0; k < order_.border.size(); ++k)
            order_.position[order_.border[k]] = static_cast<int>(order_.sequence.size() + k);
        return true;
    }

    [[nodiscard]] bool in_border(int row) const { return dense_[row] != 0; }
    [[nodiscard]] bool is_variable(int row) const { return signs_[row] > 0 && !in_border(row); }

    /// Rows with many entries far from the diagonal: variables that appear everywhere (peaks), and equalities
    /// over everything. The densest are removed first, since each removal reduces the count of its
    /// neighbours.
    void find_border(const Density& density) {
        dense_.assign(static_cast<std::size_t>(rows_), 0);
        if (rows_ <= small) return;
        std::vector<int> place(static_cast<std::size_t>(rows_), -1);
        for (int row = 0, next = 0; row < rows_; ++row)
            if (signs_[row] > 0) place[row] = next++;
        const auto each_far = [&](int row, auto&& visit) {
            const int own = center_of(row, place);
            graph_.each_neighbour(row, [&](int other, double) {
                const int there = place[other];
                if (there >= 0 && std::abs(there - own) > density.far && !in_border(other)) visit(other);
            });
        };
        std::vector<int> reaches(static_cast<std::size_t>(rows_), 0), suspects;
        for (int row = 0; row < rows_; ++row) {
            each_far(row, [&](int) { ++reaches[row]; });
            if (reaches[row] >= density.many) suspects.push_back(row);
        }
        std::ranges::stable_sort(suspects, std::greater{}, [&](int row) { return reaches[row]; });
        for (const int row : suspects) {
            int left = 0;
            each_far(row, [&](int) { ++left; });
            if (left < density.many) continue;
            dense_[row] = 1;
            order_.border.push_back(row);
        }
        std::ranges::sort(order_.border);
    }

    /// The position of a variable; of an equality that of its middle variable.
    [[nodiscard]] int center_of(int row, const std::vector<int>& place) const {
        if (place[row] >= 0) return place[row];
        int least = rows_, most = 0;
        graph_.each_neighbour(row, [&](int other, double) {
            least = std::min(least, place[other]);
            most = std::max(most, place[other]);
        });
        return (least + most) / 2;
    }

    /// Puts every equality next to its partner and measures the band.
    void lay_out(const std::vector<int>& chain) {
        std::vector<int> place(static_cast<std::size_t>(rows_), -1), partner(place), waits_for(place);
        for (std::size_t k = 0; k < chain.size(); ++k) place[chain[k]] = static_cast<int>(k);
        std::vector<std::pair<int, int>> late;  // equalities without a partner: position before them, row
        for (int row = 0; row < rows_; ++row) {
            if (signs_[row] > 0 || in_border(row)) continue;
            const int found = partner_of(row, place, partner);
            if (found >= 0) {
                partner[found] = row;
                continue;
            }
            int last = -1;
            graph_.each_neighbour(row, [&](int other, double) { last = std::max(last, place[other]); });
            late.emplace_back(std::max(0, last), row);
        }
        order_.sequence.clear();
        order_.opens_pair.clear();
        const auto put = [&](int row, bool opens) {
            order_.sequence.push_back(row);
            order_.opens_pair.push_back(opens ? 1 : 0);
        };
        std::ranges::stable_sort(late, {}, &std::pair<int, int>::first);
        auto next = late.begin();
        for (std::size_t k = 0; k < chain.size(); ++k) {
            const int row = partner[chain[k]];
            put(chain[k], row >= 0);
            if (row >= 0) put(row, false);
            for (; next != late.end() && next->first == static_cast<int>(k); ++next) put(next->second, false);
        }
        for (; next != late.end(); ++next) put(next->second, false);
        measure_band();
    }

    /// The variable of the chain that is latest among those with a large entry in this equality.
    [[nodiscard]] int partner_of(int row, const std::vector<int>& place,
                                 const std::vector<int>& taken) const {
        double largest = 0.0;
        graph_.each_neighbour(row, [&](int other, double size) {
            if (is_variable(other)) largest = std::max(largest, size);
        });
        int found = -1;
        graph_.each_neighbour(row, [&](int other, double size) {
            if (!is_variable(other) || taken[other] >= 0) return;
            if (size < large_entry * largest || size == 0.0) return;
            if (found < 0 || place[other] > place[found]) found = other;
        });
        return found;
    }

    void measure_band() {
        order_.position.assign(static_cast<std::size_t>(rows_), -1);
        for (std::size_t k = 0; k < order_.sequence.size(); ++k)
            order_.position[order_.sequence[k]] = static_cast<int>(k);
        order_.half_bandwidth = 1;
        for (const int row : order_.sequence) {
            const int own = order_.position[row];
            graph_.each_neighbour(row, [&](int other, double) {
                const int there = order_.position[other];
                if (there >= 0) order_.half_bandwidth = std::max(order_.half_bandwidth, own - there);
            });
        }
    }

    /// The variables of the chain by their distance from one of its ends (Cuthill and McKee).
    [[nodiscard]] std::vector<int> breadth_first(const std::vector<int>& chain) const {
        if (chain.empty()) return {};
        std::vector<int> reached = levels_from(chain.front(), chain);
        reached = levels_from(reached.back(), chain);
        std::erase_if(reached, [&](int row) { return !is_variable(row); });
        return reached;
    }

    [[nodiscard]] std::vector<int> levels_from(int start, const std::vector<int>& chain) const {
        std::vector<char> seen(static_cast<std::size_t>(rows_), 0);
        std::vector<int> queue;
        const auto reach = [&](int row) {
            if (seen[row] != 0 || in_border(row)) return;
            seen[row] = 1;
            queue.push_back(row);
        };
        std::size_t head = 0;
        const auto spread = [&] {
            for (; head < queue.size(); ++head)
                graph_.each_neighbour(queue[head], [&](int other, double) { reach(other); });
        };
        reach(start);
        spread();
        for (const int row : chain) {  // components connected only through the border
            reach(row);
            spread();
        }
        return queue;
    }

    Graph graph_;
    const std::vector<int>& signs_;
    int rows_;
    std::vector<char> dense_;
    ChainOrder order_;
};

}  // namespace

std::optional<ChainOrder> chain_order(const Matrix& lower, const std::vector<int>& signs) {
    return Ordering(lower, signs).run();
}

}  // namespace camopt
