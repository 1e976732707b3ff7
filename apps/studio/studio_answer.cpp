// SPDX-License-Identifier: MIT
#include "apps/studio/studio_answer.hpp"

#include "apps/studio/studio_controls.hpp"
#include "output/page/page_data.hpp"
#include "output/page/page_laws.hpp"

#include <cmath>

namespace camopt::apps {

namespace {

const char* name_of_stage(AnswerStage stage) {
    switch (stage) {
        case AnswerStage::curve:
            return "curve";
        case AnswerStage::proof:
            return "proof";
        case AnswerStage::rest:
            break;
    }
    return "rest";
}

/// A law to compare with, or a scene without a motion that may be explained.
bool has_rest(const Solution& solution) {
    return !solution.motion || solution.certificate.verdict == Verdict::infeasible ||
           !solution.scene.objective.reference.numeric;
}

}  // namespace

std::string studio_answer(const Solution& solution, const std::string& text, const AnswerWishes& wishes) {
    using Json = nlohmann::ordered_json;
    const double objective = solution.certificate.objective;
    const Json own = {{"verdict", name_of(solution.certificate.verdict)},
                      {"objective", std::isfinite(objective) ? Json(objective) : Json(nullptr)},
                      {"seconds", solution.seconds_total},
                      {"stage", name_of_stage(wishes.stage)},
                      {"more", wishes.stage == AnswerStage::proof && has_rest(solution)},
                      {"scene", text},
                      {"controls", studio_controls(text)}};
    // Texts of JSON side by side: the curves need not be read to be sent on.
    std::string answer = own.dump(-1, ' ', false, Json::error_handler_t::replace);
    answer.back() = ',';
    answer += "\"laws\":" + page_laws(solution, wishes.laws) + ",\"data\":";
    answer += page_data(
        solution, {.scene_file = "scene.toml", .command = "camopt solve scene.toml", .scene_text = text},
        {.reference = wishes.stage == AnswerStage::rest ? PageReference::compared : PageReference::later,
         .proof = wishes.stage != AnswerStage::curve});
    return answer + "}";
}

}  // namespace camopt::apps
