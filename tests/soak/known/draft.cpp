// SPDX-License-Identifier: MIT
#include "tests/soak/known/draft.hpp"

#include "tests/soak/figures/law.hpp"
#include "tests/soak/scenes/drawn_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace camopt::soak {

namespace {

enum class MotionKind { drd, rr, program };

/// What a class asks of the motion below it.
struct Wish {
    MotionKind motion = MotionKind::drd;
    bool ends_move = false;
    bool needs_speed = false, lengths_only = false;
    bool laws = true;
    int least_degree = 3, rest = 2;
    bool odd_units = false, uneven = false;  ///< units 1e±9, segment widths 1 : 1e4
    bool regions = false;                    ///< of constant velocity
    bool friction = false;                   ///< dry, of a motor
    bool advances = false;                   ///< a program that goes on by a lift each cycle
    double rms_chance = 0.12;                ///< of each root mean square
    double speed_rpm = 0.0;                  ///< 0: drawn
};

struct SplineDraft {
    int degree = 3, continuity = 2, segments = 8, rest = 2;
    std::vector<double> breakpoints;  ///< in parts of the whole, 0 … 1; empty: uniform
};

SplineDraft drawn_spline(Draw& draw, const Wish& wish, int most_segments) {
    SplineDraft spline;
    spline.degree = draw.chance(0.65) ? 3 : draw.chance(0.7) ? 5 : 7;
    spline.degree = std::max(spline.degree, wish.least_degree);
    spline.continuity = spline.degree - 1;
    if (spline.degree > 3 && wish.rest == 2 && draw.chance(0.4))
        spline.continuity = draw.whole(spline.degree == 7 ? 3 : 2, spline.degree - 1);
    spline.rest = wish.rest;
    if (wish.rest == 2 && spline.degree > 3 && draw.chance(0.25))
        spline.rest = draw.whole(3, spline.degree - 2);
    const int least = std::max({5, spline.degree, 2 * spline.rest - spline.degree + 4});
    spline.segments =
        draw.whole(least, std::max(least + 2, spline.degree == 3 ? most_segments : most_segments / 2));
    if (wish.uneven)
        spline.breakpoints = drawn_breakpoints(draw, spline.segments, 1.0, 1e-4);
    else if (draw.chance(0.35))
        spline.breakpoints = drawn_breakpoints(draw, spline.segments, 1.0, 0.3);
    return spline;
}

void write_spline(const SplineDraft& spline, SceneText& text, double length) {
    SceneTable& table = text.at("spline");
    table.set("degree", std::to_string(spline.degree));
    if (spline.breakpoints.empty()) {
        table.set("segments", std::to_string(spline.segments));
    } else {
        std::vector<double> scaled;
        for (const double at : spline.breakpoints) scaled.push_back(at * length);
        scaled.back() = length;
        table.set("breakpoints", list_text(scaled));
    }
    if (spline.continuity != spline.degree - 1) table.set("continuity", std::to_string(spline.continuity));
    if (spline.rest != 2) table.set("rest", std::to_string(spline.rest));
}

std::vector<double> breakpoints_between(const SplineDraft& spline, double begin, double end) {
    std::vector<double> points;
    const double width = end - begin;
    for (int k = 0; k <= spline.segments; ++k)
        points.push_back(begin + (spline.breakpoints.empty()
                                      ? width * k / spline.segments
                                      : width * spline.breakpoints[static_cast<std::size_t>(k)]));
    points.front() = begin;
    points.back() = end;
    return points;
}

/// The breakpoints with a region in them, one polynomial that is a straight line: those inside and, of
/// uniform ones, those closer than a quarter of their distance give way.
std::vector<double> with_region(std::vector<double> points, const Region& region, double closest) {
    std::erase_if(points, [&](double point) {
        const bool inner = point != points.front() && point != points.back();
        return inner && point > region.from - closest && point < region.to + closest;
    });
    points.insert(std::ranges::upper_bound(points, region.from), {region.from, region.to});
    return points;
}

/// Of the pieces that follow, which become one run. Between `begin` and `end` lies no displacement that is
/// given.
std::vector<double> drawn_region(Draw& draw, const SplineDraft& spline, std::vector<double> points,
                                 double begin, double end, Draft& draft) {
    const double width = end - begin, from = begin + width * draw.between(0.1, 0.7);
    const Region region{draft.runs.size(), from, from + width * draw.between(0.05, 0.25)};
    draft.regions.push_back(region);
    const double distance = points[1] - points[0];
    return with_region(std::move(points), region, spline.breakpoints.empty() ? 0.25 * distance : 1e-9);
}

/// The velocity itself is a set point (posing.cpp).
void straighten(const Region& region, PiecewiseSpace& space) {
    const int piece = space.piece_of(0.5 * (region.from + region.to));
    for (int order = 2; order <= space.degree(); ++order) space.fix_begin(piece, order, 0.0);
}

double rounded(double value, double step) {
    return std::round(value / step) * step;
}

/// Angles and sizes with few digits, as people write them.
void draw_units(Draw& draw, Draft& draft, const Wish& wish) {
    SceneTable& motion = draft.text.at("motion");
    draft.units.swings = !wish.lengths_only && !wish.odd_units && draw.chance(0.2);
    if (draft.units.swings) {
        const double lift = draw.whole(5, 60);
        motion.set("lift_deg", lift);
        draft.units.lift = lift * degree_angle;
    } else if (draw.chance(0.15)) {
        const double lift = rounded(draw.between(0.2, 4.0), 0.01);
        motion.set("lift_in", lift);
        draft.units.lift = lift * 0.0254;
    } else {
        const double lift = wish.odd_units ? draw.sized(1e-9, 1e9) : draw.whole(2, 120);
        motion.set("lift_mm", lift);
        draft.units.lift = lift * 1e-3;
    }
    if (!wish.needs_speed && draw.chance(0.5)) return;
    const double speed = wish.speed_rpm > 0.0 ? wish.speed_rpm
                         : wish.odd_units     ? draw.sized(1e-9, 1e9)
                                              : draw.whole(20, 600);
    motion.set("speed_rpm", speed);
    draft.units.speed = speed * std::numbers::pi / 30.0;
}

void add_state(Draw& draw, const Draft& draft, const char* name, std::array<double, 2> state,
               SceneText& text) {
    SceneTable table;
    for (int order = 1; order <= 2; ++order) {
        const double value = state[static_cast<std::size_t>(order) - 1];
        if (value == 0.0) continue;
        const Spelling spelling = drawn_spelling(draw, draft.units, order, 1.0);
        table.set(order_names[order] + spelling.ending, value * spelling.factor);
    }
    if (!table.members.empty()) text.at("motion").set(name, inline_text(table));
}

/// A rise, or a rise and return.
void draw_one_spline(Draw& draw, const Wish& wish, Draft& draft) {
    const bool returns = wish.motion == MotionKind::rr;
    draft.text.at("motion").set("type", quoted(returns ? "RR" : "DRD"));
    draw_units(draw, draft, wish);
    SceneTable& motion = draft.text.at("motion");  // until the next table is made
    const double rise = draw.whole(40, 170);
    motion.set("rise_deg", rise);
    draft.units.unit = rise * degree_angle;
    if (returns) {
        const double back = draw.chance(0.4) ? rise : draw.whole(40, 180);
        motion.set("return_deg", back);
        draft.length = 1.0 + back / rise;
    }
    const SplineDraft spline = drawn_spline(draw, wish, returns ? 20 : 16);
    // Without the key a rise and return of unequal angles has other segments: here they are always given.
    write_spline(spline, draft.text, draft.length);
    PiecewiseSpace& space = draft.space = PiecewiseSpace(spline.degree);
    std::vector<double> points = breakpoints_between(spline, 0.0, draft.length);
    if (wish.regions) {
        const bool falls = returns && draw.chance(0.5);
        points = drawn_region(draw, spline, points, falls ? 1.0 : 0.0, falls ? draft.length : 1.0, draft);
    }
    space.add_run(points, spline.continuity);
    for (const Region& region : draft.regions) straighten(region, space);
    std::array<double, 2> start{}, end{};
    if (wish.ends_move) {
        if (draw.chance(0.8))
            start = {draw.between(-0.4, 1.2), draw.chance(0.5) ? draw.between(-3.0, 4.0) : 0.0};
        if (draw.chance(0.8))
            end = {draw.between(-0.5, 1.2), draw.chance(0.5) ? draw.between(-4.0, 3.0) : 0.0};
        add_state(draw, draft, "start", start, draft.text);
        add_state(draw, draft, "end", end, draft.text);
    }
    const int last = space.pieces() - 1;
    space.fix_begin(0, 0, 0.0);
    space.fix_end(last, 0, returns ? 0.0 : 1.0);
    for (int order = 1; order <= spline.rest; ++order) {
        space.fix_begin(0, order, order <= 2 ? start[static_cast<std::size_t>(order) - 1] : 0.0);
        space.fix_end(last, order, order <= 2 ? end[static_cast<std::size_t>(order) - 1] : 0.0);
    }
    if (returns) {
        space.fix(1.0, 0, 1.0);
        space.fix(1.0, 1, 0.0);
    }
    const bool even_ends = spline.breakpoints.empty() && !wish.ends_move && !wish.regions;
    if (even_ends && draw.chance(0.1) && (!returns || draft.length == 2.0)) {
        space.reflect(!returns);
        draft.text.at("motion").set("symmetric", "true");
    }
    draft.continuity = spline.continuity;
    Run whole;
    whole.pieces = space.pieces();
    whole.end = draft.length;
    draft.runs.push_back(whole);
}

struct ProgramPart {
    enum class Kind { spline, dwell, law } kind = Kind::spline;
    double angle = 0.0, from = 0.0, to = 0.0;
    std::string law;
    bool stops = false;  ///< `end = { velocity = 0 }`
};

/// Levels and kinds: at least one stroke each way, two splines side by side now and then.
std::vector<ProgramPart> drawn_parts(Draw& draw, const Wish& wish) {
    using Kind = ProgramPart::Kind;
    std::vector<ProgramPart> parts;
    const auto add = [&](Kind kind, double to) {
        ProgramPart part;
        part.kind = kind;
        part.from = parts.empty() ? 0.0 : parts.back().to;
        part.to = to;
        if (kind == Kind::law) part.law = draw.one_of(known_laws());
        parts.push_back(part);
    };
    if (wish.advances || draw.chance(0.6)) add(Kind::dwell, 0.0);
    if (draw.chance(0.3)) add(Kind::spline, rounded(draw.between(0.25, 0.75), 0.01));
    add(Kind::spline, 1.0);
    if (draw.chance(0.6)) add(Kind::dwell, 1.0);
    if (!wish.advances && draw.chance(0.3)) {
        add(wish.laws && draw.chance(0.5) ? Kind::law : Kind::spline,
            rounded(draw.between(0.25, 0.75), 0.01));
        if (draw.chance(0.5)) add(Kind::dwell, parts.back().to);
    }
    const bool law = wish.laws && parts.back().kind != Kind::law && draw.chance(0.2);
    if (!wish.advances) add(law ? Kind::law : Kind::spline, 0.0);
    if (!wish.advances && (parts.front().kind != Kind::dwell || draw.chance(0.4))) add(Kind::dwell, 0.0);
    // Whole degrees that add up to 360.
    double left = 360.0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const bool last = k + 1 == parts.size();
        const double share = left / static_cast<double>(parts.size() - k);
        parts[k].angle = last ? left : std::round(share * draw.between(0.6, 1.4));
        left -= parts[k].angle;
    }
    return parts;
}

