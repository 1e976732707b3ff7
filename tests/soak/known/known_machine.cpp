// SPDX-License-Identifier: MIT
#include "tests/soak/known/known_machine.hpp"

#include "tests/soak/figures/polynomial.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

namespace camopt::soak {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::array axis_names = {"first", "second", "third"};

double wrapped(double angle) {
    const double rest = std::fmod(angle, turn_angle);
    return rest < 0.0 ? rest + turn_angle : rest;
}

Polynomial sum_of(Polynomial one, const Polynomial& other, long double factor) {
    one.resize(std::max(one.size(), other.size()), 0.0L);
    for (std::size_t k = 0; k < other.size(); ++k) one[k] += factor * other[k];
    return one;
}

/// p(a + b u), by Horner's scheme.
Polynomial shifted(const Polynomial& p, long double a, long double b) {
    Polynomial all = {p.back()};
    for (std::size_t k = p.size() - 1; k > 0; --k) all = sum_of({p[k - 1]}, product_of(all, {a, b}), 1.0L);
    return all;
}

/// A motion on the master: at the angle θ its x is (θ − phase) / unit within the cycle. One that advances is
/// a lift back before its phase, so that it runs on from 0 to 2π of the master and falls back there.
class Axis {
 public:
    Axis(Draw& draw, double speed_rpm, bool edges) : posing(draw, drawn_axis(draw, speed_rpm, edges), edges) {
        if (draw.chance(0.7)) phase_deg = draw.chance(0.5) ? draw.whole(-359, 359) : draw.between(-359, 359);
    }

    Posing posing;
    double phase_deg = 0.0;

    [[nodiscard]] const Units& units() const { return posing.draft().units; }
    [[nodiscard]] const PiecewiseSpace& space() const { return posing.draft().space; }
    [[nodiscard]] double phase() const { return wrapped(phase_deg * degree_angle); }
    [[nodiscard]] bool is_before_phase(double angle) const { return wrapped(angle) < phase(); }
    [[nodiscard]] double x_of(double angle) const {
        return (wrapped(angle) - phase() + (is_before_phase(angle) ? turn_angle : 0.0)) / units().unit;
    }
    /// Lifts that its displacement has on top of y.
    [[nodiscard]] double advanced_at(double angle) const {
        return posing.draft().advances && is_before_phase(angle) ? -1.0 : 0.0;
    }
    [[nodiscard]] bool moves_at(double x) const {
        const int piece = space().piece_of(x);
        return x > space().begin(piece) && x < space().end(piece);
    }
    /// The row of the displacement, lifts. In a dwell that of the next spline's begin, which its ends fix.
    [[nodiscard]] VectorXd row(double x, int order = 0) const {
        return space().row(derivative_alone(order), space().piece_of(x), x);
    }
    /// Of all breakpoints.
    [[nodiscard]] std::vector<double> master_angles() const;
    /// The displacement from one angle of the master to another, of u from 0 to 1. No breakpoint lies
    /// between.
    [[nodiscard]] Polynomial between(double from, double to) const;
};

std::vector<double> Axis::master_angles() const {
    std::vector<double> angles;
    for (int piece = 0; piece < space().pieces(); ++piece)
        for (const double x : {space().begin(piece), space().end(piece)})
            angles.push_back(wrapped(phase() + x * units().unit));
    return angles;
}

Polynomial Axis::between(double from, double to) const {
    const double x = x_of(0.5 * (from + to)), advanced = advanced_at(0.5 * (from + to));
    if (!moves_at(x)) return {row(x).dot(posing.motion()) + advanced};
    const int piece = space().piece_of(x);
    const long double middle = (static_cast<long double>(x) - space().begin(piece)) / space().width(piece),
                      length = (static_cast<long double>(to) - from) / units().unit / space().width(piece);
    return sum_of(shifted(space().polynomial(posing.motion(), derivative_alone(0), piece),
                          middle - 0.5L * length, length),
                  {advanced}, 1.0L);
}

/// Σ factor · displacement >= at_least from one angle of the master to another; `until` may pass 2π.
struct Clearance {
    std::vector<std::size_t> axes;
    std::vector<double> factors;
    double from = 0.0, until = turn_angle;
    double at_least = 0.0;   ///< m or rad
    double scale = 0.0;      ///< Σ |factor| · lift
    double loosened = -1.0;  ///< part of the scale; below 0: it is left out unless it has a multiplier
};

/// A place of the master, and the sum there.
struct Sum {
    double angle = 0.0, value = 0.0;
};

class Machine {
 public:
    Machine(Draw& draw, const Question& question, bool edges) : draw_(draw), question_(question) {
        speed_rpm_ = draw.whole(20, 600);
        const int count = draw.chance(0.7) ? 2 : 3;
        for (int k = 0; k < count; ++k) axes_.emplace_back(draw, speed_rpm_, edges);
    }

