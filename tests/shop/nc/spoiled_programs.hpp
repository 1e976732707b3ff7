// SPDX-License-Identifier: MIT
// Programs with one word changed, as a slip of an editor or of a wire would change it.
#pragma once

#include "shop/nc/checked_program.hpp"
#include "tests/support/refusal.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace camopt::test {

struct SpoiledProgram {
    std::string kind, text;
};

/// Why the verifier refuses this text; empty: it does not.
inline std::string refusal_of(const std::string& text, const CheckedProgram& right, const Machine& machine,
                              const PostProcessor& post, const NcWork& work) {
    CheckedProgram spoiled = right;
    spoiled.program.text = text;
    const std::string refused = testing_support::refusal([&] { verify(spoiled, machine, post, work); }, "");
    return refused.empty() ? spoiled.fault() : refused;
}

struct TextLine {
    std::size_t begin = 0, end = 0;
    std::string words;
};

inline std::vector<TextLine> lines_of(const std::string& text) {
    std::vector<TextLine> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back({begin, end, text.substr(begin, end - begin)});
        begin = end + 1;
    }
    return lines;
}

/// The text with one line put in the place of another.
inline std::string with_line(const std::string& text, const TextLine& line, const std::string& words) {
    return text.substr(0, line.begin) + words + text.substr(line.end);
}

/// The words with the number after ` letter` replaced; empty: it has no such word.
inline std::string with_number(const std::string& words, const std::string& letter, double number) {
    const std::size_t place = words.find(" " + letter);
    if (place == std::string::npos) return {};
    const std::size_t begin = place + 1 + letter.size();
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    return words.substr(0, begin) + fmt::format("{:.4f}", number) + words.substr(end);
}

inline double number_of(const std::string& words, const std::string& letter) {
    return std::stod(words.substr(words.find(" " + letter) + 1 + letter.size()));
}

struct Spoiling {
    std::string height_letter = "Z";
    std::vector<double> heights;      ///< printed: where no rapid may be, in the blank and just above it
    std::vector<std::string> across;  ///< letters of the other axes
    double step = 7.0;                ///< what is added to these, printed
};

/// One change in each: every rapid's height, every other word of every rapid, every rapid left out that the
/// following move needs, every plunge and every way out as a rapid.
inline std::vector<SpoiledProgram> spoiled_programs(const std::string& text, const Spoiling& how) {
    std::vector<SpoiledProgram> result;
    const auto add = [&](std::string kind, const TextLine& line, const std::string& words) {
        if (!words.empty())
            result.push_back({kind + ": " + line.words + " -> " + words, with_line(text, line, words)});
    };
    for (const TextLine& line : lines_of(text)) {
        const bool rapid = line.words.find("G0 ") != std::string::npos && line.words[0] != '(';
        if (rapid) {
            for (const double height : how.heights)
                add("height", line, with_number(line.words, how.height_letter, height));
            for (const std::string& letter : how.across)
                if (line.words.find(" " + letter) != std::string::npos)
                    add("across", line,
                        with_number(line.words, letter, number_of(line.words, letter) + how.step));
        }
        const std::size_t feed = line.words.find("G1 " + how.height_letter);
        if (feed != std::string::npos)
            add("rapid for feed", line, line.words.substr(0, feed) + "G0" + line.words.substr(feed + 2));
    }
    return result;
}

}  // namespace camopt::test
