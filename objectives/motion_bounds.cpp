// SPDX-License-Identifier: MIT
#include "objectives/motion_bounds.hpp"

#include "core/numbers/polynomial.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "objectives/drive_rules.hpp"
#include "objectives/scene_family.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = StretchRequest::Kind;

// Of y, y', y'', y''' of a good motion over one lift: what a bound near 0 is measured by.
constexpr std::array typical = {1.0, 2.0, 6.0, 60.0};

double scale_of(const LinearBound& bound, double size) {
    return std::max(std::abs(bound.bound), size * typical[static_cast<std::size_t>(bound.order)]);
}

/// One side of a limit: of one of both sides |y^{(r)}| <= L, ±y^{(r)} <= L.
void add_sided(std::vector<WrittenBound>& all, const PeakLimitRow& row, const PeakLimit& limit, int side,
               const MotionFamily& family, const std::vector<StretchScale>& scales) {
    WrittenBound bound;
    bound.key = limit.key;
    bound.order = row.order();
    bound.sign = side;
    bound.bound = side * (row.side == 0 ? side : 1) * limit.normalised;
    bound.magnitude = row.side == 0;
    if (row.of_cam) bound.seen = SeenMotion::cam;
    bound.scale = scale_of(bound, 1.0);
    bound.name = row.name();
    bound.unit = limit.unit;
    bound.given = limit.given;
    bound.per_normalised = limit.physical() ? limit.unit_per_normalised() : 1.0;
    if (limit.physical() || family.stretches().size() == 1) {
        all.push_back(std::move(bound));
        return;
    }
    const std::span<const MotionFamily::Stretch> stretches = family.stretches();
    const bool splines =
        std::ranges::find(stretches, Kind::spline, &MotionFamily::Stretch::kind) != stretches.end();
    for (std::size_t s = 0; s < stretches.size(); ++s) {
        if (stretches[s].kind != (splines ? Kind::spline : Kind::shape)) continue;
        const double size = scales[s].displacement / std::pow(scales[s].angle, row.order());
        WrittenBound own = bound;
        own.bound *= size;
        own.per_normalised = 1.0 / size;
        own.scale = scale_of(own, 1.0 / own.per_normalised);
        own.from = stretches[s].begin;
        own.until = stretches[s].end;
        own.stretch = static_cast<int>(s);
        all.push_back(std::move(own));
    }
}

/// The unit's number for one lift by x^order.
double per_normalised(const MotionSpec& motion, const Corridor::Bounds& bounds, int order) {
    if (bounds.unit.empty()) return 1.0;
    return set_point_unit({motion.unit_angle(), motion.lift, motion.speed}, order,
                          is_unit_of_time(bounds.unit)) /
           spelling_of_unit(order, bounds.unit).factor;
}

/// x, or the end of a stretch that it is meant as: it may be a rounding of the angle beside it.
double meant_place(const MotionFamily& family, double x) {
    const double rounding = 1e-13 * std::max(1.0, family.end());
    for (const MotionFamily::Stretch& stretch : family.stretches())
        for (const double end : {stretch.begin, stretch.end})
            if (std::abs(x - end) <= rounding) return end;
    return x;
}

void add_corridor(std::vector<WrittenBound>& all, const MotionSpec& motion, const MotionFamily& family,
                  std::size_t index) {
    const Corridor& corridor = motion.corridors[index];
    for (std::size_t order = 0; order < corridor.bounds.size(); ++order) {
        const Corridor::Bounds& bounds = corridor.bounds[order];
        const double unit = per_normalised(motion, bounds, static_cast<int>(order));
        for (const int sign : {-1, 1}) {
            const std::optional<double>& value = sign < 0 ? bounds.least : bounds.most;
            if (!value) continue;
            const char* const side = sign < 0 ? "min" : "max";
            const std::string name = bounds.key.empty() ? derivative_names[order] : bounds.key;
            WrittenBound bound;
            bound.key = entry_key("motion.corridor", index, joined_key(name, side));
            bound.order = static_cast<int>(order);
            bound.sign = sign;
            bound.bound = sign * *value;
            bound.scale = scale_of(bound, 1.0);
            bound.from = meant_place(family, corridor.from / motion.unit_angle());
            bound.until = meant_place(family, std::min(corridor.to / motion.unit_angle(), motion.length()));
            bound.on_copies = true;
            bound.name = fmt::format("corridor_{}_{}", derivative_names[order], side);
            bound.unit = bounds.unit;
            bound.given = as_written(*value * unit);
            bound.per_normalised = unit;
            bound.corridor = static_cast<int>(index);
            all.push_back(std::move(bound));
        }
    }
}

constexpr int parts_of_law = 16;  // of a smooth piece: sines are then exact to round-off

/// ∫ over a motion between its breakpoints as Σ weight · f(x), visited.
template <class Visit>
void visit_motion(const std::vector<double>& breakpoints, Visit&& visit) {
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i)
        visit_quadrature(breakpoints[i], breakpoints[i + 1], parts_of_law, visit);
}

/// 1 − (1/L) ∫ y dx, divided by `reference`, by the entries of the family.
AffineRow area_row(const MotionFamily& family, double reference) {
    std::vector<double> weights(static_cast<std::size_t>(family.size()), 0.0);
    const double factor = -1.0 / (reference * (family.end() - family.begin()));
    AffineRow sum{1.0 / reference, {}, {}};
    std::vector<double> breakpoints;
    for (const MotionFamily::Piece& piece : family.pieces()) breakpoints.push_back(piece.begin);
    breakpoints.push_back(family.end());
    visit_motion(breakpoints, [&](double x, double weight) {
        const AffineRow y = family.functional(x, 0);
        sum.offset += factor * weight * y.offset;
        for (std::size_t k = 0; k < y.columns.size(); ++k)
            weights[y.columns[k]] += factor * weight * y.weights[k];
    });
    for (std::size_t j = 0; j < weights.size(); ++j) {
        if (weights[j] == 0.0) continue;
        sum.columns.push_back(static_cast<int>(j));
        sum.weights.push_back(weights[j]);
    }
    return sum;
}