bool moves(const ProgramPart& part) {
    return part.kind == ProgramPart::Kind::spline;
}

void write_part(const ProgramPart& part, SceneText& text) {
    SceneTable& table = text.append("motion.segments");
    using Kind = ProgramPart::Kind;
    table.set("kind", quoted(part.kind == Kind::spline ? "spline"
                             : part.kind == Kind::law  ? "law"
                                                       : "dwell"));
    if (part.kind == Kind::law) table.set("law", quoted(part.law));
    table.set("angle_deg", part.angle);
    if (part.kind != Kind::dwell) table.set("to", part.to);
    if (part.stops) table.set("end", "{ velocity = 0 }");
}

/// Whether two splines that follow each other are one stroke.
bool one_stroke(const ProgramPart& before, const ProgramPart& after) {
    return moves(before) && moves(after) && (before.to - before.from) * (after.to - after.from) > 0.0;
}

void draw_program_parts(Draw& draw, const Wish& wish, Draft& draft) {
    draft.text.at("motion").set("type", quoted("program"));
    draw_units(draw, draft, wish);
    draft.advances = wish.advances;
    if (wish.advances) draft.text.at("motion").set("closed", quoted("relative"));
    std::vector<ProgramPart> parts = drawn_parts(draw, wish);
    const std::size_t count = parts.size();
    SplineDraft spline = drawn_spline(draw, wish, 9);
    const bool with_law =
        std::ranges::any_of(parts, [](const auto& p) { return p.kind == ProgramPart::Kind::law; });
    if (with_law) spline.rest = std::min(spline.rest, 2);
    for (std::size_t k = 0; k < count; ++k) {
        const ProgramPart& next = parts[(k + 1) % count];
        parts[k].stops = moves(parts[k]) && moves(next) && !one_stroke(parts[k], next);
    }
    for (const ProgramPart& part : parts) write_part(part, draft.text);
    write_spline(spline, draft.text, 1.0);
    const auto first = std::ranges::find_if(parts, moves);
    const double unit = first->angle;
    draft.units.unit = unit * degree_angle;
    draft.length = 360.0 / unit;
    PiecewiseSpace& space = draft.space = PiecewiseSpace(spline.degree);
    double at = 0.0;
    std::vector<int> run_of(count, -1);
    for (std::size_t k = 0; k < count; ++k) {
        const ProgramPart& part = parts[k];
        const double begin = at / unit;
        at += part.angle;
        if (!moves(part)) {
            draft.resting_area += 0.5 * (part.from + part.to) * part.angle / unit;
            continue;
        }
        Run run;
        run.begin = begin;
        run.end = at / unit;
        std::vector<double> points = breakpoints_between(spline, run.begin, run.end);
        const bool region = wish.regions && (draft.regions.empty() || draw.chance(0.5));
        if (region) points = drawn_region(draw, spline, points, run.begin, run.end, draft);
        run.first = space.add_run(points, spline.continuity);
        run.pieces = space.pieces() - run.first;
        if (region) straighten(draft.regions.back(), space);
        run.table = static_cast<int>(k);
        run.angle = part.angle / unit;
        run.height = std::abs(part.to - part.from);
        run.least = std::min(part.from, part.to);
        run.most = std::max(part.from, part.to);
        run.rises = part.to > part.from;
        run_of[k] = static_cast<int>(draft.runs.size());
        draft.runs.push_back(run);
    }
    // Ends and joints.
    for (std::size_t k = 0; k < count; ++k) {
        if (run_of[k] < 0) continue;
        const ProgramPart& part = parts[k];
        const Run& run = draft.runs[static_cast<std::size_t>(run_of[k])];
        const std::size_t after = (k + 1) % count, before = (k + count - 1) % count;
        space.fix_begin(run.first, 0, part.from);
        space.fix_end(run.first + run.pieces - 1, 0, part.to);
        if (!moves(parts[before]))
            for (int order = 1; order <= spline.rest; ++order) space.fix_begin(run.first, order, 0.0);
        if (!moves(parts[after])) {
            for (int order = 1; order <= spline.rest; ++order)
                space.fix_end(run.first + run.pieces - 1, order, 0.0);
        } else {
            const Run& next = draft.runs[static_cast<std::size_t>(run_of[after])];
            space.join(run.first + run.pieces - 1, next.first, spline.continuity);
            if (part.stops) space.fix_end(run.first + run.pieces - 1, 1, 0.0);
        }
    }
    // Strokes of two splines: no stroke here has more.
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t after = (k + 1) % count;
        if (!one_stroke(parts[k], parts[after])) continue;
        Run &one = draft.runs[static_cast<std::size_t>(run_of[k])],
            &two = draft.runs[static_cast<std::size_t>(run_of[after])];
        one.angle = two.angle = (parts[k].angle + parts[after].angle) / unit;
        one.height = two.height = std::abs(parts[after].to - parts[k].from);
    }
    draft.continuity = spline.continuity;
}

