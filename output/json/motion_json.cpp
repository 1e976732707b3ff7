// SPDX-License-Identifier: MIT
#include "output/json/motion_json.hpp"

#include "motions/laws/law.hpp"
#include "splines/curve.hpp"

#include <algorithm>
#include <vector>

namespace camopt {

namespace {

Json curve_json(const SplineCurve& curve) {
    Json pieces = Json::array();
    for (Eigen::Index i = 0; i < curve.pieces().cols(); ++i)
        pieces.push_back(numbers_json(Eigen::VectorXd(curve.pieces().col(i))));
    return {{"degree", curve.degree()},
            {"continuity", curve.continuity()},
            {"breakpoints", numbers_json(curve.breakpoints())},
            {"pieces", std::move(pieces)}};
}

}  // namespace

Json motion_json(const MotionChain& motion) {
    std::vector<const Motion*> written;
    Json curves = Json::array(), parts = Json::array();
    for (const ChainPart& part : motion.parts()) {
        Json curve = nullptr, law = nullptr;
        if (const auto* spline = dynamic_cast<const SplineCurve*>(part.shape.get())) {
            const auto known = std::ranges::find(written, spline);
            curve = known - written.begin();
            if (known == written.end()) {
                curves.push_back(curve_json(*spline));
                written.push_back(spline);
            }
        } else if (const auto* shape = dynamic_cast<const Law*>(part.shape.get())) {
            law = shape->info().key;
        }
        parts.push_back({{"begin", number_json(part.begin)},
                         {"end", number_json(part.end)},
                         {"curve", std::move(curve)},
                         {"law", std::move(law)},
                         {"x0", number_json(part.x0)},
                         {"x_scale", number_json(part.x_scale)},
                         {"y0", number_json(part.y0)},
                         {"y_scale", number_json(part.y_scale)}});
    }
    return {{"curves", std::move(curves)}, {"parts", std::move(parts)}};
}

}  // namespace camopt
