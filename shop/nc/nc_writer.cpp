// SPDX-License-Identifier: MIT
#include "shop/nc/nc_writer.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// As a comment: brackets and lines end comments, % ends programs, and a control reads ASCII.
std::string ascii(std::string_view words) {
    std::string result = ascii_text(words);
    std::ranges::replace(result, '(', ' ');
    std::ranges::replace(result, ')', ' ');
    std::ranges::replace(result, ';', ',');
    for (std::size_t place = 0; (place = result.find('%', place)) != std::string::npos;)
        result.replace(place, 1, "percent");
    return result;
}

}  // namespace

NcWriter::NcWriter(const Machine& machine, const PostProcessor& post)
    : machine_(machine), post_(post), last_words_(machine.axes().size()), block_(post.first_block) {}

void NcWriter::line(const std::string& words) {
    if (post_.block_step > 0 && words != "%") {
        text_ += fmt::format("N{} ", block_);
        block_ += post_.block_step;
    }
    text_ += words + "\n";
}

void NcWriter::comment(std::string_view words) {
    text_ += fmt::format("{}{}{}\n", post_.comment_begin, ascii(words), post_.comment_end);
}

/// G93 or G94 where it changes.
void NcWriter::mode(std::string_view word) {
    if (feed_mode_ == word) return;
    feed_mode_ = word;
    line(std::string(word));
}

/// Every known {word} replaced; what stands for it is not searched again.
std::string NcWriter::placed(const std::string& text) const {
    std::string result;
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t end = text[place] == '{' ? text.find('}', place) : std::string::npos;
        const auto found = end == std::string::npos ? placeholders_.end()
                                                    : placeholders_.find(text.substr(place, end + 1 - place));
        if (found == placeholders_.end()) {
            result += text[place++];
            continue;
        }
        result += found->second;
        place = end + 1;
    }
    return result;
}

std::string NcWriter::number(double value, int decimals) const {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find_first_not_of("-0.") == std::string::npos && text[0] == '-') text.erase(0, 1);  // no -0.000
    return text;
}

std::string NcWriter::axis_word(std::size_t axis, double value, bool always) {
    const MachineAxis& kind = machine_.axes()[axis];
    const PostAxis& post = post_axis(post_, kind);
    const int decimals = kind.kind == AxisKind::linear ? post_.linear_decimals : post_.angle_decimals;
    const double printed = (post.sign * value + post.offset) / printed_unit(post_, kind.kind);
    std::string word = " " + post.letter + number(printed, decimals);
    if (!always && post_.modal && word == last_words_[axis]) return {};
    last_words_[axis] = word;
    return word;
}

/// "X = x", of other signs and origins "A = -rotary + 180": how the program's numbers follow from the cam.
std::string NcWriter::axis_formula(const MachineAxis& axis) const {
    const PostAxis& post = post_axis(post_, axis);
    const double offset = post.offset / printed_unit(post_, axis.kind);
    return fmt::format("{} = {}{}", post.letter, post.sign < 0 ? "-" : "", axis.key) +
           (offset == 0.0 ? "" : fmt::format(" {} {:.12g}", offset < 0.0 ? '-' : '+', std::abs(offset)));
}

std::string NcWriter::axis_words(const Eigen::VectorXd& values) {
    std::string words;
    for (std::size_t i = 0; i < machine_.axes().size(); ++i)
        words += axis_word(i, values(static_cast<Eigen::Index>(i)), false);
    return words.empty() ? axis_word(0, values(0), true) : words;  // a block that rests is a block too
}

void NcWriter::begin(const NcJob& job, double plane) {
    placeholders_ = {{"{title}", ascii(job.title)},
                     {"{tool}", ascii(job.tool)},
                     {"{post}", ascii(post_.name)},
                     {"{machine}", ascii(machine_.name())},
                     {"{spindle_rpm}", fmt::format("{:.0f}", job.spindle_rpm)},
                     {"{spindle_sense}", job.spindle == SpindleSense::clockwise ? "M3" : "M4"},
                     {"{tool_number}", fmt::format("{}", job.tool_number.value_or(0))}};
    for (const std::string& words : post_.header) line(placed(words));
    const bool inch = post_.unit == LengthUnit::inch;
    const char* const length = inch ? "inch" : "mm";
    comment(job.title);
    comment(fmt::format("tool: {}", job.tool));
    comment(fmt::format("machine: {}, post-processor: {}", machine_.name(), post_.name));
    std::string letters;
    for (const MachineAxis& axis : machine_.axes())
        append_item(letters, fmt::format("{} in {}", axis_formula(axis),
                                         axis.kind == AxisKind::linear ? length : "deg"));
    comment(letters);
    comment(post_.feed_mode == FeedMode::inverse_time
                ? "feed: G93, F = 1 / minutes of the block, plunging: G94"
                : fmt::format("feed: G94, {} / min", length));
    for (const std::string& remark : job.remarks) comment(remark);
    if (job.stock > 0.0)
        comment(
            fmt::format("stock: {:.9g} mm are left on the finished surface", job.stock / units::millimetre));
    describe_blank(job, plane);
    warn(job);
    const bool plane_words = std::ranges::any_of(job.passes, [](const NcPass& pass) {
        return !pass.arcs.empty() || pass.compensation != CompensationSide::none;
    });
    line(fmt::format("{}{} G90 G94", inch ? "G20" : "G21", plane_words ? " G17 G40" : ""));
    feed_mode_ = "G94";
    if (job.tool_number && !post_.tool_call.empty()) line(placed(post_.tool_call));
    if (job.spindle_rpm > 0.0 && !post_.spindle_on.empty()) line(placed(post_.spindle_on));
}

