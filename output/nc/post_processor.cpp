// SPDX-License-Identifier: MIT
#include "output/nc/post_processor.hpp"

#include "core/errors.hpp"
#include "core/text/text_file.hpp"

#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <set>
#include <sstream>
#include <type_traits>

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

// The TOML file of a post-processor.
class PostTable {
 public:
    PostTable(const toml::table& table, std::string_view file, std::string prefix)
        : table_(table), file_(file), prefix_(std::move(prefix)) {}

    template <class T>
    void read(const char* key, T& target) {
        known_.emplace_back(key);
        const toml::node* const node = table_.get(key);
        if (node == nullptr) return;
        const auto value = node->value_exact<T>();
        if (!value) refuse(*node, key, type_name<T>());
        if constexpr (std::is_same_v<T, std::string>) require_ascii(*node, key, *value);
        target = *value;
    }
    void read(const char* key, int& target) {
        std::int64_t value = target;
        read(key, value);
        if (value < -1'000'000'000 || value > 1'000'000'000)
            refuse(*table_.get(key), key, "a smaller number");
        target = static_cast<int>(value);
    }
    /// A number in `unit`.
    void read_length(const char* key, double unit, double& target) {
        known_.emplace_back(key);
        const toml::node* const node = table_.get(key);
        if (node == nullptr) return;
        const auto value = node->value<double>();
        if (!value || !node->is_number()) refuse(*node, key, "a number");
        target = *value * unit;
    }
    void read(const char* key, std::vector<std::string>& target) {
        known_.emplace_back(key);
        const toml::node* const node = table_.get(key);
        if (node == nullptr) return;
        if (!node->is_array()) refuse(*node, key, "an array of lines");
        target.clear();
        for (const toml::node& line : *node->as_array()) {
            if (!line.is_string()) refuse(line, key, "lines in quotes");
            target.push_back(line.as_string()->get());
            require_ascii(line, key, target.back());
        }
    }
    template <class Enum>
    void read_choice(const char* key, const std::vector<std::pair<std::string, Enum>>& choices,
                     Enum& target) {
        std::string word;
        read(key, word);
        if (word.empty() && table_.get(key) == nullptr) return;
        std::vector<std::string> names;
        for (const auto& [name, value] : choices) {
            names.push_back('"' + name + '"');
            if (name == word) {
                target = value;
                return;
            }
        }
        refuse(*table_.get(key), key, fmt::format("{}", fmt::join(names, " or ")));
    }
    [[nodiscard]] const toml::table* child(const char* key) {
        known_.emplace_back(key);
        const toml::node* const node = table_.get(key);
        if (node == nullptr) return nullptr;
        if (!node->is_table()) refuse(*node, key, "a table");
        return node->as_table();
    }
    /// Throws for keys that no one read.
    void finish() const {
        for (const auto& [key, node] : table_)
            if (std::find(known_.begin(), known_.end(), key.str()) == known_.end())
                throw InputError(fmt::format("{}:{}: unknown key {}{}; allowed: {}", file_,
                                             node.source().begin.line, prefix_, key.str(),
                                             fmt::join(known_, ", ")));
    }

 private:
    template <class T>
    [[nodiscard]] static std::string type_name() {
        if (std::is_same_v<T, std::string>) return "text in quotes";
        return std::is_same_v<T, bool> ? "true or false" : "a whole number";
    }
    /// Words that reach the program as they are.
    void require_ascii(const toml::node& node, const char* key, const std::string& words) const {
        const auto printed = [](char letter) { return letter >= ' ' && letter <= '~'; };
        if (!std::ranges::all_of(words, printed)) refuse(node, key, "one line of ASCII characters");
    }
    [[noreturn]] void refuse(const toml::node& node, const char* key, const std::string& allowed) const {
        std::ostringstream found;
        found << toml::default_formatter(node);
        throw InputError(fmt::format("{}:{}: {}{} must be {}, found {}", file_, node.source().begin.line,
                                     prefix_, key, allowed, found.str()));
    }

    const toml::table& table_;
    std::string_view file_;
    std::string prefix_;
    std::vector<std::string> known_;
};

void read_axes(const toml::table& table, std::string_view name, PostProcessor& post) {
    PostTable axes(table, name, "axes.");
    for (auto& [key, axis] : post.axes) {
        const toml::table* const entry = axes.child(key.c_str());
        if (entry == nullptr) continue;
        PostTable reader(*entry, name, "axes." + key + ".");
        reader.read("letter", axis.letter);
        reader.read("sign", axis.sign);
        const bool linear = key == "x" || key == "y" || key == "z";
        if (linear)
            reader.read_length("offset_mm", units::millimetre, axis.offset);
        else
            reader.read_length("offset_deg", units::degree, axis.offset);
        reader.finish();
    }
    axes.finish();
}

PostProcessor post_of_table(const toml::table& table, std::string_view name, PostProcessor post) {
    PostTable reader(table, name, "");
    reader.read("name", post.name);
    reader.read_choice<LengthUnit>("unit", {{"mm", LengthUnit::millimetre}, {"inch", LengthUnit::inch}},
                                   post.unit);
    reader.read_choice<FeedMode>(
        "feed", {{"inverse_time", FeedMode::inverse_time}, {"per_minute", FeedMode::per_minute}},
        post.feed_mode);
    reader.read("linear_decimals", post.linear_decimals);
    reader.read("angle_decimals", post.angle_decimals);
    reader.read("feed_decimals", post.feed_decimals);
    reader.read("modal", post.modal);
    reader.read("first_block", post.first_block);
    reader.read("block_step", post.block_step);
    reader.read("comment_begin", post.comment_begin);
    reader.read("comment_end", post.comment_end);
    reader.read("header", post.header);
    reader.read("footer", post.footer);
    reader.read("spindle_on", post.spindle_on);
    reader.read("tool_call", post.tool_call);
    if (const toml::table* const axes = reader.child("axes")) read_axes(*axes, name, post);
    reader.finish();
    post.validate();
    return post;
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

PostProcessor post_of_text(std::string_view text, std::string_view name, PostProcessor base) {
    try {
        return post_of_table(toml::parse(text), name, std::move(base));
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
    }
}

PostProcessor read_post(const std::filesystem::path& file, PostProcessor base) {
    const FileBytes read = file_bytes(file);
    if (!read.fault.empty())
        throw InputError(
            fmt::format("cannot read the post-processor file {}: {}", file.string(), read.fault));
    return post_of_text(read.bytes, file.string(), std::move(base));
}

}  // namespace camopt
