// SPDX-License-Identifier: MIT
#include "studies/sweep/sweep_axis.hpp"

#include "core/text/parsing.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr std::string_view prefix = "objective.";
constexpr std::string_view vary_forms =
    "KEY=a:b:count, KEY=a:b:count:log or KEY=v1,v2,…, for example cam.base_radius_mm=30:60:7";

class WeightFile {
 public:
    explicit WeightFile(std::string_view name) : name_(name) {}

    SweepAxis read(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // spreadsheets put a mark in front
        for (const std::string_view line : split_text(text, '\n')) {
            ++line_;
            if (line.empty() || line.starts_with('#')) continue;
            if (axis_.keys.empty())
                read_names(line);
            else
                read_point(line);
        }
        if (axis_.keys.empty()) fail("found no line; allowed: a line of names, then lines of weights");
        if (axis_.points() == 0) fail("found no line of weights below the names; allowed: at least one");
        return std::move(axis_);
    }

 private:
    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}:{}: {}", name_, line_, what));
    }

    void read_names(std::string_view line) {
        for (const std::string_view cell : split_text(line, ',')) {
            const std::string name(cell.starts_with(prefix) ? cell.substr(prefix.size()) : cell);
            std::string key = std::string(prefix) + name;
            if (weight_of_key(key) == nullptr) {
                std::vector<std::string> allowed;
                for (const ObjectiveWeight& weight : objective_weights())
                    allowed.push_back(weight.key.substr(prefix.size()));
                fail(fmt::format("found \"{}\"; allowed: names of weights: {}", cell,
                                 fmt::join(allowed, ", ")));
            }
            if (std::ranges::find(axis_.keys, key) != axis_.keys.end())
                fail(fmt::format("found \"{}\" twice; allowed: each weight once", name));
            axis_.keys.push_back(std::move(key));
        }
    }

    void read_point(std::string_view line) {
        const std::vector<std::string_view> cells = split_text(line, ',');
        if (cells.size() != axis_.keys.size())
            fail(fmt::format("found {} value(s); allowed: {}, one for each name of the first line",
                             cells.size(), axis_.keys.size()));
        if (axis_.points() >= most_sweep_rows)
            fail(fmt::format("found more lines; allowed: at most {} rows", most_sweep_rows));
        for (const std::string_view cell : cells) {
            const std::optional<double> value = number_in(cell);
            if (!value || *value < 0.0) fail(fmt::format("found \"{}\"; allowed: a number >= 0", cell));
            axis_.values.push_back(*value);
        }
    }

    std::string_view name_;
    int line_ = 0;
    SweepAxis axis_;
};

/// The values behind "KEY=".
class Values {
 public:
    explicit Values(std::string_view text) : text_(text) {}

    std::vector<double> read(std::string_view values) const {
        if (values.find(':') == std::string_view::npos) return list(values);
        const std::vector<std::string_view> parts = split_text(values, ':');
        const bool by_factors = parts.size() == 4 && parts[3] == "log";
        if (parts.size() != 3 && !by_factors)
            fail(fmt::format("found \"{}\"; allowed: {}", values, vary_forms));
        const double first = number(parts[0]), last = number(parts[1]);
        const std::optional<long long> count = integer_in(parts[2]);
        if (!count || *count < 2 || *count > most_sweep_rows)
            fail(fmt::format("found the count \"{}\"; allowed: an integer from 2 to {}", parts[2],
                             most_sweep_rows));
        if (first == last)
            fail(fmt::format("found {} at both ends; allowed: two different ends, or a single value", first));
        if (by_factors && !(first > 0.0 && last > 0.0))
            fail(fmt::format("found {} to {} by equal factors; allowed: both ends > 0", first, last));
        return by_factors ? between(first, last, static_cast<int>(*count), &Values::by_factor)
                          : between(first, last, static_cast<int>(*count), &Values::by_step);
    }

