// SPDX-License-Identifier: MIT
// camopt_soak: metamorphic random trials. docs/stability.md says what they are.
#include "tests/soak/figures/law.hpp"
#include "tests/soak/relations/relation.hpp"
#include "tests/soak/run/progress.hpp"
#include "tests/soak/run/tally.hpp"
#include "tests/soak/run/worker_pool.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace camopt::soak {

namespace {

void print_relations() {
    for (const Check& check : checks()) fmt::print("{:<18}{}\n", check.name, check.says);
    for (const Comparison& comparison : comparisons())
        fmt::print("{:<18}{}\n", comparison.name, comparison.says);
}

bool is_relation(const std::string& name) {
    for (const Check& check : checks())
        if (name == check.name) return true;
    for (const Comparison& comparison : comparisons())
        if (name == comparison.name) return true;
    return false;
}

/// Motions and cams mixed, so that a run that is broken off has seen both.
std::vector<TrialPlan> plans_of(const Options& options) {
    std::vector<TrialPlan> plans;
    int motions = 0;
    int cams = 0;
    while (motions < options.motions || cams < options.cams) {
        const bool cam =
            cams * static_cast<long>(options.motions) < motions * static_cast<long>(options.cams) ||
            motions == options.motions;
        plans.push_back(
            {cam ? Kind::cam : Kind::motion, options.seed, options.first + (cam ? cams : motions), {}});
        ++(cam ? cams : motions);
    }
    return plans;
}

std::string text_of_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::invalid_argument("--replay: cannot read " + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

int run(Options options) {
    std::vector<TrialPlan> plans;
    if (options.replay.empty())
        plans = plans_of(options);
    else
        plans = {replayed_plan(text_of_file(options.replay), options)};
    for (const std::string& law : known_laws())
        static_cast<void>(law_figures(law));  // found once, not in every worker
    Tally tally(options.folder);
    Progress progress(60.0);
    const auto plan_of = [&](int number) -> const TrialPlan& {
        return plans[static_cast<std::size_t>(number)];
    };
    const Worker worker{[&](int number, const std::function<void(const std::string&)>& tell) {
                            run_trial(plan_of(number), options, tell);
                        },
                        [&](int number, const std::string& line) { tally.heard(plan_of(number), line); },
                        [&](int number, const std::string& fault) {
                            tally.ended(plan_of(number), fault);
                            if (progress.is_due())
                                progress.tell(fmt::format("of {}: {}", plans.size(), tally.progress()));
                        }};
    // Solves that keep their time stay far below this, on a loaded machine too.
    const double longest = std::max(options.budget.motion_seconds, options.budget.cam_seconds);
    const auto most_solves = static_cast<double>(options.replay.empty() ? options.comparisons + 4 : 60);
    run_in_processes(static_cast<int>(plans.size()), options.jobs, 120.0 + 6.0 * most_solves * longest,
                     worker);
    fmt::print("{}", tally.table());
    return tally.failures() > 0 ? 1 : 0;
}

}  // namespace

}  // namespace camopt::soak

int main(int count, char** words) {
    using namespace camopt::soak;
    try {
        const Options options = read_options(count, words);
        if (options.help) fmt::print("{}", usage());
        if (options.list) print_relations();
        if (options.help || options.list) return 0;
        if (!options.only.empty() && !is_relation(options.only))
            throw std::invalid_argument("--only: found \"" + options.only + "\"; allowed: those of --list");
        return run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "camopt_soak: {}\n", error.what());
        return 2;
    }
}
