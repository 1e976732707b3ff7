// SPDX-License-Identifier: MIT
#include "output/nc/post/post_processor.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace camopt {

namespace {

constexpr int most_decimals = 9;
// Letters that mean something else in every dialect.
constexpr std::string_view taken_letters = "GMNOFSTDHIJKRLPQ";

void require_decimals(const char* key, int found) {
    if (found < 0 || found > most_decimals)
        throw InputError(
            fmt::format("post-processor: {} must be 0 … {}, found {}", key, most_decimals, found));
}

void check_axis(const std::string& key, const PostAxis& axis, std::set<std::string>& letters) {
    if (axis.letter.size() != 1 || axis.letter[0] < 'A' || axis.letter[0] > 'Z' ||
        taken_letters.find(axis.letter[0]) != std::string_view::npos)
        throw InputError(
            fmt::format("post-processor: axes.{}.letter must be a capital letter of an axis (A B C E U V W X "
                        "Y Z), found \"{}\"",
                        key, axis.letter));
    if (!letters.insert(axis.letter).second)
        throw InputError(fmt::format("post-processor: two axes have the letter {}", axis.letter));
    if (axis.sign != 1 && axis.sign != -1)
        throw InputError(
            fmt::format("post-processor: axes.{}.sign must be 1 or -1, found {}", key, axis.sign));
    if (!std::isfinite(axis.offset))
        throw InputError(fmt::format("post-processor: the offset of axes.{} must be finite", key));
}

}  // namespace

void PostProcessor::validate() const {
    require_decimals("linear_decimals", linear_decimals);
    require_decimals("angle_decimals", angle_decimals);
    require_decimals("feed_decimals", feed_decimals);
    if (first_block < 0 || block_step < 0)
        throw InputError(
            fmt::format("post-processor: first_block and block_step must be >= 0, found {} and {}",
                        first_block, block_step));
    const bool known_comment =
        (comment_begin == "(" && comment_end == ")") || (comment_begin == ";" && comment_end.empty());
    if (!known_comment)
        throw InputError(fmt::format("post-processor: comments are ( … ) or ; …, found {} … {}",
                                     comment_begin, comment_end));
    std::set<std::string> letters;
    for (const auto& [key, axis] : axes) check_axis(key, axis, letters);
}

PostProcessor generic_post(const Machine& machine) {
    PostProcessor post;
    const bool turns = machine.axes().back().kind == AxisKind::rotary;
    if (!turns) post.feed_mode = FeedMode::per_minute;
    const bool tilts = machine.axes().back().key == "tilt";
    for (const MachineAxis& axis : machine.axes()) {
        if (axis.kind == AxisKind::linear)
            post.axes[axis.key].letter = static_cast<char>(axis.key[0] - 'a' + 'A');
        else if (axis.key == "tilt")
            post.axes[axis.key].letter = "B";
        else
            post.axes[axis.key].letter = tilts ? "C" : "A";
    }
    return post;
}

const PostAxis& post_axis(const PostProcessor& post, const MachineAxis& axis) {
    const auto found = post.axes.find(axis.key);
    if (found == post.axes.end())
        throw InputError(fmt::format("post-processor {}: it has no axes.{}, which the machine moves",
                                     post.name, axis.key));
    return found->second;
}

double printed_unit(const PostProcessor& post, AxisKind kind) {
    return kind == AxisKind::linear ? metres_of(post.unit) : units::degree;
}

double half_last_digit(const PostProcessor& post, AxisKind kind) {
    const int decimals = kind == AxisKind::linear ? post.linear_decimals : post.angle_decimals;
    return 0.5 * std::pow(10.0, -decimals) * printed_unit(post, kind);
}

}  // namespace camopt
