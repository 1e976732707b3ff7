// SPDX-License-Identifier: MIT
// camopt_known: random scenes whose answer is known before they are solved. docs/trials.md says what they
// are.
#include "tests/soak/figures/law.hpp"
#include "tests/soak/known/draft.hpp"
#include "tests/soak/known/scene_files.hpp"
#include "tests/soak/known/tally.hpp"
#include "tests/soak/run/progress.hpp"

#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace camopt::soak {

namespace {

std::atomic<bool> interrupted{false};

constexpr double slow = 1.0;  // s

struct Options {
    KnownSettings settings;
    long first = 0, scenes = 1000;
    double minutes = 1e9;
    int threads = 2;
    std::string state, folder = "out/known";
    bool print = false, help = false;
};

constexpr const char* usage =
    "camopt_known [OPTION VALUE …]: random scenes whose answer is known before they are solved\n"
    "  --scenes N       so many scenes from the first on (1000)\n"
    "  --minutes M      ends after M minutes\n"
    "  --seed S         another series of scenes (1)\n"
    "  --first K        number of the first scene (0)\n"
    "  --class NAME     scenes of one class alone; --list prints them\n"
    "  --edges          scenes at the edge: numbers moved by round-off, near impossible, extreme units\n"
    "  --threads T      (2)\n"
    "  --state FILE     goes on with the first scene that this file does not count, and adds to it\n"
    "  --out FOLDER     where scenes that failed, or took longer than a second, are written (out/known)\n"
    "  --print          prints scene --first and its answer, a machine with its axes; solves nothing\n"
    "Ctrl-C: what is finished is counted. Exit status: 0 none wrong, 1 some are, 2 wrong command line.\n";

template <typename Number>
Number number_of(const std::string& option, const std::string& word) {
    Number value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size() || value < 0)
        throw std::invalid_argument(
            fmt::format("{}: found \"{}\"; allowed: a number from 0 on", option, word));
    return value;
}

int kind_named(const std::string& name) {
    for (int kind = 0; kind < known_kinds; ++kind)
        if (name == known_kind_name(kind)) return kind;
    throw std::invalid_argument(fmt::format("--class: found \"{}\"; allowed: those of --list", name));
}

Options read_options(int count, char** words) {
    Options options;
    for (int k = 1; k < count; ++k) {
        const std::string option = words[k];
        if (option == "--help") options.help = true;
        if (option == "--edges") options.settings.edges = true;
        if (option == "--print") options.print = true;
        if (option == "--list")
            for (int kind = 0; kind < known_kinds; ++kind) fmt::print("{}\n", known_kind_name(kind));
        if (option == "--list") options.help = true;
        if (option == "--help" || option == "--edges" || option == "--print" || option == "--list") continue;
        if (k + 1 == count) throw std::invalid_argument(option + ": a value is missing, or it is no option");
        const std::string word = words[++k];
        if (option == "--scenes")
            options.scenes = number_of<long>(option, word);
        else if (option == "--minutes")
            options.minutes = number_of<double>(option, word);
        else if (option == "--seed")
            options.settings.seed = static_cast<std::uint64_t>(number_of<long>(option, word));
        else if (option == "--first")
            options.first = number_of<long>(option, word);
        else if (option == "--threads")
            options.threads = std::max(1, number_of<int>(option, word));
        else if (option == "--class")
            options.settings.kind = kind_named(word);
        else if (option == "--state")
            options.state = word;
        else if (option == "--out")
            options.folder = word;
        else
            throw std::invalid_argument(fmt::format("found \"{}\"\n{}", option, usage));
    }
    return options;
}

/// The answer as remarks above the scene.
std::string answer_text(const KnownScene& scene) {
    const KnownAnswer& answer = scene.answer;
    std::string text =
        fmt::format("# class: {}{}{}\n", scene.kind, scene.change.empty() ? "" : ", ", scene.change);
    if (answer.margin == 0.0)
        text += fmt::format("# known optimum: {:.17g} ± {:.1e}; condition {:.1e}\n", answer.objective,
                            answer.error, answer.condition);
    else
        text += fmt::format("# known: {} by {:.2e} of the sizes of its rows; condition {:.1e}\n",
                            answer.feasible ? "feasible" : "infeasible", answer.margin, answer.condition);
    return text;
}

