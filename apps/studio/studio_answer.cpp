// SPDX-License-Identifier: MIT
#include "apps/studio/studio_answer.hpp"

#include "apps/studio/studio_controls.hpp"
#include "core/errors.hpp"
#include "output/json/json_text.hpp"
#include "output/json/result_json.hpp"

namespace camopt::apps {

Json studio_answer(const Solution& solution, const std::string& text, std::span<const std::string>) {
    return {{"scene", text},
            {"controls", studio_controls(text)},
            {"result", Json::parse(result_json(solution, {"scene.toml", "", text}))}};
}

}  // namespace camopt::apps