    /// False: these draws give no machine.
    [[nodiscard]] bool pose();
    [[nodiscard]] KnownScene scene();

 private:
    void add_clearances();
    [[nodiscard]] std::optional<Clearance> drawn_clearance();
    /// Gives it a stretch that begins or ends at this angle, where the sum is least. False: there is none.
    [[nodiscard]] bool stretch_from(Clearance& clearance, double angle);
    [[nodiscard]] double sum_at(const Clearance& clearance, double angle, int order = 0) const;
    [[nodiscard]] std::vector<Sum> extremes(const Clearance& clearance) const;
    void add_rows(const Clearance& clearance);
    [[nodiscard]] ActiveRow row_at(const Clearance& clearance, double angle) const;
    [[nodiscard]] int moving_at(const Clearance& clearance, double angle) const;
    [[nodiscard]] bool is_coupled() const;
    [[nodiscard]] bool is_tight(std::size_t clearance) const;
    [[nodiscard]] bool tighten(const ActiveRow& row, double by);
    [[nodiscard]] SceneText written() const;
    void write_clearance(const Clearance& clearance, bool tight, SceneText& text) const;
    [[nodiscard]] std::string axis_text(Axis& axis) const;

    Draw& draw_;
    Question question_;
    double speed_rpm_ = 0.0;
    std::deque<Axis> axes_;  // rows and spaces are pointed to
    std::vector<Clearance> clearances_;
    std::vector<ActiveRow> rows_;  ///< of the clearances
    std::vector<int> moving_;      ///< axes that each row can change
    KnownAnswer answer_;
};

double Machine::sum_at(const Clearance& clearance, double angle, int order) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < clearance.axes.size(); ++k) {
        const Axis& axis = axes_[clearance.axes[k]];
        const double x = axis.x_of(angle);
        if (order > 0 && !axis.moves_at(x)) continue;
        sum += clearance.factors[k] * axis.units().lift / std::pow(axis.units().unit, order) *
               (axis.row(x, order).dot(axis.posing.motion()) + (order == 0 ? axis.advanced_at(angle) : 0.0));
    }
    return sum;
}

/// Where it is locally extreme, at breakpoints and at its ends.
std::vector<Sum> Machine::extremes(const Clearance& clearance) const {
    // Where axes fall back both sides count; the end of the whole revolution is before it.
    const double before_fall = std::nextafter(turn_angle, 0.0);
    std::vector<double> angles = {clearance.from,
                                  clearance.until == turn_angle ? before_fall : clearance.until};
    if (clearance.until > turn_angle) angles.insert(angles.end(), {before_fall, turn_angle});
    for (const std::size_t axis : clearance.axes)
        for (const double angle : axes_[axis].master_angles())
            for (const double one : {angle, angle + turn_angle})
                if (one > clearance.from && one < clearance.until) angles.push_back(one);
    std::ranges::sort(angles);
    const std::vector<double> breaks = angles;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double from = breaks[i], to = breaks[i + 1];
        if (to - from < 1e-12) continue;  // one breakpoint but for rounding
        Polynomial sum;
        for (std::size_t k = 0; k < clearance.axes.size(); ++k) {
            const Axis& axis = axes_[clearance.axes[k]];
            sum = sum_of(std::move(sum), axis.between(from, to),
                         static_cast<long double>(clearance.factors[k]) * axis.units().lift);
        }
        for (const long double u : roots_within(derivative_of(sum), 0.0L, 1.0L))
            angles.push_back(from + (to - from) * static_cast<double>(u));
    }
    std::vector<Sum> found;
    for (const double angle : angles) found.push_back({angle, sum_at(clearance, angle)});
    return found;
}

int Machine::moving_at(const Clearance& clearance, double angle) const {
    int count = 0;
    for (std::size_t k = 0; k < clearance.axes.size(); ++k)
        count += clearance.factors[k] != 0.0 &&
                 axes_[clearance.axes[k]].moves_at(axes_[clearance.axes[k]].x_of(angle));
    return count;
}