Combination scaled(Combination weights, double factor) {
    for (double& weight : weights) weight *= factor;
    return weights;
}

/// Peaks, each stroke by its own angle and displacement.
std::vector<Combination> normalised(const Draft& draft, int order) {
    std::vector<Combination> of_run;
    for (const Run& run : draft.runs)
        of_run.push_back(scaled(derivative_alone(order), std::pow(run.angle, order) / run.height));
    return of_run;
}

std::vector<Combination> physical(const Draft& draft, const Combination& weights) {
    return std::vector<Combination>(draft.runs.size(), weights);
}

/// One limit, or one for each side, of a quantity.
void add_limits(Draw& draw, Draft& draft, const LimitDraft& like, double positive_chance = 0.5) {
    using Side = LimitDraft::Side;
    if (draw.chance(positive_chance)) {
        draft.limits.push_back(like);
        draft.limits.back().side = Side::both;
        return;
    }
    for (const bool above : {true, false}) {
        LimitDraft limit = like;
        limit.side = above ? Side::above : Side::below;
        limit.member = above ? "max" : "min";
        draft.limits.push_back(limit);
    }
}

void add_motion_terms(Draw& draw, Draft& draft, bool with_law_segments) {
    static const std::map<std::string, double> usual = {
        {"velocity", 1.76}, {"acceleration", 5.53}, {"jerk", 69.0}};
    if (draw.chance(0.4)) draft.reference_law = draw.one_of(known_laws());
    for (int order = 1; order <= 3; ++order) {
        CostTerm term;
        term.key = order_names[order];
        term.of_run = normalised(draft, order);
        term.reference = draft.reference_law.empty()
                             ? rounded(usual.at(term.key) * draw.between(0.7, 1.4), 0.001)
                             : law_figures(draft.reference_law).at(term.key);
        if (draw.chance(order == 1 ? 0.5 : 0.75)) draft.terms.push_back(term);
        if (draw.chance(0.4)) continue;
        LimitDraft limit;
        // By the cam angle or in time a limit holds for law segments too: these are left out then.
        // Errors of a made cam are lengths by the cam angle: each stroke would have its own normalised ones.
        Spelling spelling{"", 1.0};
        const bool made = draft.made_error[0] > 0.0;
        do {
            if (!with_law_segments) spelling = drawn_spelling(draw, draft.units, order, 1.0);
        } while (made && spelling.ending.empty());
        limit.key = order_names[order] + spelling.ending;
        limit.of_run = spelling.ending.empty() ? term.of_run : physical(draft, derivative_alone(order));
        limit.factor = spelling.factor;
        limit.widening = draft.made_error[static_cast<std::size_t>(order)];
        add_limits(draw, draft, limit);
    }
}

