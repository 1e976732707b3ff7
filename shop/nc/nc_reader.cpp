// SPDX-License-Identifier: MIT
#include "shop/nc/nc_reader.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <charconv>

namespace camopt {

namespace {

constexpr double tool_change = 6.0, spindle_clockwise = 3.0, spindle_counterclockwise = 4.0;  // of M
// The radii at both ends of an arc: what rounding of X, Y, I and J makes them differ, in last digits.
constexpr double arc_rounding = 4.0;

enum class Interpolation { rapid, line, clockwise, counterclockwise };

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
        motion_word_.reset();
        feed_.reset();
        from_ = values_;
        center_ = {std::nullopt, std::nullopt};
        tool_offset_ = false;
        named_.assign(machine_.axes().size(), false);
        const std::vector<Word> words = words_of(line);
        for (const Word& word : words)  // modes count for their whole block, wherever they stand in it
            if (word.letter == 'G') take_mode(word.value);
        bool moves = false;
        for (const Word& word : words) moves = take(word) || moves;
        if (motion_word_) motion_ = motion_word_;
        check_compensation(words);
        if (moves) add_move();
    }
    [[nodiscard]] std::vector<NcMove> finish() && { return std::move(moves_); }
    [[nodiscard]] NcWords words() const { return words_; }

