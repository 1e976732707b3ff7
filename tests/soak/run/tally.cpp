// SPDX-License-Identifier: MIT
#include "tests/soak/run/tally.hpp"

#include "tests/soak/relations/relation.hpp"
#include "tests/soak/run/message.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace camopt::soak {

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

/// Into the comments at the head of a scene.
std::string remarked(const std::string& what) {
    std::string remark = "# ";
    for (const char letter : what) {
        remark += letter;
        if (letter == '\n') remark += "# ";
    }
    return remark + "\n";
}

}  // namespace

void Tally::heard(const TrialPlan& plan, const std::string& line) {
    const std::vector<std::string> fields = message_fields(line);
    const std::string& kind = fields.front();
    if (kind == "at" && fields.size() == 3) {
        last_[plan.name()] = fields;
    } else if (kind == "held" && fields.size() == 2) {
        ++rows_[fields[1]].trials;
    } else if (kind == "broken" && fields.size() == 5) {
        fail(plan, fields);
    } else if (kind == "solved" && fields.size() == 3) {
        ++solves_;
        ++verdicts_[fields[1]];
        seconds_ += std::atof(fields[2].c_str());
    }
}

void Tally::fail(const TrialPlan& plan, const std::vector<std::string>& fields) {
    const std::string& relation = fields[1];
    Row& row = rows_[relation];
    ++row.trials;
    ++row.failures;
    const auto stem = folder_ / relation / fmt::format("{}_{}", plan.name(), row.failures);
    const std::string file = stem.string() + ".toml";
    write(file, remarked(fields[2]) + fields[3]);
    if (!fields[4].empty()) write(stem.string() + ".changed.toml", fields[4]);
    fmt::print("{} {}: {}\n    {}\n", relation, plan.name(), fields[2], file);
    std::fflush(stdout);
}

void Tally::ended(const TrialPlan& plan, const std::string& fault) {
    ++trials_;
    const std::vector<std::string> last = last_[plan.name()];
    last_.erase(plan.name());
    if (fault.empty()) {
        ++rows_["survived"].trials;
        return;
    }
    const std::string at = last.empty() ? "scene" : last[1];
    fail(plan, {"broken", "survived", fmt::format("{} at {}", fault, at), last.empty() ? "" : last[2], ""});
}

int Tally::failures() const {
    int sum = 0;
    for (const auto& [name, row] : rows_) sum += row.failures;
    return sum;
}

std::string Tally::progress() const {
    return fmt::format("{} trials, {} solves, {:.0f} s in them, {} failures", trials_, solves_, seconds_,
                       failures());
}

std::string Tally::table() const {
    std::string text = fmt::format("{:<18}{:>9}{:>10}  what must hold\n", "relation", "trials", "failures");
    const auto add = [&](const char* name, const char* says) {
        const auto row = rows_.find(name);
        if (row != rows_.end())
            text +=
                fmt::format("{:<18}{:>9}{:>10}  {}\n", name, row->second.trials, row->second.failures, says);
    };
    add("survived", "the trial ends, and ends in time");
    for (const Check& check : checks()) add(check.name, check.says);
    for (const Comparison& comparison : comparisons()) add(comparison.name, comparison.says);
    text += "verdicts:";
    for (const auto& [verdict, count] : verdicts_) text += fmt::format(" {} {}", verdict, count);
    return text + "\n" + progress() + "\n";
}

}  // namespace camopt::soak