/// Of the splines alone, each stroke by its own angle and displacement.
void add_root_mean_squares(Draft& draft, double chance) {
    for (int order = 2; order <= 3; ++order) {
        RmsDraft rms;
        rms.key = std::string("rms_") + order_names[order];
        rms.of_run = normalised(draft, order);
        rms.chance = chance;
        if (!draft.reference_law.empty()) rms.reference = law_figures(draft.reference_law).at(rms.key);
        draft.root_mean_squares.push_back(rms);
    }
}

bool has_law(const Draft& draft) {
    return std::ranges::any_of(draft.text.all("motion.segments"),
                               [](const SceneTable* table) { return table->word("kind", "") == "law"; });
}

Draft motion_draft(Draw& draw, const Wish& wish) {
    Draft draft;
    if (wish.motion == MotionKind::program)
        draw_program_parts(draw, wish, draft);
    else
        draw_one_spline(draw, wish, draft);
    return draft;
}

/// A motor in place of a cam: τ = r (m a + c v + F + R sgn v) + J a / r.
Draft servo_draft(Draw& draw, Wish wish) {
    wish.needs_speed = wish.lengths_only = true;
    wish.laws = false;
    Draft draft = motion_draft(draw, wish);
    SceneTable& drive = draft.text.at("drive");
    const double load = draw.whole(1, 20), inertia = draw.whole(1, 20) * 1e-4, travel = draw.whole(20, 120),
                 viscous = draw.chance(0.6) ? draw.whole(1, 80) : 0,
                 force = draw.chance(0.3) ? draw.whole(1, 40) : 0;
    drive.set("load_mass_kg", load);
    drive.set("motor_inertia_kg_m2", inertia);
    drive.set("transmission_mm_per_rev", travel);
    if (viscous > 0.0) drive.set("viscous_n_s_m", viscous);
    if (force > 0.0) drive.set("force_n", force);
    const double friction = wish.friction ? draw.whole(1, 60) : 0.0;
    if (wish.friction) drive.set("friction_n", friction);
    const double r = travel * 1e-3 / (2.0 * std::numbers::pi), pace = draft.units.speed / draft.units.unit,
                 lift = draft.units.lift;
    Combination torque{};
    torque[1] = r * viscous * lift * pace;
    torque[2] = (r * load + inertia / r) * lift * pace * pace;
    CostTerm term;
    term.key = "motor_torque";
    term.of_run = physical(draft, torque);
    term.constant = r * force;
    if (wish.friction) {  // its direction has to be known
        draft.monotone = true;
        draft.text.at("motion").set("monotone", "true");
        for (const Run& run : draft.runs) term.added.push_back((run.rises ? r : -r) * friction);
    }
    term.reference = rounded(torque[2] * draw.between(4.0, 8.0), torque[2] * 1e-3);
    draft.terms.push_back(term);
    add_motion_terms(draw, draft, false);
    LimitDraft limit;
    limit.key = "motor_torque_nm";
    static_cast<Quantity&>(limit) = term;
    limit.at_rest_least = limit.at_rest_most = term.constant;
    if (draw.chance(0.6)) add_limits(draw, draft, limit);
    LimitDraft speed;
    speed.key = "motor_speed_rpm";
    speed.of_run = physical(draft, scaled(derivative_alone(1), lift * pace / r * 30.0 / std::numbers::pi));
    if (draw.chance(0.4)) draft.limits.push_back(speed);
    draft.reference_law.clear();  // numbers: a law's motor torque is not known here
    RmsDraft heat;
    static_cast<Quantity&>(heat) = term;
    heat.key = "motor_torque_rms";
    heat.limit_key = "motor_torque_rms_nm";
    heat.rests = wish.motion == MotionKind::program ? draft.length : turn_angle / draft.units.unit;
    for (const Run& run : draft.runs) heat.rests -= run.end - run.begin;
    heat.chance = 2.0 * wish.rms_chance;
    draft.root_mean_squares.push_back(heat);
    return draft;
}

