// SPDX-License-Identifier: MIT
// Where made cams lie beside the drawn one, in every curve of the motion and of the cam. To either side the
// sum of what each tolerance alone moves the curve by: of second order in the tolerances beside the worst of
// all cams, which the limits are held against.
#include "objectives/rules/made_cams.hpp"
#include "report/view/view.hpp"

namespace camopt {

namespace {

/// The curves of the cam with one error at one end of its tolerance.
std::vector<Curve> moved_curves(const View& view, const Scene& scene, const CamVariables& made) {
    Solution solution = view.solution;
    solution.scene = scene;
    solution.cam->cam = made.cam;
    const CamPoints points(made.cam, view.delivered.cam->motion(), made.scale);
    const LoadsAt loads = delivered_loads(solution);
    View moved = view;
    for (DeliveredRow& row : moved.delivered.rows) {
        double unit = made.scale.lift;
        for (std::size_t order = 0; order < made.motion_error.size(); ++order, unit /= made.scale.unit_angle)
            row.motion.derivative[order] += made.motion_error[order] / unit;
        for (std::size_t station = 0; station < row.cam.size(); ++station)
            row.cam[station] = mechanism_point(made.cam, row.motion, made.scale, static_cast<int>(station));
        if (loads) row.loads = loads(row.motion, points);
    }
    return cam_curves(moved);
}

void widen(CurveBand& band, const std::vector<double>& drawn,
           const std::array<std::vector<double>, 2>& ends) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const auto [least, most] = std::minmax(ends[0][i], ends[1][i]);
        band.low[i] += std::min(0.0, least - drawn[i]);
        band.high[i] += std::max(0.0, most - drawn[i]);
        if (std::isfinite(ends[0][i]) && std::isfinite(ends[1][i])) continue;
        band.low[i] = band.high[i] = std::nan("");
    }
}

void add_band(Curve& curve, double half) {
    curve.band.emplace();
    for (const double value : curve.values) {
        curve.band->low.push_back(value - half);
        curve.band->high.push_back(value + half);
    }
}

void add_cam_bands(View& view, std::span<Curve*> curves) {
    const ToleranceSpec& tolerance = *view.solution.scene.tolerance;
    CamVariables drawn;
    drawn.cam = view.solution.cam->cam;
    drawn.scale = view.delivered.scale;
    for (Curve* curve : curves) add_band(*curve, 0.0);
    for (std::size_t k = 0; k < tolerance.motion.size() + tolerance.numbers.size(); ++k) {
        std::array<std::vector<Curve>, 2> ends;
        for (const std::size_t end : {0U, 1U}) {
            MadeParts parts;
            parts.numbers.assign(tolerance.numbers.size(), 0.0);
            double& part =
                k < tolerance.motion.size() ? parts.motion[k] : parts.numbers[k - tolerance.motion.size()];
            part = end == 0U ? -1.0 : 1.0;
            visit_made_cam(view.solution.scene, drawn, parts,
                           [&](const Scene& scene, const CamVariables& made) {
                               ends[end] = moved_curves(view, scene, made);
                           });
        }
        for (std::size_t c = 0; c < curves.size(); ++c)
            widen(*curves[c]->band, curves[c]->values, {ends[0][c].values, ends[1][c].values});
    }
}

}  // namespace

void add_made_bands(View& view) {
    const Scene& scene = view.solution.scene;
    for (Curve& curve : view.curves)
        for (int order = 0; order < 3; ++order)
            if (const ShownDerivative& shown = view.units.motion[static_cast<std::size_t>(order)];
                curve.key == shown.name && scene.motion_error(order) > 0.0)
                add_band(curve, std::abs(shown.first.per_normalised) * scene.motion_error(order));
    std::vector<Curve*> curves;
    for (Curve& curve : view.curves)
        if (curve.group == "cam" || curve.group == "forces") curves.push_back(&curve);
    if (view.solution.cam && !curves.empty()) add_cam_bands(view, curves);
}

}  // namespace camopt