void NcWriter::warn(const NcJob& job) {
    for (const std::string& warning : warnings_of(post_, job)) comment("WARNING: " + warning);
}

/// What the operator must set up so that no rapid runs into anything.
void NcWriter::describe_blank(const NcJob& job, double plane) {
    const std::string word = axis_word(2, plane, true).substr(1);
    last_words_[2].clear();
    comment(fmt::format("blank: {}", words_of(job.blank)));
    const bool turns = std::ranges::any_of(
        machine_.axes(), [](const MachineAxis& axis) { return axis.kind == AxisKind::rotary; });
    comment(fmt::format("clearance plane: {}, {:g} mm above the blank{}", word,
                        job.clearance / units::millimetre, turns ? " at any angle of the table" : ""));
    comment(fmt::format("rapids stay {:g} mm or more from the blank, moves into and out of it are feeds",
                        job.safe_distance / units::millimetre));
    comment("before the start: tool clear of blank and clamps, free to go straight to the clearance plane");
}

void NcWriter::approach(std::string_view name, const NcStep& first, const WayHeights& heights) {
    comment(fmt::format("pass: {}", name));
    line("G0" + axis_word(2, heights.plane, true));
    std::string words;
    for (std::size_t i = 0; i < machine_.axes().size(); ++i)
        if (i != 2) words += axis_word(i, first.values(static_cast<Eigen::Index>(i)), true);
    line("G0" + words);
    line("G0" + axis_word(2, heights.safe, true));
    last_values_ = first.values;
}

/// Z alone, by feed.
void NcWriter::along_the_tool(double height, double feed) {
    mode("G94");
    const double per_minute = feed * units::minute / metres_of(post_.unit);
    line("G1" + axis_word(2, height, true) + " F" + number(per_minute, post_.feed_decimals));
}

/// I and J: from where the block begins.
std::string NcWriter::arc_words(const NcArc& arc) const {
    const double unit = metres_of(post_.unit);
    const Eigen::Vector2d offset = arc.center - last_values_.head<2>();
    const auto word = [&](char letter, std::size_t axis) {
        const double printed =
            post_axis(post_, machine_.axes()[axis]).sign * offset(static_cast<Eigen::Index>(axis));
        return fmt::format(" {}{}", letter, number(printed / unit, post_.linear_decimals));
    };
    return word('I', 0) + word('J', 1);
}

void NcWriter::compensate(CompensationSide side, int offset_register) {
    const bool left = (side == CompensationSide::left) != mirrored();
    before_block_ = fmt::format("{} D{} ", left ? "G41" : "G42", offset_register);
}

void NcWriter::cut(const NcStep& step, double seconds, double feed, const NcArc* arc) {
    const bool by_time = post_.feed_mode == FeedMode::inverse_time;
    mode(by_time ? "G93" : "G94");
    const double word = by_time ? units::minute / seconds : feed * units::minute / metres_of(post_.unit);
    const bool clockwise = arc != nullptr && arc->clockwise != mirrored();
    const std::string motion = arc == nullptr ? "G1" : clockwise ? "G2" : "G3";
    std::string words = before_block_ + motion + axis_words(step.values);
    if (arc != nullptr) words += arc_words(*arc);
    line(words + " F" + number(word, post_.feed_decimals));
    before_block_.clear();
    last_values_ = step.values;
}

void NcWriter::retract(const WayHeights& heights, double feed) {
    along_the_tool(heights.safe, feed);
    line("G0" + axis_word(2, heights.plane, true));
}

std::string NcWriter::finish() {
    for (const std::string& words : post_.footer) line(placed(words));
    return std::move(text_);
}

}  // namespace camopt
