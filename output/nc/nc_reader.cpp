// SPDX-License-Identifier: MIT
#include "output/nc/nc_reader.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace camopt {

namespace {

constexpr double tool_change = 6.0;  // of M

struct Word {
    char letter = ' ';
    double value = 0.0;
};

class Reader {
 public:
    Reader(const Machine& machine, const PostProcessor& post)
        : machine_(machine),
          post_(post),
          values_(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(machine.axes().size()),
                                            std::numeric_limits<double>::quiet_NaN())) {}

    void read_line(std::string_view line) {
        ++line_;
        rapid_.reset();
        feed_.reset();
        named_.assign(machine_.axes().size(), false);
        const std::vector<Word> words = words_of(line);
        for (const Word& word : words)  // modes count for their whole block, wherever they stand in it
            if (word.letter == 'G') take_mode(word.value);
        bool moves = false;
        for (const Word& word : words) moves = take(word) || moves;
        if (rapid_) motion_is_rapid_ = rapid_;
        if (moves) add_move();
    }
    [[nodiscard]] std::vector<NcMove> finish() && { return std::move(moves_); }

 private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError(fmt::format("G-code, line {}: {}", line_, what));
    }

    [[nodiscard]] std::vector<Word> words_of(std::string_view line) const {
        std::vector<Word> words;
        std::size_t place = 0;
        while (place < line.size()) {
            const char letter = line[place];
            if (letter == ' ' || letter == '\t' || letter == '\r' || letter == '%') {
                ++place;
            } else if (letter == ';') {
                break;
            } else if (letter == '(') {
                const std::size_t end = line.find(')', place);
                if (end == std::string_view::npos) refuse("a comment without )");
                place = end + 1;
            } else if (letter >= 'A' && letter <= 'Z') {
                words.push_back({letter, number_at(line, ++place)});
            } else {
                refuse(fmt::format("'{}' is not understood", letter));
            }
        }
        return words;
    }

    [[nodiscard]] double number_at(std::string_view line, std::size_t& place) const {
        if (place < line.size() && line[place] == '+') ++place;
        double value = 0.0;
        const auto [end, error] =
            std::from_chars(line.data() + place, line.data() + line.size(), value, std::chars_format::fixed);
        if (error != std::errc() || !std::isfinite(value))
            refuse(fmt::format("no number after {}", line[place - 1]));
        place = static_cast<std::size_t>(end - line.data());
        return value;
    }

    /// True for a word of an axis.
    bool take(const Word& word) {
        for (std::size_t i = 0; i < machine_.axes().size(); ++i)
            if (post_axis(post_, machine_.axes()[i]).letter[0] == word.letter) {
                set_axis(i, word.value);
                return true;
            }
        if (word.letter == 'F') {
            feed_ = word.value;
        } else if (word.letter == 'M' && word.value == tool_change && !moves_.empty()) {
            refuse("M6 after the first move: where the next tool's tip is would be a guess");
        } else if (std::string_view("GNOSTM").find(word.letter) == std::string_view::npos) {
            refuse(fmt::format("the word {}{} is not understood", word.letter, word.value));
        }
        return false;
    }

    void take_mode(double code) {
        static constexpr std::array harmless{17., 18., 19., 40., 49., 54., 55.,
                                             56., 57., 58., 59., 61., 64., 80.};
        if (code == 0.0 || code == 1.0) {
            if (rapid_ && *rapid_ != (code == 0.0)) refuse("G0 and G1 in one block");
            rapid_ = code == 0.0;
        } else if (!moves_.empty() && (code == 20.0 || code == 21.0 || (code >= 54.0 && code <= 59.0))) {
            refuse(fmt::format("G{} after the first move: the tool would go by other coordinates", code));
        } else if (code == 20.0 || code == 21.0) {
            unit_ = code == 20.0 ? units::inch : units::millimetre;
        } else if (code == 90.0) {
            absolute_ = true;
        } else if (code == 93.0 || code == 94.0) {
            inverse_time_ = code == 93.0;
        } else if (std::find(harmless.begin(), harmless.end(), code) == harmless.end()) {
            refuse(fmt::format("G{} is not understood: where the tool goes would be a guess", code));
        }
    }

    void set_axis(std::size_t index, double printed) {
        const MachineAxis& axis = machine_.axes()[index];
        const PostAxis& post = post_axis(post_, axis);
        if (axis.kind == AxisKind::linear && !unit_) refuse("a length before G20 or G21");
        if (!absolute_) refuse("an axis moves before G90");
        if (named_[index]) refuse(fmt::format("{} twice in one block", post.letter));
        named_[index] = true;
        const double value = printed * (axis.kind == AxisKind::linear ? *unit_ : units::degree);
        values_(static_cast<Eigen::Index>(index)) = post.sign * (value - post.offset);
    }

    void add_move() {
        if (!motion_is_rapid_) refuse("an axis moves before G0 or G1");
        NcMove move{line_, *motion_is_rapid_, values_, 0.0};
        if (!move.rapid) {
            if (!values_.allFinite()) refuse("G1 while an axis has no value yet");
            if (feed_ && !(*feed_ > 0.0)) refuse("F must be > 0");
            if (inverse_time_ && !feed_) refuse("a block under G93 needs an F of its own");
            if (!inverse_time_ && !feed_ && !feed_known_) refuse("G1 without a feed");
            if (!inverse_time_) feed_known_ = true;
            if (inverse_time_) move.seconds = 60.0 / *feed_;
        }
        moves_.push_back(std::move(move));
    }

    const Machine& machine_;
    const PostProcessor& post_;
    std::vector<NcMove> moves_;
    Eigen::VectorXd values_;
    std::optional<double> unit_, feed_;
    std::optional<bool> rapid_, motion_is_rapid_;
    std::vector<bool> named_;  // axes of this block
    bool absolute_ = false, inverse_time_ = false, feed_known_ = false;
    int line_ = 0;
};

}  // namespace

std::vector<NcMove> read_nc_travel(std::string_view text, const Machine& machine, const PostProcessor& post) {
    post.validate();
    Reader reader(machine, post);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(reader).finish();
}

std::vector<NcMove> read_nc_text(std::string_view text, const Machine& machine, const PostProcessor& post) {
    std::vector<NcMove> moves = read_nc_travel(text, machine, post);
    std::erase_if(moves, [](const NcMove& move) { return !move.values.allFinite(); });
    return moves;
}

}  // namespace camopt
