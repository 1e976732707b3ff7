// SPDX-License-Identifier: MIT
#include "tests/soak/known/known_scene.hpp"

#include "tests/soak/known/known_machine.hpp"
#include "tests/soak/known/moved_scene.hpp"
#include "tests/soak/known/posing.hpp"

namespace camopt::soak {

namespace {

std::optional<KnownScene> drawn_once(Draw& draw, int kind, const Question& question, bool edges) {
    Posing posing(draw, drawn_draft(draw, kind, edges), edges);
    if (!posing.draw_rows(question.feasible)) return {};
    Balance balance;
    posing.add_to(balance);
    if (!balance.find(question.feasible)) return {};
    posing.choose();
    const Posing* const posings[] = {&posing};
    const auto tighten = [&](const ActiveRow& row, double by) { return posing.tighten(row, by); };
    const std::optional<KnownAnswer> answer = answer_of(draw, question, balance, posings, tighten);
    if (!answer) return {};
    const std::string text = posing.written().text();
    return KnownScene{posing.draft().kind, posing.draft().change, text, {}, *answer};
}

}  // namespace

KnownScene drawn_known_scene(const KnownSettings& settings, long number) {
    // Kinds in turn.
    const int kind = settings.kind >= 0 ? settings.kind : static_cast<int>(number % known_kinds);
    const std::uint64_t seed = settings.seed * 1000003ULL + (settings.edges ? 500009ULL : 0ULL),
                        trial = static_cast<std::uint64_t>(number) * known_kinds +
                                static_cast<std::uint64_t>(kind);
    // Four scenes with a motion to one without.
    const bool feasible = Draw(~seed, trial).chance(settings.edges ? 0.6 : 0.8);
    constexpr std::uint64_t attempts = 400;
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
        Draw draw(seed + attempt, trial);
        // Draws that seldom have an optimum have a contradiction at last.
        const Question question = drawn_question(draw, feasible && attempt < attempts / 2, settings.edges);
        std::optional<KnownScene> scene = kind == machine_kind
                                              ? drawn_machine(draw, question, settings.edges)
                                              : drawn_once(draw, kind, question, settings.edges);
        if (!scene) continue;
        if (settings.edges && scene->answer.margin == 0.0) move_scene(draw, *scene);
        return std::move(*scene);
    }
    return {};
}

}  // namespace camopt::soak
