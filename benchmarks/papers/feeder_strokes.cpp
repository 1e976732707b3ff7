// SPDX-License-Identifier: MIT
#include "benchmarks/papers/feeder_strokes.hpp"

#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

namespace camopt::feeding_paper {

Scene example_scene(const std::string& name) {
    return load_scene(std::filesystem::path(CAMOPT_EXAMPLE_SCENES) / (name + ".toml"));
}

FeederStroke::FeederStroke(const std::string& scene, bool back)
    : solution_(solve(example_scene(scene))),
      numbers_(solution_.cam->cam.dimensions),
      back_(back),
      speed_(solution_.scene.motion.speed.value()) {
    const auto number = [&](InverseNumber which) { return numbers_[static_cast<std::size_t>(which)]; };
    before_ = number(InverseNumber::roller_angle) - stroke_of(numbers_).end;
    for (const double angle : solution_.scene.measured->breaks) {
        const double since = (before_ + angle) / speed_;
        joints_.push_back(back_ ? period - since : since);
    }
    std::ranges::sort(joints_);
}

FeederState FeederStroke::at(double time, Side side) const {
    const double angle = speed_ * (back_ ? period - time : time) - before_, sign = back_ ? -1.0 : 1.0;
    const Motion& motion = *solution_.motion;
    const MotionScale scale{solution_.scene.motion.lift, solution_.scene.motion.unit_angle()};
    const double x = angle / scale.unit_angle, start = solution_.scene.cam->find("feeder_start")->middle();
    const double speed = sign * speed_;
    FeederState state;
    state.roller = state_of(stroke_of(numbers_), angle);
    state.roller.velocity *= speed;
    state.roller.acceleration *= speed * speed;
    if (x < motion.begin() || x > motion.end()) {
        state.feeder.s = motion.at(std::clamp(x, motion.begin(), motion.end())).derivative[0] * scale.lift;
    } else {
        state.feeder = camopt::state_of(motion.at(x, x < motion.end() ? side : Side::left), scale);
        state.feeder.velocity *= speed;
        state.feeder.acceleration *= speed * speed;
    }
    state.feeder.s += start;
    state.body = body_motion(linkage_of(numbers_), state.feeder).body;
    return state;
}

const FeederStroke& forward_stroke() {
    static const FeederStroke stroke("given_guide_forward", false);
    return stroke;
}

const FeederStroke& return_stroke() {
    static const FeederStroke stroke("given_guide_return", true);
    return stroke;
}

std::vector<NodeRow> node_method(const FeederStroke& stroke, int nodes) {
    if (nodes < 3)
        throw InputError(fmt::format("{} nodes were requested; central differences need at least 3", nodes));
    const double step = (stroke.end() - stroke.begin()) / (nodes - 1);
    std::vector<double> angles(static_cast<std::size_t>(nodes));
    for (std::size_t i = 0; i < angles.size(); ++i)
        angles[i] =
            stroke.at(std::min(stroke.begin() + step * static_cast<double>(i), stroke.end())).body.angle;
    std::vector<NodeRow> rows;
    for (std::size_t i = 1; i + 1 < angles.size(); ++i)
        rows.push_back({stroke.begin() + step * static_cast<double>(i),
                        {angles[i], (angles[i + 1] - angles[i - 1]) / (2.0 * step),
                         (angles[i + 1] - 2.0 * angles[i] + angles[i - 1]) / (step * step)}});
    return rows;
}

NodeMethodError node_method_error(const FeederStroke& stroke, int nodes) {
    const double step = (stroke.end() - stroke.begin()) / (nodes - 1);
    NodeMethodError error;
    for (const NodeRow& row : node_method(stroke, nodes)) {
        const BodyMotion left = stroke.at(row.time, Side::left).body, right = stroke.at(row.time).body;
        const auto off = [&](double BodyMotion::*value) {  // exact on a joint means either side
            return std::min(std::abs(row.body.*value - left.*value),
                            std::abs(row.body.*value - right.*value));
        };
        const double acceleration = off(&BodyMotion::acceleration);
        error.velocity = std::max(error.velocity, off(&BodyMotion::velocity));
        error.acceleration = std::max(error.acceleration, acceleration);
        if (std::ranges::none_of(stroke.joints(),
                                 [&](double joint) { return std::abs(joint - row.time) <= step; }))
            error.acceleration_away = std::max(error.acceleration_away, acceleration);
    }
    return error;
}

}  // namespace camopt::feeding_paper
