// SPDX-License-Identifier: MIT
#include "output/chart/reference_motion.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "output/words/number_text.hpp"
#include "studies/compare/law_motion.hpp"

#include <utility>

namespace camopt {

ReferenceMotion reference_motion(const Scene& scene) {
    ReferenceMotion reference;
    if (scene.objective.reference.numeric) return reference;
    std::unique_ptr<Law> law = make_law(scene.objective.reference.law);
    reference.title = words_of(law->key());
    reference.peaks = law->peaks();
    if (scene.motion.type == MotionType::rr) {
        const LawMotion placed = law_motion(strokes_of(scene.motion), false, std::move(law));
        reference.motion = std::make_unique<MotionChain>(*placed.motion);
        reference.peaks = placed.peaks;
    } else if (scene.motion.type == MotionType::drd) {
        reference.motion = std::move(law);
    }
    return reference;
}

}  // namespace camopt