void print(const KnownScene& scene) {
    fmt::print("{}{}", answer_text(scene), scene.text);
    for (const AxisFile& axis : scene.axes) fmt::print("\n# {}\n{}", axis.name, axis.text);
}

class Trials {
 public:
    explicit Trials(Options options) : options_(std::move(options)), tally_(options_.state) {
        // A state goes on where it ended; without one the numbers are counted from --first.
        first_ = options_.first + tally_.next();
        next_ = first_;
    }

    int run() {
        std::vector<std::thread> threads;
        for (int k = 0; k < options_.threads; ++k) threads.emplace_back([this] { work(); });
        for (std::thread& thread : threads) thread.join();
        tally_.save();
        progress_.end();
        fmt::print("{}", tally_.table());
        return tally_.count(Judgement::wrong) > 0 ? 1 : 0;
    }

 private:
    using Clock = std::chrono::steady_clock;

    void work() {
        for (;;) {
            const long number = next_++;
            const double minutes = std::chrono::duration<double>(Clock::now() - begin_).count() / 60.0;
            if (interrupted || number >= first_ + options_.scenes || minutes > options_.minutes) return;
            const KnownScene scene = drawn_known_scene(options_.settings, number);
            const Judged found = judged(scene);
            const std::scoped_lock lock(mutex_);
            tally_.add(number - options_.first, scene, found);
            if (found.judgement != Judgement::right) keep(number, scene, found, name_of(found.judgement));
            if (found.seconds > slow) keep(number, scene, found, "slow");
            tell();
        }
    }

    void keep(long number, const KnownScene& scene, const Judged& found, const char* why_kept) const {
        const std::filesystem::path folder = std::filesystem::path(options_.folder) / why_kept;
        const std::string name =
            fmt::format("{}{}_{}{}", options_.settings.edges ? "edge_" : "", options_.settings.seed, number,
                        options_.settings.kind < 0 ? "" : fmt::format("_{}", options_.settings.kind));
        const std::string why =
            fmt::format("# {} ({:.2f} s)\n", found.why.substr(0, found.why.find('\n')), found.seconds);
        const std::filesystem::path file = write_scene(scene, folder, name, why + answer_text(scene));
        if (found.judgement == Judgement::wrong || found.judgement == Judgement::refused)
            fmt::print("{} {} ({}): {}\n    {}\n", name_of(found.judgement), number, scene.kind, found.why,
                       file.string());
        std::fflush(stdout);
    }

    void tell() {
        if (!progress_.is_due()) return;
        tally_.save();
        const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
        const long done = tally_.next() - (first_ - options_.first);
        progress_.tell(fmt::format("{} scenes, {:.1f} a second: {} right, {} open, {} wrong, {} refused",
                                   tally_.scenes(), static_cast<double>(done) / seconds,
                                   tally_.count(Judgement::right), tally_.count(Judgement::open),
                                   tally_.count(Judgement::wrong), tally_.count(Judgement::refused)));
    }

    Options options_;
    KnownTally tally_;
    long first_ = 0;
    std::atomic<long> next_{0};
    std::mutex mutex_;
    Clock::time_point begin_ = Clock::now();
    Progress progress_{30.0};
};

}  // namespace

}  // namespace camopt::soak

int main(int count, char** words) {
    using namespace camopt::soak;
    try {
        const Options options = read_options(count, words);
        if (options.help) fmt::print("{}", usage);
        if (options.help) return 0;
        for (const std::string& law : known_laws())
            static_cast<void>(law_figures(law));  // found once, not by every thread
        if (options.print) {
            print(drawn_known_scene(options.settings, options.first));
            return 0;
        }
        std::signal(SIGINT, [](int) { interrupted = true; });
        std::signal(SIGTERM, [](int) { interrupted = true; });
        return Trials(options).run();
    } catch (const std::exception& error) {
        fmt::print(stderr, "camopt_known: {}\n", error.what());
        return 2;
    }
}
