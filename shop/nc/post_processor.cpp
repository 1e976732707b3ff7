// SPDX-License-Identifier: MIT
#include "shop/nc/post_processor.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "core/text/text_file.hpp"
#include "input/key_file.hpp"
#include "scene/key_place.hpp"

#include <fmt/format.h>

#include <set>

namespace camopt {

namespace {

constexpr int most_decimals = 9;
constexpr const char* inch_word = "inch";
using KeyUnits = std::span<const Spelling>;
// Letters that mean something else in every dialect.
constexpr std::string_view taken_letters = "GMNOFSTDHIJKRLPQ";

void check_axis(const std::string& key, const PostAxis& axis, std::set<std::string>& letters) {
    if (axis.letter.size() != 1 || axis.letter[0] < 'A' || axis.letter[0] > 'Z' ||
        taken_letters.find(axis.letter[0]) != std::string_view::npos)
        throw InputError(
            fmt::format("post-processor: axes.{}.letter must be a capital letter of an axis (A B C E U V W X "
                        "Y Z), found \"{}\"",
                        key, axis.letter));
    if (!letters.insert(axis.letter).second)
        throw InputError(fmt::format("post-processor: two axes have the letter {}", axis.letter));
}

using enum KeyType;
using namespace spellings;

/// Words that reach the program as they are: one line of ASCII characters each.
void require_ascii(std::span<const std::string> lines) {
    const auto printed = [](char letter) { return letter >= ' ' && letter <= '~'; };
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!std::ranges::all_of(lines[i], printed))
            throw RefusedValue(i, fmt::format("\"{}\"", printable(lines[i])), "one line of ASCII characters");
}

template <class Member>
KeyPlace printed_as_is(Member member) {
    KeyPlace place = stored_in(member);
    place.assign = [assign = place.assign](const KeyOwner& post, const KeyValue& value, const KeyAt& at) {
        if (const auto* const line = std::get_if<std::string>(&value))
            require_ascii({line, 1});
        else
            require_ascii(std::get<std::vector<std::string>>(value));
        assign(post, value, at);
    };
    return place;
}

KeyPlace unit_place() {
    return {.assign =
                [](PostProcessor& post, const KeyValue& value, const KeyAt&) {
                    post.unit =
                        std::get<std::string>(value) == inch_word ? LengthUnit::inch : LengthUnit::millimetre;
                },
            .value = [](const PostProcessor& post, const KeyAt&) -> std::optional<KeyValue> {
                return std::string(post.unit == LengthUnit::inch ? inch_word : name_of(post.unit));
            }};
}

/// A member of the axis of a machine.
template <class Value>
KeyPlace in_axis(std::string_view axis, Value PostAxis::*member) {
    return {.assign = [=, key = std::string(axis)](
                          PostProcessor& post, const KeyValue& value,
                          const KeyAt&) { key_place::assign(post.axes[key].*member, value, 0); },
            .value = [=, key = std::string(axis)](const PostProcessor& post,
                                                  const KeyAt&) -> std::optional<KeyValue> {
                const auto found = post.axes.find(key);
                if (found == post.axes.end()) return std::nullopt;
                return key_place::value_of(found->second.*member);
            }};
}

/// Of an axis of a machine: its table "axes.x".
struct AxisTable {
    std::string_view key, table;
    AxisKind kind;
};
constexpr AxisTable axis_tables[] = {{"x", "axes.x", AxisKind::linear},
                                     {"y", "axes.y", AxisKind::linear},
                                     {"z", "axes.z", AxisKind::linear},
                                     {"rotary", "axes.rotary", AxisKind::rotary},
                                     {"tilt", "axes.tilt", AxisKind::rotary}};

// A row is read as a row.
// clang-format off
void add_axis(std::vector<KeyRow>& rows, const AxisTable& axis) {
    const bool turns = axis.kind == AxisKind::rotary;
    rows.insert(rows.end(), {
        {axis.table, "letter", text, plain, any, {}, turns ? "A, B or C" : "X, Y or Z", "One capital letter.",
         in_axis(axis.key, &PostAxis::letter)},
        {axis.table, "sign", integer, plain, any, {"1", "-1"}, "1", "Before the value.", in_axis(axis.key, &PostAxis::sign)},
        {axis.table, "offset", number, turns ? KeyUnits(angle) : KeyUnits(length), any, {}, "0", "After it.",
         in_axis(axis.key, &PostAxis::offset)},
    });
}

std::vector<KeyRow> made_rows() {
    constexpr Range decimals = Range::between(0, most_decimals), block = Range::between(0, 1e9);
    std::vector<KeyRow> rows = {
        {"", "name", text, plain, any, {}, "\"generic\"", "Appears in the program.", printed_as_is(&PostProcessor::name)},
        {"", "unit", text, plain, any, {name_of(LengthUnit::millimetre), inch_word}, "\"mm\"", "G21 or G20.", unit_place()},
        {"", "feed", text, plain, any, {name_of(FeedMode::inverse_time), name_of(FeedMode::per_minute)}, "\"inverse_time\"; three axes: \"per_minute\"",
         "G93; `\"per_minute\"` (G94) only without rotary axes.", stored_in(&PostProcessor::feed_mode)},
        {"", "linear_decimals", integer, plain, decimals, {}, "4", "Printed decimals of linear axes.", stored_in(&PostProcessor::linear_decimals)},
        {"", "angle_decimals", integer, plain, decimals, {}, "5", "Printed decimals of rotary axes.", stored_in(&PostProcessor::angle_decimals)},
        {"", "feed_decimals", integer, plain, decimals, {}, "3", "Printed decimals of feeds.", stored_in(&PostProcessor::feed_decimals)},
        {"", "modal", boolean, plain, any, {}, "true", "Omit axes that keep their value.", stored_in(&PostProcessor::modal)},
        {"", "first_block", integer, plain, block, {}, "0", "The first N word.", stored_in(&PostProcessor::first_block)},
        {"", "block_step", integer, plain, block, {}, "0", "From N word to N word; 0: none.", stored_in(&PostProcessor::block_step)},
        {"", "comment_begin", text, plain, any, {"(", ";"}, "\"(\"", "Before a comment.", stored_in(&PostProcessor::comment_begin)},
        {"", "comment_end", text, plain, any, {")", ""}, "\")\"", "After a comment; of `;` empty.", stored_in(&PostProcessor::comment_end)},
        {"", "header", texts, plain, any, {}, "[\"%\"]", "Lines; `{title}`, `{tool}`, `{post}`, `{machine}` are filled in.",
         printed_as_is(&PostProcessor::header)},
        {"", "footer", texts, plain, any, {}, "[\"M5\", \"M30\", \"%\"]", "Lines at the end.", printed_as_is(&PostProcessor::footer)},
        {"", "spindle_on", text, plain, any, {}, "\"S{spindle_rpm} {spindle_sense}\"", "Written with --spindle-rpm; M3 or M4.",
         printed_as_is(&PostProcessor::spindle_on)},
        {"", "tool_call", text, plain, any, {}, "\"T{tool_number} M6\"", "Written with --tool-number.", printed_as_is(&PostProcessor::tool_call)},
        {"", "axes", table, plain, any, {}, "none", "The axes of the machine."},
    };
    for (const AxisTable& axis : axis_tables)
        rows.push_back({"axes", axis.key, table, plain, any, {}, "none", "How this axis is printed: sign · value + offset."});
    for (const AxisTable& axis : axis_tables) add_axis(rows, axis);
    return rows;
}
// clang-format on

}  // namespace