ActiveRow Machine::row_at(const Clearance& clearance, double angle) const {
    Index size = 0;
    for (const Axis& axis : axes_) size += axis.space().size();
    ActiveRow row;
    row.of = ActiveRow::Of::clearance;
    row.sign = -1.0;
    row.scale = clearance.scale;
    row.size = std::abs(clearance.at_least);
    row.gradient = VectorXd::Zero(size);
    Index first = 0;
    for (std::size_t a = 0; a < axes_.size(); first += axes_[a++].space().size()) {
        const auto own = std::ranges::find(clearance.axes, a) - clearance.axes.begin();
        if (own == std::ssize(clearance.axes)) continue;
        const Axis& axis = axes_[a];
        const double x = axis.x_of(angle);
        const double weight = clearance.factors[static_cast<std::size_t>(own)] * axis.units().lift;
        row.gradient.segment(first, axis.space().size()) = weight * axis.row(x);
        // Its location is the difference of two angles of the master.
        const double slope = axis.row(x, 1).dot(axis.posing.motion()) * 2.0 * turn_angle / axis.units().unit;
        row.size += std::abs(weight) *
                    (std::abs(slope) + std::abs(axis.advanced_at(angle)) +
                     axis.posing.size_of(derivative_alone(0), {x, axis.space().piece_of(x), 0.0}, 0.0));
    }
    return row;
}

bool Machine::stretch_from(Clearance& clearance, double angle) {
    const bool onward = sum_at(clearance, angle, 1) > 0.0;
    const double least = sum_at(clearance, angle);
    double reach = draw_.sized(0.02, 1.5);
    for (int tries = 0; tries < 8; ++tries, reach *= 0.4) {
        clearance.from = onward ? angle : angle - reach;
        clearance.until = onward ? angle + reach : angle;
        if (clearance.from < 0.0) clearance.until += turn_angle;
        if (clearance.from < 0.0) clearance.from += turn_angle;
        if (std::ranges::all_of(extremes(clearance),
                                [&](const Sum& one) { return one.value >= least - 1e-13 * std::abs(least); }))
            return true;
    }
    return false;
}

std::optional<Clearance> Machine::drawn_clearance() {
    Clearance clearance;
    const auto any = static_cast<std::size_t>(draw_.whole(0, static_cast<int>(axes_.size()) - 1));
    for (std::size_t k = 0; k < axes_.size(); ++k) {
        if (axes_[k].units().swings != axes_[any].units().swings) continue;
        if (k != any && !draw_.chance(0.85)) continue;
        const double size = draw_.chance(0.5) ? 1.0 : draw_.between(0.2, 2.0);
        clearance.axes.push_back(k);
        clearance.factors.push_back(draw_.chance(0.5) ? size : -size);
        clearance.scale += size * axes_[k].units().lift;
    }
    if (draw_.chance(0.8)) {
        const double angle = draw_.between(0.0, turn_angle);
        if (moving_at(clearance, angle) == 0 || !stretch_from(clearance, angle)) return {};
    } else if (draw_.chance(0.5)) {
        clearance.from = draw_.between(0.0, turn_angle);
        clearance.until = clearance.from + draw_.between(0.3, 6.0);
    }
    clearance.at_least = std::ranges::min(extremes(clearance), {}, &Sum::value).value;
    return clearance;
}

void Machine::add_rows(const Clearance& clearance) {
    for (const Sum& one : extremes(clearance)) {
        const double above = one.value - clearance.at_least;
        const int moving = moving_at(clearance, one.angle);
        if (moving == 0 || above > same_peak * clearance.scale) continue;
        ActiveRow row = row_at(clearance, one.angle);
        row.owner = clearances_.size();
        row.gap = above;
        // Of several axes first: they are what makes one problem of them.
        row.preference = (moving > 1 ? 3.0 : 1.0) * draw_.between(0.5, 1.0);
        rows_.push_back(std::move(row));
        moving_.push_back(moving);
    }
}

void Machine::add_clearances() {
    Index freedom = 0;
    for (const Axis& axis : axes_) freedom += axis.space().freedom();
    for (Index tries = 0; tries < freedom + 4; ++tries) {
        std::optional<Clearance> clearance = drawn_clearance();
        if (!clearance) continue;
        if (draw_.chance(0.06)) clearance->loosened = draw_.between(0.02, 0.5);
        add_rows(*clearance);
        clearances_.push_back(std::move(*clearance));
    }
}