/// Limits of a cam that are linear in the motion: contact force, radius under a flat face, tolerances.
Draft cam_draft(Draw& draw, Wish wish) {
    wish.needs_speed = wish.lengths_only = true;
    wish.laws = false;
    Draft draft = motion_draft(draw, wish);
    const bool flat = draw.chance(0.5);
    const double lift = draft.units.lift, unit = draft.units.unit, omega = draft.units.speed;
    SceneTable& cam = draft.text.at("cam");
    cam.set("type", quoted("disk"));
    cam.set("follower", quoted(flat ? "translating_flat" : "translating_roller"));
    const double base = std::ceil(lift * 1e3 * draw.between(3.0, 8.0) / std::min(1.0, unit * unit));
    cam.set("base_radius_mm", base);
    draft.lowest = -0.5 * base * 1e-3 / lift;
    if (!flat) cam.set("roller_radius_mm", std::ceil(lift * 200.0) + 2.0);
    SceneTable& forces = draft.text.at("forces");
    const double mass = draw.whole(1, 20) * 0.1, rate = draw.whole(1, 20);
    const double swing = mass * omega * omega * lift / (unit * unit);
    const double damping = draw.chance(0.4) ? draw.whole(1, 10) : 0,
                 preload = std::ceil(swing * draw.between(8.0, 14.0)) + 10.0;
    forces.set("mass_kg", mass);
    forces.set("spring_rate_n_mm", rate);
    forces.set("preload_n", preload);
    if (damping > 0.0) forces.set("damping_n_s_m", damping);
    const Combination force = {rate * 1e3 * lift, damping * omega * lift / unit, swing};
    double preload_error = 0.0;
    std::array<double, 3> error{};  // m by rad
    if (draw.chance(0.4)) {
        SceneTable& tolerance = draft.text.at("tolerance");
        const double profile = draw.whole(1, 30), slope = draw.whole(1, 10), bend = draw.whole(1, 9) * 0.1;
        preload_error = draw.whole(1, 5);
        tolerance.set("profile_um", profile);
        tolerance.set("slope_um_deg", slope);
        tolerance.set("acceleration_um_deg2", bend);
        tolerance.set("preload_n", preload_error);
        error = {profile * 1e-6, slope * 1e-6 / degree_angle, bend * 1e-6 / (degree_angle * degree_angle)};
        for (std::size_t order = 0; order < 3; ++order)
            draft.made_error[order] = error[order] * std::pow(unit, static_cast<double>(order)) / lift;
    }
    const auto lost = [&](const Combination& weights) {
        double sum = 0.0;
        for (std::size_t order = 0; order < 3; ++order)
            sum += std::abs(weights[order]) * draft.made_error[order];
        return sum;
    };
    add_motion_terms(draw, draft, false);
    LimitDraft least;
    least.key = "contact_force_min_n";
    least.side = LimitDraft::Side::below;
    least.of_run = physical(draft, force);
    least.constant = preload;
    least.widening = lost(force) + preload_error;
    least.at_rest_least = least.at_rest_most = preload;
    least.must_exceed = 0.0;
    draft.limits.push_back(least);
    if (draw.chance(0.3)) {
        LimitDraft most = least;
        most.key = "contact_force_max_n";
        most.side = LimitDraft::Side::above;
        most.at_rest_most = preload + rate * 1e3 * lift;
        draft.limits.push_back(most);
    }
    if (flat && draw.chance(0.7)) {
        LimitDraft radius;
        radius.key = "cam_radius_min_mm";
        radius.side = LimitDraft::Side::below;
        radius.of_run = physical(draft, {lift * 1e3, 0.0, lift * 1e3 / (unit * unit)});
        radius.constant = base;
        radius.widening = lost(radius.of_run.front());
        radius.at_rest_least = radius.at_rest_most = base;
        radius.must_exceed = 0.0;
        draft.limits.push_back(radius);
    }
    return draft;
}