void PostProcessor::validate() const {
    for (const KeyRow& row : post_rows())
        if (row.place)
            if (const auto fault = row_fault(row, *this))
                throw InputError(fmt::format("post-processor: {}: {}", fault->member, words_of(*fault)));
    const bool known_comment =
        (comment_begin == "(" && comment_end == ")") || (comment_begin == ";" && comment_end.empty());
    if (!known_comment)
        throw InputError(fmt::format("post-processor: comments are ( … ) or ; …, found {} … {}",
                                     comment_begin, comment_end));
    std::set<std::string> letters;
    for (const auto& [key, axis] : axes) check_axis(key, axis, letters);
}

const std::vector<KeyRow>& post_rows() {
    static const std::vector<KeyRow> rows = made_rows();
    return rows;
}

const char* name_of(FeedMode mode) {
    return mode == FeedMode::inverse_time ? "inverse_time" : "per_minute";
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

PostProcessor post_of_text(std::string_view text, std::string_view name, PostProcessor base) {
    std::vector<KeyRow> rows = post_rows();
    for (const AxisTable& axis : axis_tables)  // that this machine does not have
        if (!base.axes.contains(std::string(axis.key)))
            std::erase_if(rows, [&](const KeyRow& row) {
                return row.table == axis.table || (row.table == "axes" && row.name == axis.key);
            });
    input::read_key_file(text, name, rows, base);
    base.validate();
    return base;
}

PostProcessor read_post(const std::filesystem::path& file, PostProcessor base) {
    const FileBytes read = file_bytes(file);
    if (!read.fault.empty())
        throw InputError(
            fmt::format("cannot read the post-processor file {}: {}", file.string(), read.fault));
    return post_of_text(read.bytes, file.string(), std::move(base));
}

}  // namespace camopt
