// SPDX-License-Identifier: MIT
#include "objectives/rules/maxima/between_ends.hpp"

#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"

namespace camopt {

namespace {

// Boxes of one rule. A smooth rule needs some hundreds.
constexpr int most_boxes = 20000;
// Relative to a rule's scale: accuracy of the largest value, far below what passes for a violation.
constexpr double accuracy = 1e-9;
// Relative to a rule's scale: values this far below the limit need not be known exactly.
constexpr double far_below_limit = 0.02;
constexpr std::size_t motion_errors = 3, most_errors = motion_errors + most_tolerant_numbers;

struct BoxOfErrors {
    Interval x;
    std::array<Interval, most_errors> parts;
};

double middle_of(const Interval& a) {
    return 0.5 * (a.lower + a.upper);
}
double magnitude(const Interval& a) {
    return std::max(std::abs(a.lower), std::abs(a.upper));
}

using piece_maxima::SmoothPiece, piece_maxima::ranges_on;

/// One rule along pieces of the motion between two breakpoints.
class Search {
 public:
    Search(BetweenEnds& found, const FreeCam& cam, const std::array<double, motion_errors>& errors,
           int& effort)
        : found_(found),
          cam_(cam),
          errors_(errors),
          errors_in_all_(motion_errors + cam.places.size()),
          scale_(found.rule->scale()),
          effort_(effort) {}

    void run(const SmoothPiece& piece, const Interval& x) {
        piece_ = &piece;
        BoxOfErrors all{x, {}};
        for (std::size_t i = 0; i < errors_in_all_; ++i)
            all.parts[i] = i < motion_errors && errors_[i] == 0.0 ? Interval(1.0) : Interval(-1.0, 1.0);
        open_.assign(1, all);
        while (!open_.empty() && found_.enclosed) {
            if (--effort_ <= 0) {
                found_.enclosed = false;
                return;
            }
            const BoxOfErrors box = open_.back();
            open_.pop_back();
            look_at(box);
        }
    }

 private:
    BetweenEnds& found_;
    const FreeCam& cam_;
    const std::array<double, motion_errors>& errors_;  ///< normalised
    std::size_t errors_in_all_;
    double scale_;
    int& effort_;
    const SmoothPiece* piece_ = nullptr;
    double best_ = -far_below_limit;  ///< so far
    std::vector<BoxOfErrors> open_;

    struct Enclosed {
        RangeOver range;
        Interval by_x;  ///< without an explicit x
    };
    [[nodiscard]] std::optional<Enclosed> over(const BoxOfErrors& box) const {
        const auto y = ranges_on(*piece_, box.x);
        if (!y) return {};
        std::vector<Interval> states(4 + cam_.places.size());
        for (std::size_t r = 0; r < 4; ++r)
            states[r] = r < motion_errors && errors_[r] != 0.0 ? (*y)[r] + Interval(errors_[r]) * box.parts[r]
                                                               : (*y)[r];
        for (std::size_t k = 0; k < cam_.places.size(); ++k) states[4 + k] = box.parts[motion_errors + k];
        auto range = found_.rule->range_over(states, box.x);
        if (!range || std::isnan(range->value.lower) || std::isnan(range->value.upper)) return {};
        range->grow(static_cast<int>(states.size()));
        Enclosed own{*range, Interval(0.0)};
        for (int r = 0; r < 4; ++r)
            own.by_x = enclosing::partial_sum(
                own.by_x, enclosing::partial_product(range->first(r), (*y)[static_cast<std::size_t>(r) + 1]));
        return own;
    }
    /// Of the rule times its factor by part i.
    [[nodiscard]] Interval slope(const RangeOver& range, std::size_t i) const {
        return i < motion_errors
                   ? enclosing::partial_product(Interval(errors_[i]), range.first(static_cast<int>(i)))
                   : range.first(static_cast<int>(i + 1));
    }
    [[nodiscard]] bool is_convex(const RangeOver& range, std::size_t i) const {
        const int place = static_cast<int>(i < motion_errors ? i : i + 1);
        return range.second(place, place).lower >= 0.0;
    }