/// The output of an elastic train is prescribed: limits of the cam's own motion s = (1 + k_r/k) y + (m/k) ÿ.
Draft output_draft(Draw& draw) {
    Wish wish;
    wish.motion = draw.chance(0.6) ? MotionKind::drd : MotionKind::rr;
    wish.needs_speed = wish.lengths_only = true;
    wish.least_degree = 5;
    wish.rest = 4;
    Draft draft = motion_draft(draw, wish);
    SceneTable& train = draft.text.at("dynamics");
    const double mass = draw.whole(1, 30) * 0.1, stiffness = draw.whole(200, 2000);
    const double spring = draw.chance(0.6) ? draw.whole(1, 20) : 0,
                 damper = draw.chance(0.4) ? draw.whole(1, 50) : 0;
    train.set("mass_kg", mass);
    train.set("stiffness_n_mm", stiffness);
    if (spring > 0.0) train.set("return_spring_n_mm", spring);
    if (damper > 0.0) train.set("ground_damping_n_s_m", damper);
    train.set("prescribe", quoted("output"));
    const double pace = draft.units.speed / draft.units.unit, k = stiffness * 1e3;
    const std::array<double, 3> weights = {1.0 + spring / stiffness, damper / k * pace,
                                           mass / k * pace * pace};
    add_motion_terms(draw, draft, false);
    for (int order = 1; order <= 3; ++order) {
        if (draw.chance(0.4)) continue;
        Combination cam{};
        for (std::size_t j = 0; j < 3; ++j) cam[static_cast<std::size_t>(order) + j] = weights[j];
        LimitDraft limit;
        const Spelling spelling = drawn_spelling(draw, draft.units, order, 1.0);
        limit.key = std::string("cam_") + order_names[order] + spelling.ending;
        limit.of_run = physical(draft, cam);
        limit.factor = spelling.factor;
        add_limits(draw, draft, limit);
    }
    return draft;
}

