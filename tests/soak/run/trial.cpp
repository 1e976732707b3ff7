// SPDX-License-Identifier: MIT
#include "tests/soak/run/trial.hpp"

#include "tests/soak/relations/relation.hpp"
#include "tests/soak/run/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <numeric>

namespace camopt::soak {

namespace {

using Tell = std::function<void(const std::string&)>;

/// FNV-1a: a draw of its own for each relation, whatever others draw.
std::uint64_t number_of(std::string_view name) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
    return hash;
}

class RunningTrial : public Trial {
 public:
    RunningTrial(const TrialPlan& plan, const Options& options, Tell tell)
        : plan_(plan), options_(options), tell_(std::move(tell)), draw_(0) {}

    void run() {
        Draw draw(plan_.seed + (plan_.kind == Kind::cam ? 0x5eedULL << 32 : 0), plan_.number);
        relation_ = "scene";
        base_.text = !plan_.scene.empty()         ? SceneText::parse(plan_.scene)
                     : plan_.kind == Kind::motion ? drawn_motion_scene(draw, options_.budget)
                                                  : drawn_cam_scene(draw, options_.budget);
        base_.text.remarks.clear();
        base_ = solve(base_.text);
        if (!base_.outcome.refusal.empty()) return;
        compare(draw);
    }

    [[nodiscard]] const Solved& base() const override { return base_; }
    Draw& draw() override { return draw_; }
    Solved solve(const SceneText& scene) override {
        tell_(message_line({"at", relation_, remarked(scene, relation_)}));
        Solved solved = solved_from(scene);
        ++solves_;
        other_ = scene.text();
        const std::string verdict = solved.outcome.refusal.empty() ? solved.outcome.verdict : "refused";
        tell_(message_line({"solved", verdict, fmt::format("{:.3f}", solved.outcome.processor_seconds)}));
        for (const Check& check : checks()) {
            if (!wanted(check.name) || (!solved.outcome.refusal.empty() && check.of != check_accepted))
                continue;
            report(check.name, caught([&] { return check.of(solved); }), remarked(scene, check.name), "");
        }
        return solved;
    }

 private:
    void compare(Draw& draw) {
        std::vector<std::size_t> order(comparisons().size());
        std::iota(order.begin(), order.end(), 0U);
        for (std::size_t k = order.size(); k > 1; --k)
            std::swap(order[k - 1], order[static_cast<std::size_t>(draw.whole(0, static_cast<int>(k) - 1))]);
        // What infeasible scenes are offered is rare: first.
        std::stable_partition(order.begin(), order.end(), [](std::size_t k) {
            return std::string_view(comparisons()[k].name) == "relaxed";
        });
        const bool all = !plan_.scene.empty() || !options_.only.empty();
        const int most = 1 + options_.comparisons;
        for (const std::size_t k : order) {
            if (!all && solves_ >= most) break;
            const Comparison& comparison = comparisons()[k];
            if (!wanted(comparison.name)) continue;
            relation_ = comparison.name;
            draw_ = Draw(plan_.seed ^ number_of(comparison.name), plan_.number);
            other_.clear();
            const Finding finding = caught([&] { return comparison.of(*this); });
            report(comparison.name, finding, remarked(base_.text, comparison.name), other_);
        }
    }

    [[nodiscard]] bool wanted(const std::string& relation) const {
        return options_.only.empty() || options_.only == relation;
    }

    template <typename Work>
    static Finding caught(const Work& work) {
        try {
            return work();
        } catch (const std::exception& error) {
            return fmt::format("the check itself failed: {}", error.what());
        }
    }

    void report(const std::string& relation, const Finding& finding, const std::string& scene,
                const std::string& other) const {
        if (!finding) return;
        if (finding->empty())
            tell_(message_line({"held", relation}));
        else
            tell_(message_line({"broken", relation, *finding, scene, other}));
    }

    [[nodiscard]] std::string remarked(SceneText scene, const std::string& relation) const {
        scene.remarks = {
            fmt::format("soak relation={} seed={} trial={}", relation, plan_.seed, plan_.number)};
        return scene.text();
    }

    const TrialPlan& plan_;
    const Options& options_;
    Tell tell_;
    Draw draw_;
    Solved base_;
    std::string relation_, other_;
    int solves_ = 0;
};

}  // namespace

Solved solved_from(const SceneText& text, Scope scope) {
    Solved solved;
    solved.text = text;
    solved.numbers = numbers_of(text);
    solved.outcome = solve_text(text.text(), scope);
    for (const auto& [name, millimetres] : solved.outcome.dimensions)
        if (name.ends_with("_mm")) solved.dimensions[name.substr(0, name.size() - 3)] = 1e-3 * millimetres;
    if (solved.outcome.has_motion()) read_motion(solved);
    return solved;
}

void read_motion(Solved& solved) {
    solved.motion = delivered_motion(solved.numbers, solved.outcome);
    solved.figures = figures_of(*solved.motion);
    if (solved.numbers.train) solved.figures.train = train_figures(solved.numbers, *solved.motion);
}

std::string TrialPlan::name() const {
    return fmt::format("{}_{}_{}", kind == Kind::motion ? "motion" : "cam", seed, number);
}

void run_trial(const TrialPlan& plan, const Options& options, const Tell& tell) {
    RunningTrial(plan, options, tell).run();
}

TrialPlan replayed_plan(const std::string& scene, Options& options) {
    TrialPlan plan;
    const SceneText text = SceneText::parse(scene);
    plan.scene = scene;
    plan.seed = options.seed;
    plan.kind = text.has("cam") ? Kind::cam : Kind::motion;
    for (const std::string& remark : text.remarks) {
        const auto value_of = [&](const std::string& name) -> std::string {
            const auto at = remark.find(name + "=");
            if (at == std::string::npos) return "";
            const auto begin = at + name.size() + 1;
            return remark.substr(begin, remark.find(' ', begin) - begin);
        };
        if (!remark.starts_with("soak ")) continue;
        plan.seed = std::strtoull(value_of("seed").c_str(), nullptr, 10);
        plan.number = std::atoi(value_of("trial").c_str());
        const std::string relation = value_of("relation");
        if (options.only.empty() && relation != "scene") options.only = relation;
    }
    return plan;
}

}  // namespace camopt::soak