    /// The rule itself at one cam and one x.
    [[nodiscard]] RuleValue value(const BoxOfErrors& point) const {
        const double x = middle_of(point.x);
        const auto y = ranges_on(*piece_, Interval(x));
        MotionPoint state{x, {}};
        for (std::size_t r = 0; r < 4; ++r)
            state.derivative[r] =
                middle_of((*y)[r]) + (r < motion_errors ? errors_[r] * middle_of(point.parts[r]) : 0.0);
        Eigen::VectorXd q(static_cast<Eigen::Index>(cam_.places.size()));
        for (std::size_t k = 0; k < cam_.places.size(); ++k)
            q[static_cast<Eigen::Index>(k)] = middle_of(point.parts[motion_errors + k]);
        return found_.rule->evaluate(state, q);
    }

    /// The parts that are at an end of their tolerance, all of them.
    [[nodiscard]] bool is_at_ends(const BoxOfErrors& box) const {
        return std::all_of(
            box.parts.begin(), box.parts.begin() + static_cast<std::ptrdiff_t>(errors_in_all_),
            [](const Interval& part) { return part.width() == 0.0 && std::abs(part.lower) == 1.0; });
    }
    void note(const BoxOfErrors& point, double value) {
        const double relative = value / scale_;
        best_ = std::max(best_, relative);
        if (!(relative > found_.worst) || is_at_ends(point)) return;
        found_.worst = relative;
        found_.at = point.x.lower;
        for (std::size_t i = 0; i < motion_errors; ++i) found_.parts.motion[i] = point.parts[i].lower;
        for (std::size_t k = 0; k < cam_.places.size(); ++k)
            found_.parts.numbers[cam_.places[k]] = point.parts[motion_errors + k].lower;
    }

    /// Reduces the box to where the rule is largest in it. False: that is on its border, and the box beside
    /// it has it.
    [[nodiscard]] bool reduce(BoxOfErrors& box, const Enclosed& own, bool& reduced) const {
        for (std::size_t i = 0; i < errors_in_all_; ++i) {
            Interval& part = box.parts[i];
            if (part.width() == 0.0) continue;
            const Interval by = slope(own.range, i);
            const bool grows = by.lower > 0.0, falls = by.upper < 0.0, rests = enclosing::is_zero(by);
            if (!grows && !falls && !rests) continue;
            const double end = falls || (rests && part.lower == -1.0) ? part.lower : part.upper;
            if (!rests && std::abs(end) != 1.0) return false;
            part = Interval(end);
            reduced = true;
        }
        return true;
    }

    void look_at(BoxOfErrors box) {
        std::optional<Enclosed> own = over(box);
        for (bool reduced = true; own && reduced;) {
            reduced = false;
            if (!reduce(box, *own, reduced)) return;
            if (is_at_ends(box)) return note_ends(box);
            if (reduced) own = over(box);
        }
        if (!own) {
            found_.enclosed = false;
            return;
        }
        BoxOfErrors middle = box;
        middle.x = Interval(middle_of(box.x));
        for (Interval& part : middle.parts) part = Interval(middle_of(part));
        const RuleValue here = value(middle);
        const std::optional<Enclosed> at_middle = over(middle);
        if (!at_middle || std::isnan(here.value)) {
            found_.enclosed = false;
            return;
        }
        note(middle, here.value);
        const double factor = factor_of(at_middle->range, here);
        const double by_x = magnitude(own->by_x) + factor * std::abs(here.by_place);
        std::vector<double> rises = {0.5 * box.x.width() * by_x};
        for (std::size_t i = 0; i < errors_in_all_; ++i)
            rises.push_back(0.5 * box.parts[i].width() * magnitude(slope(own->range, i)));
        double most = at_middle->range.value.upper;
        for (const double rise : rises) most += rise;
        // What depends on x itself has no slope: its values are those of the whole box.
        if (here.by_place != 0.0 || !(most < own->range.value.upper)) most = own->range.value.upper;
        if (most <= factor * scale_ * (best_ + accuracy)) return;
        split(box, *own, rises);
    }
    void note_ends(const BoxOfErrors& box) {
        BoxOfErrors middle = box;
        middle.x = Interval(middle_of(box.x));
        note(middle, value(middle).value);
    }
    /// Of the rule in its enclosure: from values, near 0 from their slopes.
    [[nodiscard]] static double factor_of(const RangeOver& range, const RuleValue& here) {
        constexpr double near_zero = 1e-4;
        double factor = middle_of(range.value) / here.value, size = near_zero;
        if (std::abs(here.value) > near_zero) return factor;
        factor = 1.0;
        for (int i = 0; i < std::min(range.size(), static_cast<int>(here.gradient.size())); ++i) {
            const double steep = std::abs(here.gradient[i]);
            if (!(steep > size)) continue;
            size = steep;
            factor = std::abs(middle_of(range.first(i))) / steep;
        }
        return factor;
    }