/// 1 − (1/L) ∫ y dx <= q · reference.
WholeMotionRule area_rule(int parameter, double reference) {
    WholeMotionRule::Parts parts;
    parts.maxima = [reference](const Motion& motion, double) {
        return std::vector<WholeMotionRule::Place>{{{lost_area(motion) / reference, motion.begin()}, {0.0}}};
    };
    parts.row = [reference](const MotionFamily& family, double, Side, WholeMotionRule::Setting) {
        return area_row(family, reference);
    };
    parts.is_one_row = true;
    return {{"area", 0, false, true, {parameter}}, std::move(parts)};
}

/// Whether a motion of the scene may lie above one lift: then the area that it loses may be negative.
bool may_pass_lift(const Scene& scene, const MotionFamily& family) {
    constexpr double highest = 1.0 + standing_displacement;
    if (!scene.motion.within_lift && !scene.motion.monotone) return true;
    return std::ranges::any_of(family.stretches(),
                               [](const MotionFamily::Stretch& stretch) {
                                   return !(known_displacement(stretch.from).value_or(0.0) <= highest) ||
                                          !(known_displacement(stretch.to).value_or(0.0) <= highest);
                               }) ||
           std::ranges::any_of(strokes_of(scene, family), [](const StrokeRange& stroke) {
               return stroke.is_free() || !(stroke.most <= highest);
           });
}

void add_area(CamModel& model, const Scene& scene) {
    if (!(scene.objective.area > 0.0)) return;
    const int index = static_cast<int>(model.parameters.size());
    const double reference = area_reference(scene, model.design);
    const auto rule = std::make_shared<const WholeMotionRule>(area_rule(index, reference));
    Parameter area{"area", Parameter::Kind::response, 0, reference, scene.objective.area};
    if (may_pass_lift(scene, model.design)) area.lower = (1.0 - farthest_displacement) / reference;
    area.defined_by = rule;
    model.parameters.push_back(std::move(area));
    model.rules.emplace_back(rule);
}

double mean_of(const Motion& law) {
    double sum = 0.0;
    visit_motion(law.breakpoints(),
                 [&](double x, double weight) { sum += weight * law.at(x).derivative[0]; });
    return sum / (law.end() - law.begin());
}

}  // namespace

std::vector<WrittenBound> motion_bounds(const Scene& scene, const MotionFamily& family) {
    std::vector<WrittenBound> all;
    const std::vector<StretchScale> scales = peak_scales(scene);
    for (const PeakLimitRow& row : peak_limit_rows())
        if (const auto& limit = row.in(scene.limits); limit && !row.on_peak())
            for (const int side : {-1, 1})
                if (row.side == 0 || row.side == side) add_sided(all, row, *limit, side, family, scales);
    for (std::size_t i = 0; i < scene.motion.corridors.size(); ++i)
        add_corridor(all, scene.motion, family, i);
    for (WrittenBound& bound : all) bound.bound -= scene.motion_error(bound.order);  // of a made cam
    for (WrittenBound& bound : drive_bounds(scene, family)) all.push_back(std::move(bound));
    return all;
}

std::vector<WrittenBound> motion_bounds(const Scene& scene) {
    const bool sided = std::ranges::any_of(peak_limit_rows(), [&](const PeakLimitRow& row) {
        return !row.on_peak() && row.in(scene.limits).has_value();
    });
    if (!sided && scene.motion.corridors.empty() && !scene.drive) return {};
    return motion_bounds(scene, scene_family(scene, DesignKind::states));
}

double lost_area(const Motion& motion) {
    return 1.0 - mean_of(motion);
}

double area_reference(const Scene& scene, const MotionFamily& family) {
    const Reference& reference = scene.objective.reference;
    if (reference.area) return *reference.area;
    if (reference.numeric)
        throw SceneError({"objective.reference.area", "no number",
                          fmt::format("a number > 0, because objective.area = {}", scene.objective.area)});
    const double law = mean_of(*make_law(reference.law));
    double lost = 1.0 - law;  // of DRD, and of RR: the return is the mirror image
    if (scene.motion.type == MotionType::program) {
        double sum = 0.0, level = 0.0;
        for (const MotionFamily::Stretch& stretch : family.stretches()) {
            const double from = known_displacement(stretch.from).value_or(level);
            level = known_displacement(stretch.to).value_or(from);
            const bool falls = level < from;  // the mirror image
            const double mean = stretch.kind == Kind::shape ? mean_of(*stretch.shape)
                                : falls                     ? 1.0 - law
                                                            : law;
            sum += (stretch.end - stretch.begin) * (from + (level - from) * mean);
        }
        lost = 1.0 - sum / (family.end() - family.begin());
    }
    if (lost > 0.0) return lost;
    throw SceneError({"objective.reference",
                      fmt::format("\"{}\", whose lost area on this scene is {:.6g}", reference.law, lost),
                      "objective.reference as numbers, with area > 0"});
}

void add_motion_bounds(CamModel& model, const Scene& scene) {
    for (const WrittenBound& bound : motion_bounds(scene, model.design)) {
        model.rules.push_back(bound.rule());
        PlacedRule& rule = model.rules.back();
        if (bound.stretch >= 0) rule.from = -infinity, rule.until = infinity;  // the stretch says it
    }
    add_area(model, scene);
}

}  // namespace camopt
