// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_request.hpp"

#include "apps/scene_loading.hpp"
#include "core/errors.hpp"
#include "core/text/number_parsing.hpp"
#include "core/text/text_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

namespace camopt::apps {

namespace {

constexpr std::string_view simplex = "simplex:";

std::optional<int> integer(std::string_view text) {
    const std::optional<long long> value = integer_in(text);
    if (!value || !std::in_range<int>(*value)) return std::nullopt;
    return static_cast<int>(*value);
}

SweepAxis weights_axis(const std::string& weights) {
    if (!weights.starts_with(simplex)) return weights_of_csv(read_text_file(weights), weights);
    const std::optional<int> divisions = integer(std::string_view(weights).substr(simplex.size()));
    if (!divisions)
        throw InputError(
            fmt::format("--weights {}: found no number of divisions; allowed: simplex:N, for "
                        "example simplex:20, or a CSV file",
                        weights));
    return simplex_weights(*divisions);
}

}  // namespace

SweepPlan sweep_plan(const SweepRequest& request) {
    std::vector<SweepAxis> axes;
    for (const std::string& text : request.vary) axes.push_back(varied_key(text));
    if (!request.weights.empty()) axes.push_back(weights_axis(request.weights));
    return sweep_grid(axes);
}

std::vector<std::string> sweep_axes(const SweepRequest& request) {
    std::vector<std::string> words;
    for (const std::string& text : request.vary) words.push_back("--vary " + text);
    if (!request.weights.empty()) words.push_back("--weights " + request.weights);
    return words;
}

std::vector<std::string> sweep_settings(const SweepRequest& request) {
    return with_solver(request.settings, request.solver);
}

SweepShard sweep_shard(const SweepRequest& request) {
    if (request.shard.empty()) return {};
    const std::string_view text = request.shard;
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const std::optional<int> index = integer(text.substr(0, slash));
        const std::optional<int> count = integer(text.substr(slash + 1));
        if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
    }
    throw InputError(
        fmt::format("--shard {}: found no part of a whole; allowed: i/N with i from 1 to N, for example 2/3",
                    request.shard));
}

}  // namespace camopt::apps