 private:
    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("--vary {}: {}", text_, what));
    }
    [[nodiscard]] double number(std::string_view cell) const {
        const std::optional<double> value = number_in(cell);
        if (!value) fail(fmt::format("found \"{}\"; allowed: a number; {}", cell, vary_forms));
        return *value;
    }
    [[nodiscard]] std::vector<double> list(std::string_view values) const {
        std::vector<double> found;
        for (const std::string_view cell : split_text(values, ',')) {
            const double value = number(cell);
            if (std::ranges::find(found, value) != found.end())
                fail(fmt::format("found {} twice; allowed: each value once", value));
            found.push_back(value);
        }
        return found;
    }

    static double by_step(double first, double last, double part) {
        return as_written(first + (last - first) * part);
    }
    /// To 12 digits: the power of a long way errs in the last ones, and not alike on every machine.
    static double by_factor(double first, double last, double part) {
        return required_number(fmt::format("{:.12g}", first * std::pow(last / first, part)));
    }
    static std::vector<double> between(double first, double last, int count,
                                       double (*at)(double, double, double)) {
        std::vector<double> values = {first};
        for (int i = 1; i < count - 1; ++i)
            values.push_back(at(first, last, static_cast<double>(i) / (count - 1)));
        values.push_back(last);
        return values;
    }

    std::string_view text_;
};

}  // namespace

SweepAxis simplex_weights(int divisions) {
    const auto points = [](long n) { return (n + 1) * (n + 2) / 2; };
    if (divisions < 1 || divisions > most_sweep_rows || points(divisions) > most_sweep_rows)
        throw InputError(
            fmt::format("--weights simplex:{}: found {} divisions; allowed: at least 1, and at most {} rows, "
                        "(N + 1)(N + 2)/2",
                        divisions, divisions, most_sweep_rows));
    SweepAxis axis{{"objective.velocity", "objective.acceleration", "objective.jerk"}, {}};
    axis.values.reserve(3 * static_cast<std::size_t>(points(divisions)));
    const double whole = divisions;
    for (int i = 0; i <= divisions; ++i) {
        const int rest = divisions - i;
        for (int step = 0; step <= rest; ++step) {
            const int j = i % 2 == 0 ? step : rest - step;
            axis.values.insert(axis.values.end(), {i / whole, j / whole, (rest - j) / whole});
        }
    }
    return axis;
}

SweepAxis weights_of_csv(std::string_view text, std::string_view name) {
    return WeightFile(name).read(text);
}

SweepAxis varied_key(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view key = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || key.empty())
        throw InputError(fmt::format("--vary {}: found no KEY=; allowed: {}", text, vary_forms));
    return {{std::string(key)}, Values(text).read(trimmed(text.substr(equals + 1)))};
}

const std::vector<ObjectiveWeight>& objective_weights() {
    static const std::vector<ObjectiveWeight> all = [] {
        std::vector<ObjectiveWeight> weights;
        const auto add = [&](std::string_view name, double ObjectiveSpec::*weight) {
            weights.push_back({std::string(prefix) + std::string(name),
                               [weight](ObjectiveSpec& objective) -> double& { return objective.*weight; }});
        };
        for (const CostTerm& term : cost_terms()) add(term.name(), term.weight);
        for (const ResponseTerm& term : response_terms()) add(term.name, term.weight);
        for (int i = 0; i < dimension_count; ++i)
            weights.push_back({std::string(prefix) + name_of(static_cast<DimensionIndex>(i)),
                               [i](ObjectiveSpec& objective) -> double& { return objective.dimensions[i]; }});
        return weights;
    }();
    return all;
}

const ObjectiveWeight* weight_of_key(std::string_view key) {
    const auto weight = std::ranges::find(objective_weights(), key, &ObjectiveWeight::key);
    return weight != objective_weights().end() ? &*weight : nullptr;
}

bool is_weight_key(std::string_view key) {
    return weight_of_key(key) != nullptr;
}

}  // namespace camopt