bool Machine::is_coupled() const {
    for (std::size_t k = 0; k < rows_.size(); ++k)
        if (rows_[k].multiplier > 0.0 && moving_[k] > 1) return true;
    return false;
}

bool Machine::is_tight(std::size_t clearance) const {
    return std::ranges::any_of(
        rows_, [&](const ActiveRow& row) { return row.owner == clearance && row.multiplier > 0.0; });
}

bool Machine::tighten(const ActiveRow& row, double by) {
    for (Axis& axis : axes_)
        if (axis.posing.owns(row)) return axis.posing.tighten(row, by);
    clearances_[row.owner].at_least += by;
    return true;
}

bool Machine::pose() {
    Balance balance;
    std::vector<const Posing*> posings;
    for (Axis& axis : axes_) {
        if (!axis.posing.draw_rows(question_.feasible)) return false;
        axis.posing.add_to(balance);
        posings.push_back(&axis.posing);
    }
    add_clearances();
    for (ActiveRow& row : rows_) balance.add(row, true);
    if (!balance.find(question_.feasible) || !is_coupled()) return false;
    for (Axis& axis : axes_) axis.posing.choose();
    const std::optional<KnownAnswer> answer =
        answer_of(draw_, question_, balance, posings,
                  [&](const ActiveRow& row, double by) { return tighten(row, by); });
    if (answer) answer_ = *answer;
    return answer.has_value();
}

void Machine::write_clearance(const Clearance& clearance, bool tight, SceneText& text) const {
    SceneTable& table = text.append("clearance");
    std::vector<std::string> names;
    for (const std::size_t axis : clearance.axes) names.push_back(quoted(axis_names[axis]));
    table.set("between", fmt::format("[{}]", fmt::join(names, ", ")));
    table.set("factors", list_text(clearance.factors));
    const double at_least = clearance.at_least - (tight ? 0.0 : clearance.loosened * clearance.scale);
    const Units one{.lift = 1.0, .swings = axes_[clearance.axes.front()].units().swings};
    Spelling spelling;
    while (spelling.ending.empty()) spelling = drawn_spelling(draw_, one, 0, 1.0);  // it has no unit of lifts
    table.set("at_least" + spelling.ending, at_least * spelling.factor);
    if (clearance.from == 0.0 && clearance.until == turn_angle) return;
    const bool degrees = draw_.chance(0.7);
    const double size = degrees ? degree_angle : 1.0;
    table.set(degrees ? "from_deg" : "from_rad", clearance.from / size);
    table.set(degrees ? "to_deg" : "to_rad",
              (clearance.until > turn_angle ? clearance.until - turn_angle : clearance.until) / size);
}

SceneText Machine::written() const {
    SceneText text;
    text.at("machine").set("speed_rpm", speed_rpm_);
    for (std::size_t k = 0; k < axes_.size(); ++k) {
        SceneTable& table = text.append("axis");
        table.set("name", quoted(axis_names[k]));
        table.set("scene", quoted(fmt::format("{}.toml", axis_names[k])));
        if (axes_[k].phase_deg != 0.0) table.set("phase_deg", axes_[k].phase_deg);
    }
    for (std::size_t k = 0; k < clearances_.size(); ++k)
        if (is_tight(k) || clearances_[k].loosened >= 0.0) write_clearance(clearances_[k], is_tight(k), text);
    return text;
}

/// Its own speed, if it has one, is not that of the machine.
std::string Machine::axis_text(Axis& axis) const {
    SceneText text = axis.posing.written();
    SceneTable& motion = text.at("motion");
    motion.erase("speed_rpm");
    if (draw_.chance(0.6)) motion.set("speed_rpm", static_cast<double>(draw_.whole(20, 600)));
    return text.text();
}

KnownScene Machine::scene() {
    KnownScene scene{known_kind_name(machine_kind), "", written().text(), {}, answer_};
    for (std::size_t k = 0; k < axes_.size(); ++k) {
        scene.axes.push_back({fmt::format("{}.toml", axis_names[k]), axis_text(axes_[k])});
        const std::string& change = axes_[k].posing.draft().change;
        // These are not moved, regardless of what else is extreme.
        if (scene.change.empty() || change == "narrow corridors") scene.change = change;
    }
    return scene;
}

}  // namespace

std::optional<KnownScene> drawn_machine(Draw& draw, const Question& question, bool edges) {
    Machine machine(draw, question, edges);
    if (!machine.pose()) return {};
    return machine.scene();
}

}  // namespace camopt::soak