 private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw InputError(fmt::format("G-code, line {}: {}", line_, what));
    }

    [[nodiscard]] std::vector<Word> words_of(std::string_view line) const {
        const auto foreign = [](char letter) {
            return letter != '\t' && letter != '\r' && (letter < ' ' || letter > '~');
        };
        if (std::ranges::any_of(line, foreign)) refuse("a character that is not ASCII");
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
                refuse(fmt::format("'{}' is not supported", letter));
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
        } else if (word.letter == 'M') {
            take_machine_word(word.value);
        } else if (word.letter == 'S') {
            words_.spindle_rpm = word.value;
        } else if (word.letter == 'D') {
            tool_offset_ = true;
        } else if (word.letter == 'I' || word.letter == 'J') {
            if (!unit_) refuse("a length before G20 or G21");
            center_[word.letter == 'I' ? 0 : 1] = word.value * *unit_;
        } else if (std::string_view("GNOSTM").find(word.letter) == std::string_view::npos) {
            refuse(fmt::format("the word {}{} is not supported", word.letter, word.value));
        }
        return false;
    }

    void take_machine_word(double code) {
        if (code == tool_change) {
            if (!moves_.empty())
                refuse("M6 after the first move: the position of the next tool's tip is unknown");
            words_.tool_call = true;
        }
        if (code == spindle_clockwise) words_.clockwise = true;
        if (code == spindle_counterclockwise) words_.counterclockwise = true;
        if (words_.clockwise && words_.counterclockwise) refuse("M3 and M4 in one program");
    }

    void take_mode(double code) {
        static constexpr std::array harmless{49., 54., 55., 56., 57., 58., 59., 61., 64., 80.};
        if (code == 0.0 || code == 1.0 || code == 2.0 || code == 3.0) {
            const auto motion = static_cast<Interpolation>(static_cast<int>(code));
            if (motion_word_ && *motion_word_ != motion) refuse("two of G0, G1, G2, G3 in one block");
            motion_word_ = motion;
        } else if (code == 17.0 || code == 18.0 || code == 19.0) {
            plane_is_xy_ = code == 17.0;
        } else if (code == 40.0 || code == 41.0 || code == 42.0) {
            compensation_ = code == 40.0 ? 0 : code == 41.0 ? 1 : -1;
            compensation_named_ = code != 40.0;
        } else if (!moves_.empty() && (code == 20.0 || code == 21.0 || (code >= 54.0 && code <= 59.0))) {
            refuse(fmt::format("G{} after the first move: the tool would go by other coordinates", code));
        } else if (code == 20.0 || code == 21.0) {
            unit_ = code == 20.0 ? units::inch : units::millimetre;
        } else if (code == 90.0) {
            absolute_ = true;
        } else if (code == 93.0 || code == 94.0) {
            inverse_time_ = code == 93.0;
        } else if (std::find(harmless.begin(), harmless.end(), code) == harmless.end()) {
            refuse(fmt::format("G{} is not understood: the path of the tool is unknown", code));
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

    /// −1 where the printed plane is the mirror image of the machine's.
    [[nodiscard]] int mirror() const {
        return post_axis(post_, machine_.axes()[0]).sign * post_axis(post_, machine_.axes()[1]).sign;
    }
    void require_plane(const char* what) const {
        const bool named = post_axis(post_, machine_.axes()[0]).letter == "X" &&
                           post_axis(post_, machine_.axes()[1]).letter == "Y";
        if (!plane_is_xy_ || !named || machine_.axes().size() != 3)
            refuse(fmt::format("{} is supported after G17, on three axes X Y Z", what));
    }
    void check_compensation(const std::vector<Word>& words) {
        if (!std::exchange(compensation_named_, false)) {
            if (tool_offset_) refuse("D without G41 or G42");
            return;
        }
        require_plane("G41, G42");
        const bool once = std::ranges::count(words, 'D', &Word::letter) == 1;
        if (!once) refuse("G41 and G42 need one D in their block");
    }

    [[nodiscard]] MoveArc arc() const {
        require_plane("G2, G3");
        if (!center_[0] || !center_[1]) refuse("G2 and G3 need I and J");
        if (!from_.allFinite()) refuse("an arc while an axis has no value yet");
        const Eigen::Vector2d offset(post_axis(post_, machine_.axes()[0]).sign * *center_[0],
                                     post_axis(post_, machine_.axes()[1]).sign * *center_[1]);
        const Eigen::Vector2d center = from_.head<2>() + offset;
        const double differ = std::abs(offset.norm() - (values_.head<2>() - center).norm());
        if (differ > 2.0 * arc_rounding * half_last_digit(post_, AxisKind::linear))
            refuse(fmt::format("the ends of the arc have different distances from its centre: {:.3g} mm",
                               differ / units::millimetre));
        return {center, (*motion_ == Interpolation::clockwise) == (mirror() > 0)};
    }

    void add_move() {
        if (!motion_) refuse("an axis moves before G0 or G1");
        NcMove move{line_, *motion_ == Interpolation::rapid, values_, 0.0};
        const bool round =
            *motion_ == Interpolation::clockwise || *motion_ == Interpolation::counterclockwise;
        if (round) move.arc = arc();
        if (!round && (center_[0] || center_[1])) refuse("I and J without G2 or G3");
        if (move.rapid && compensation_ != 0) refuse("a rapid under G41 or G42 is not supported");
        move.compensation = static_cast<CompensationSide>(compensation_ * mirror());
        if (!move.rapid) {
            if (!values_.allFinite()) refuse("G1 while an axis has no value yet");
            if (feed_ && !(*feed_ > 0.0)) refuse("F must be > 0");
            if (inverse_time_ && !feed_) refuse("a block under G93 needs its own F");
            if (!inverse_time_ && !feed_ && !feed_known_) refuse("G1 without a feed");
            if (!inverse_time_) feed_known_ = true;
            if (inverse_time_) move.seconds = units::minute / *feed_;
        }
        moves_.push_back(std::move(move));
    }

    const Machine& machine_;
    const PostProcessor& post_;
    std::vector<NcMove> moves_;
    NcWords words_;
    Eigen::VectorXd values_, from_;
    std::optional<double> unit_, feed_;
    std::optional<Interpolation> motion_word_, motion_;
    std::array<std::optional<double>, 2> center_;  // I, J
    int compensation_ = 0;                         // as printed: 1 is left of the path
    bool compensation_named_ = false, tool_offset_ = false, plane_is_xy_ = false;
    std::vector<bool> named_;  // axes of this block
    bool absolute_ = false, inverse_time_ = false, feed_known_ = false;
    int line_ = 0;
};

Reader reader_of(std::string_view text, const Machine& machine, const PostProcessor& post) {
    post.validate();
    Reader reader(machine, post);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader;
}

}  // namespace

NcWords read_nc_words(std::string_view text, const Machine& machine, const PostProcessor& post) {
    return reader_of(text, machine, post).words();
}

std::vector<NcMove> read_nc_travel(std::string_view text, const Machine& machine, const PostProcessor& post) {
    return reader_of(text, machine, post).finish();
}

}  // namespace camopt