/// One side of a valve lobe: the follower's ramp, a quartic to a third of its height and a straight line, and
/// the flank.
struct LobeSide {
    double height = 0.0, velocity = 0.0;  ///< m, m by rad
    double before_checking = 0.0;         ///< rad, from the ramp's end to the checking point
    [[nodiscard]] double part() const { return 2.0 * height / (3.0 * velocity); }
};

/// Ramps above or below the checking point, at `checking` of the follower.
LobeSide drawn_side(Draw& draw, double checking, const char* name, SceneText& text) {
    LobeSide side;
    // The checking point lies where the ramp has its velocity: above a third of its height.
    double height_mm = rounded(draw.between(0.2, std::min(0.5, 2.9e3 * checking)), 0.01);
    if (std::abs(height_mm - 1e3 * checking) < 5e-3) height_mm -= 0.01;  // nor at its end
    const double velocity_mm_deg = rounded(draw.between(0.008, 0.016), 0.001);
    side.height = height_mm * 1e-3;
    side.velocity = velocity_mm_deg * 1e-3 / degree_angle;
    side.before_checking = (checking - side.height) / side.velocity;
    SceneTable ramp;
    ramp.set("height_mm", height_mm);
    ramp.set("velocity_mm_deg", velocity_mm_deg);
    if (checking > side.height) {
        const double most = side.before_checking / degree_angle;
        const double end_deg = draw.between(0.4, 0.9) * most;
        ramp.set("end_deg", end_deg);
        side.before_checking = end_deg * degree_angle;
    }
    text.at("motion").set(name, inline_text(ramp));
    return side;
}

/// A program in the words of engine builders: ramps, two flanks that pass the checking height, a dwell.
Draft valve_draft(Draw& draw) {
    Draft draft;
    draft.may_pass_points = false;
    draft.monotone = true;
    SceneTable& motion = draft.text.at("motion");
    motion.set("type", quoted("valve"));
    const double lift_mm = rounded(draw.between(7.0, 12.0), 0.1),
                 lash_mm = rounded(draw.between(0.0, 0.25), 0.01),
                 checking_mm = rounded(draw.between(0.1, 0.2), 0.01), duration = draw.whole(220, 280);
    motion.set("lift_mm", lift_mm);
    if (lash_mm > 0.0) motion.set("lash_mm", lash_mm);
    motion.set("checking_height_mm", checking_mm);
    motion.set("duration_crank_deg", duration);
    const double lift = (lift_mm + lash_mm) * 1e-3, checking = (checking_mm + lash_mm) * 1e-3;
    double opening = 0.25 * duration * degree_angle;  // two crank degrees a cam degree
    const double whole = 2.0 * opening;
    if (draw.chance(0.5)) {
        const double opening_crank = rounded(0.5 * duration * draw.between(0.94, 1.06), 0.1);
        motion.set("opening_crank_deg", opening_crank);
        opening = 0.5 * opening_crank * degree_angle;
    }
    draft.units.lift = lift;
    if (draw.chance(0.5)) {
        const double engine = draw.whole(3000, 7000);
        motion.set("engine_speed_rpm", engine);
        draft.units.speed = 0.5 * engine * std::numbers::pi / 30.0;
    }
    const LobeSide up = drawn_side(draw, checking, "opening_ramp", draft.text),
                   down = drawn_side(draw, checking, "closing_ramp", draft.text);
    const double unit = draft.units.unit = opening + up.before_checking,
                 back = (whole - opening + down.before_checking) / unit;
    draft.length = turn_angle / unit;
    SplineDraft spline;
    spline.degree = draw.chance(0.7) ? 3 : 5;
    spline.continuity = spline.degree - 1;
    spline.segments = draw.whole(7, spline.degree == 3 ? 14 : 9);
    write_spline(spline, draft.text, 1.0);
    draft.continuity = spline.continuity;
    PiecewiseSpace& space = draft.space = PiecewiseSpace(spline.degree);
    const double begin = 2.0 * up.part() / unit, top = begin + 1.0, end = top + back;
    for (const bool rises : {true, false}) {
        Run run;
        run.begin = rises ? begin : top;
        run.end = rises ? top : end;
        run.first = space.add_run(breakpoints_between(spline, run.begin, run.end), spline.continuity);
        run.pieces = spline.segments;
        run.angle = run.end - run.begin;
        run.least = (rises ? up.height : down.height) / lift;
        run.height = 1.0 - run.least;
        run.rises = rises;
        draft.runs.push_back(run);
    }
    const int last = space.pieces() - 1, first_down = spline.segments;
    space.fix_begin(0, 0, up.height / lift);
    space.fix_begin(0, 1, up.velocity * unit / lift);
    space.fix_begin(0, 2, 0.0);
    space.join(first_down - 1, first_down, spline.continuity);
    space.fix_begin(first_down, 0, 1.0);
    space.fix_begin(first_down, 1, 0.0);
    space.fix_end(last, 0, down.height / lift);
    space.fix_end(last, 1, -down.velocity * unit / lift);
    space.fix_end(last, 2, 0.0);
    if (checking > up.height) space.fix(begin + up.before_checking / unit, 0, checking / lift);
    if (checking > down.height) space.fix(end - down.before_checking / unit, 0, checking / lift);
    for (const LobeSide& side : {up, down})  // of the quartic (h/3) (2 t³ − t⁴), and of the straight line
        draft.resting_area += (0.1 + 2.0 / 3.0) * side.height / lift * side.part() / unit;
    add_motion_terms(draw, draft, false);
    for (LimitDraft& limit : draft.limits) {
        std::size_t order = 1;
        while (!limit.key.starts_with(order_names[order])) ++order;
        if (limit.key == order_names[order]) continue;  // of the strokes alone
        for (const LobeSide& side : {up, down}) {
            const double rate = unit / side.part(), height = side.height / lift;
            const double most[] = {0.0, side.velocity * unit / lift, height * rate * rate,
                                   4.0 * height * rate * rate * rate};
            limit.at_rest_most = std::max(limit.at_rest_most, most[order]);
            if (order != 2) limit.at_rest_least = std::min(limit.at_rest_least, -most[order]);
        }
    }
    return draft;
}

