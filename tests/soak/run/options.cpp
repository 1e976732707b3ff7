// SPDX-License-Identifier: MIT
#include "tests/soak/run/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>
#include <string_view>

namespace camopt::soak {

namespace {

template <typename Whole>
Whole whole_of(const std::string& option, const std::string& word) {
    Whole value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size() || word.starts_with('-'))
        throw std::invalid_argument(fmt::format("{}: found \"{}\"; allowed: a whole number", option, word));
    return value;
}

double seconds_of(const std::string& option, const std::string& word) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !(value > 0.0))
        throw std::invalid_argument(fmt::format("{}: found \"{}\"; allowed: seconds above 0", option, word));
    return value;
}

}  // namespace

const char* usage() {
    return "camopt_soak [OPTION VALUE …]: random scenes, each solved, changed and solved again; what must "
           "hold is checked\n"
           "  --motions N              motion scenes (200)\n"
           "  --cams N                 scenes with a disk cam (20)\n"
           "  --seed S                 another series of scenes (1)\n"
           "  --first K                number of the first trial of either kind (0)\n"
           "  --jobs J                 worker processes (1)\n"
           "  --only RELATION          this relation alone\n"
           "  --comparisons N          changed scenes a trial (2)\n"
           "  --seconds-per-motion T   solver.max_seconds of motion scenes (4)\n"
           "  --seconds-per-cam T      solver.max_seconds of cam scenes (2)\n"
           "  --out FOLDER             where scenes of failures are written (out/soak)\n"
           "  --replay FILE            this scene in place of random ones; every relation that fits it\n"
           "  --list                   the relations\n"
           "Exit status: 0 nothing failed, 1 something failed, 2 wrong command line.\n";
}

Options read_options(int count, const char* const* words) {
    Options options;
    using Reader = std::function<void(const std::string&, const std::string&)>;
    const std::map<std::string, Reader, std::less<>> readers = {
        {"--seed", [&](const auto& o, const auto& w) { options.seed = whole_of<std::uint64_t>(o, w); }},
        {"--motions", [&](const auto& o, const auto& w) { options.motions = whole_of<int>(o, w); }},
        {"--cams", [&](const auto& o, const auto& w) { options.cams = whole_of<int>(o, w); }},
        {"--first", [&](const auto& o, const auto& w) { options.first = whole_of<int>(o, w); }},
        {"--jobs", [&](const auto& o, const auto& w) { options.jobs = whole_of<int>(o, w); }},
        {"--comparisons", [&](const auto& o, const auto& w) { options.comparisons = whole_of<int>(o, w); }},
        {"--seconds-per-motion",
         [&](const auto& o, const auto& w) { options.budget.motion_seconds = seconds_of(o, w); }},
        {"--seconds-per-cam",
         [&](const auto& o, const auto& w) { options.budget.cam_seconds = seconds_of(o, w); }},
        {"--only", [&](const auto&, const auto& w) { options.only = w; }},
        {"--out", [&](const auto&, const auto& w) { options.folder = w; }},
        {"--replay", [&](const auto&, const auto& w) { options.replay = w; }},
    };
    for (int k = 1; k < count; ++k) {
        const std::string option = words[k];
        if (option == "--list" || option == "--help") {
            (option == "--list" ? options.list : options.help) = true;
            continue;
        }
        const auto reader = readers.find(option);
        if (reader == readers.end())
            throw std::invalid_argument(fmt::format("found \"{}\"\n{}", option, usage()));
        if (++k == count) throw std::invalid_argument(option + ": a value is missing");
        reader->second(option, words[k]);
    }
    if (options.jobs < 1) throw std::invalid_argument("--jobs: found 0; allowed: 1 or more");
    if (options.folder.empty()) throw std::invalid_argument("--out: found nothing; allowed: a folder");
    return options;
}

}  // namespace camopt::soak