    void split(const BoxOfErrors& box, const Enclosed& own, const std::vector<double>& rises) {
        const auto widest = static_cast<std::size_t>(std::ranges::max_element(rises) - rises.begin());
        BoxOfErrors one = box, other = box;
        if (widest == 0) {
            one.x.upper = other.x.lower = middle_of(box.x);
        } else if (const std::size_t i = widest - 1; is_convex(own.range, i)) {
            one.parts[i] = Interval(box.parts[i].lower);
            other.parts[i] = Interval(box.parts[i].upper);
            // An end that is none of the tolerance belongs to the box beside it, too.
            if (std::abs(one.parts[i].lower) == 1.0) open_.push_back(one);
            if (std::abs(other.parts[i].lower) == 1.0) open_.push_back(other);
            return;
        } else {
            one.parts[i].upper = other.parts[i].lower = middle_of(box.parts[i]);
        }
        open_.push_back(one);
        open_.push_back(other);
    }
};

/// The stretches of a piece of the motion that the rule holds on.
std::vector<Interval> stretches_of(const SmoothPiece& piece, const CamRule& rule) {
    const auto [begin, end] = piece.piece;
    std::vector<Interval> all;
    for (const double x : rule.places())
        if (x >= begin && x <= end) all.emplace_back(x);
    const auto [from, until] = rule.holds_between();
    const Interval own(std::max(begin, from), std::min(end, until));
    if (rule.places().empty() && own.width() > 0.0) all.push_back(own);
    return all;
}

}  // namespace

std::vector<BetweenEnds> between_ends(const Scene& scene, const CamVariables& drawn, const Motion& motion) {
    const FreeCam free = with_free_numbers(scene, drawn);
    const std::array errors = {scene.motion_error(0), scene.motion_error(1), scene.motion_error(2)};
    const auto* chain = dynamic_cast<const MotionChain*>(&motion);
    std::vector<SmoothPiece> pieces;
    for (std::size_t i = 0; chain != nullptr && i < chain->parts().size(); ++i)
        for (SmoothPiece& piece : piece_maxima::pieces_of(chain->parts()[i]))
            pieces.push_back(std::move(piece));
    std::vector<BetweenEnds> all;
    const auto enclose = [&](const std::shared_ptr<const CamRule>& rule) {
        BetweenEnds own{rule};
        own.parts.numbers.assign(free.places.size(), 0.0);
        own.enclosed = chain != nullptr;
        int effort = most_boxes;
        Search search(own, free, errors, effort);
        for (const SmoothPiece& piece : pieces)
            for (const Interval& x : stretches_of(piece, *rule)) search.run(piece, x);
        all.push_back(std::move(own));
    };
    for (const auto& rule : cam_limits(free.scene, free.variables))
        if (!rule->linear() && rule->highest_order() > 0) enclose(rule);
    // What holds at rest has the slope of the made cam in place of the motion's, and is linear in it.
    for (const double end : {1.0, -1.0}) {
        CamVariables resting = free.variables;
        resting.motion_error[1] = end * scene.tolerance->of_motion(1);
        for (const auto& rule : cam_limits(free.scene, resting))
            if (!rule->linear() && rule->highest_order() == 0) enclose(rule);
    }
    return all;
}

}  // namespace camopt
