// SPDX-License-Identifier: MIT
#include "apps/studio/studio_answer.hpp"

#include "apps/studio/studio_controls.hpp"
#include "output/page/page_data.hpp"
#include "output/page/page_laws.hpp"

#include <cmath>

namespace camopt::apps {

std::string studio_answer(const Solution& solution, const std::string& text, const AnswerWishes& wishes) {
    using Json = nlohmann::ordered_json;
    const double objective = solution.certificate.objective;
    const Json own = {{"verdict", name_of(solution.certificate.verdict)},
                      {"objective", std::isfinite(objective) ? Json(objective) : Json(nullptr)},
                      {"seconds", solution.seconds_total},
                      {"scene", text},
                      {"controls", studio_controls(text)}};
    // Texts of JSON side by side: the curves need not be read to be sent on.
    std::string answer = own.dump(-1, ' ', false, Json::error_handler_t::replace);
    answer.back() = ',';
    answer += "\"laws\":" + page_laws(solution, wishes.laws) + ",\"data\":";
    answer += page_data(
        solution, {.scene_file = "scene.toml", .command = "camopt solve scene.toml", .scene_text = text},
        {.reference = !wishes.quick});
    return answer + "}";
}

}  // namespace camopt::apps