Draft plain_draft(Draw& draw, const Wish& wish) {
    Draft draft = motion_draft(draw, wish);
    add_motion_terms(draw, draft, has_law(draft));
    add_root_mean_squares(draft, wish.rms_chance);
    if (wish.odd_units) draft.change = "units";
    if (wish.uneven) draft.change = "segment widths";
    return draft;
}

MotionKind drawn_motion_kind(Draw& draw, int kind) {
    using enum MotionKind;
    switch (kind) {
        case 1:
            return rr;
        case 2:
            return draw.chance(0.4) ? rr : drd;
        case 3:
            return program;
        case 4:
        case 9:
            return draw.chance(0.5) ? drd : draw.chance(0.5) ? rr : program;
        case 5:
            return draw.chance(0.5) ? rr : program;
        case 8:
            return draw.chance(0.5) ? drd : program;  // a run of RR goes both ways
        case 10:
            return draw.chance(0.5) ? program : draw.chance(0.5) ? rr : drd;
        default:
            return drd;
    }
}

}  // namespace

const char* known_kind_name(int kind) {
    static constexpr const char* names[known_kinds] = {
        "rise",         "rise and return",        "ends in motion",    "program",
        "servo",        "linear limits of a cam", "output prescribed", "valve",
        "dry friction", "constant velocity",      "root mean squares", "machine"};
    return names[kind];
}

Draft drawn_draft(Draw& draw, int kind, bool extreme) {
    Wish wish;
    wish.motion = drawn_motion_kind(draw, kind);
    wish.ends_move = kind == 2;
    wish.friction = kind == 8;
    wish.regions = kind == 9;
    wish.advances = kind == 3 && draw.chance(0.15);
    if (kind == 10) wish.rms_chance = 0.4;
    if (kind < 4) {
        wish.odd_units = extreme && draw.chance(0.2);
        wish.uneven = extreme && draw.chance(0.2);
    }
    const bool motor = kind == 4 || kind == 8 || (kind == 10 && draw.chance(0.5));
    Draft draft = motor       ? servo_draft(draw, wish)
                  : kind == 5 ? cam_draft(draw, wish)
                  : kind == 6 ? output_draft(draw)
                  : kind == 7 ? valve_draft(draw)
                              : plain_draft(draw, wish);
    draft.kind = known_kind_name(kind);
    return draft;
}

Draft drawn_axis(Draw& draw, double speed_rpm, bool extreme) {
    Wish wish;
    wish.motion = MotionKind::program;
    wish.needs_speed = true;
    wish.speed_rpm = speed_rpm;
    wish.laws = false;
    wish.uneven = extreme && draw.chance(0.1);
    wish.regions = draw.chance(0.15);
    wish.advances = draw.chance(0.2);
    if (draw.chance(0.5)) return plain_draft(draw, wish);
    wish.friction = draw.chance(0.2);
    return wish.advances || draw.chance(0.6) ? servo_draft(draw, wish) : cam_draft(draw, wish);
}

}  // namespace camopt::soak
