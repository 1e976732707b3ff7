// SPDX-License-Identifier: MIT
#include "splines/motion_family.hpp"

#include "core/errors.hpp"
#include "splines/design_forms.hpp"

namespace camopt {

std::optional<double> known_displacement(const AffineRow& row) {
    if (!row.columns.empty() || !std::isfinite(row.offset)) return {};
    return row.offset;
}

MotionFamily::MotionFamily(DesignVector single) {
    const SplineSpace& space = single.space();
    stretches_.push_back({StretchRequest::Kind::spline,
                          space.begin(),
                          space.end(),
                          0,
                          0.0,
                          nullptr,
                          {single.begin_state()[0], {}, {}},
                          {single.end_state()[0], {}, {}}});
    equalities_ = single.equalities();
    first_joint_ = size_ = single.size();
    Run run{std::move(single), 0, {}};
    for (int i = 0; i < run.design.space().segments(); ++i) run.maps.push_back(run.design.local_map(i));
    runs_.push_back(std::move(run));
    add_pieces();
}

void MotionFamily::add_pieces() {
    for (int s = 0; s < static_cast<int>(stretches_.size()); ++s) {
        const Stretch& stretch = stretches_[s];
        if (stretch.kind == StretchRequest::Kind::dwell) {
            pieces_.push_back({stretch.begin, stretch.end, s, -1});
        } else if (stretch.kind == StretchRequest::Kind::shape) {
            const std::vector<double> points = stretch.shape->breakpoints();
            const double width = stretch.end - stretch.begin;
            for (std::size_t i = 0; i + 1 < points.size(); ++i) {
                pieces_.push_back(
                    {stretch.begin + width * points[i], stretch.begin + width * points[i + 1], s, -1});
            }
            pieces_.back().end = stretch.end;
        } else {
            const SplineSpace& space = run_space(stretch.run);
            const int first = space.breakpoint_at(stretch.begin + stretch.shift);
            const int last = space.breakpoint_at(stretch.end + stretch.shift);
            for (int i = first; i < last; ++i) {
                pieces_.push_back({space.breakpoints()[i] - stretch.shift,
                                   space.breakpoints()[i + 1] - stretch.shift, s, i});
            }
            // Shifting back and forth is not exact; a point past the end by the last digit belongs to the
            // next interval.
            pieces_[pieces_.size() - static_cast<std::size_t>(last - first)].begin = stretch.begin;
            pieces_.back().end = stretch.end;
        }
    }
    for (Piece& piece : pieces_) {
        piece.copy = stretches_[static_cast<std::size_t>(piece.stretch)].copy;
        piece_begins_.push_back(piece.begin);
    }
}

MotionFamily MotionFamily::cam_motions(const DerivativeCombination& of) const {
    MotionFamily family = *this;
    for (Run& run : family.runs_) {
        for (LocalMap& map : run.maps) map = combined(std::move(map), of);
        run.combined_space = combined(run.design.space(), of);
    }
    for (Stretch& stretch : family.stretches_) {
        if (stretch.kind == StretchRequest::Kind::shape)
            throw InputError(
                "the output of a train: found a fixed shape in its motion; allowed: dwells and splines");
        if (stretch.kind != StretchRequest::Kind::dwell) continue;
        for (AffineRow* const end : {&stretch.from, &stretch.to}) {
            end->offset *= of.weights[0];
            for (double& weight : end->weights) weight *= of.weights[0];
        }
    }
    for (Stretch& stretch : family.stretches_) {
        if (stretch.kind != StretchRequest::Kind::spline) continue;
        stretch.from = family.functional(stretch.begin, 0, Side::right);
        stretch.to = family.functional(stretch.end, 0, Side::left);
    }
    return family;
}

std::string MotionFamily::name(int index) const {
    if (index >= first_joint_) return joints_[index - first_joint_].first;
    int run = runs() - 1;
    while (runs_[run].first > index) --run;
    const std::string own = runs_[run].design.name(index - runs_[run].first);
    return runs() == 1 ? own : own + " of run " + std::to_string(run + 1);
}

int MotionFamily::order(int index) const {
    if (index >= first_joint_) return joints_[index - first_joint_].second;
    int run = runs() - 1;
    while (runs_[run].first > index) --run;
    return runs_[run].design.order(index - runs_[run].first);
}

std::optional<double> MotionFamily::place(int index) const {
    if (index >= first_joint_) return {};
    int run = runs() - 1;
    while (runs_[static_cast<std::size_t>(run)].first > index) --run;
    const DesignVector& design = runs_[static_cast<std::size_t>(run)].design;
    if (design.kind() != DesignKind::states) return {};
    const double own = design.place(index - first_entry(run));
    for (const Stretch& stretch : stretches_)  // of a run across the start: either side is valid
        if (stretch.run == run && own - stretch.shift >= stretch.begin && own - stretch.shift <= stretch.end)
            return own - stretch.shift;
    return {};
}

AffineRow MotionFamily::functional(double x, int order, Side side) const {
    const Piece& piece = pieces_[piece_of(x, side)];
    const Stretch& stretch = stretches_[piece.stretch];
    if (stretch.kind == StretchRequest::Kind::spline) {
        const double own = x + stretch.shift - run_space(stretch.run).breakpoints()[piece.segment];
        return functional_of(runs_[stretch.run].maps[piece.segment], own, order);
    }
    AffineRow row;
    if (order == 0) row = stretch.from;
    if (stretch.kind == StretchRequest::Kind::dwell) return row;
    const double width = stretch.end - stretch.begin;
    const double own = std::clamp((x - stretch.begin) / width, 0.0, 1.0);
    const double shape = stretch.shape->at(own, side).derivative[order] / std::pow(width, order);
    return combined(combined(row, shape, stretch.to), -shape, stretch.from);
}

std::vector<ConditionConflict> MotionFamily::redundant() const {
    std::vector<ConditionConflict> all;
    for (const Run& run : runs_) {
        all.insert(all.end(), run.design.redundant().begin(), run.design.redundant().end());
    }
    return all;
}

std::vector<ConditionConflict> MotionFamily::contradictions() const {
    for (const Run& run : runs_) {  // of one run: their rows count its own control points
        if (!run.design.contradictions().empty()) return run.design.contradictions();
    }
    return {};
}

std::vector<int> MotionFamily::reported_entries() const {
    std::vector<int> entries;
    for (const Run& run : runs_) {
        for (const int own : run.design.reported_entries()) entries.push_back(run.first + own);
    }
    for (int entry = first_joint_; entry < size_; ++entry) entries.push_back(entry);
    return entries;
}

SplineCurve MotionFamily::run_curve(int run, const Eigen::VectorXd& x) const {
    const Run& own = runs_[run];
    const SplineSpace& space = run_space(run);
    Eigen::MatrixXd pieces(space.degree() + 1, space.segments());
    for (int i = 0; i < space.segments(); ++i) pieces.col(i) = own.maps[i].polynomial(x);
    return {space, std::move(pieces)};
}

MotionChain MotionFamily::motion(const Eigen::VectorXd& x) const {
    std::vector<std::shared_ptr<const Motion>> curves;
    curves.reserve(runs_.size());
    for (int r = 0; r < runs(); ++r) curves.push_back(std::make_shared<SplineCurve>(run_curve(r, x)));
    std::vector<ChainPart> parts;
    for (const Stretch& stretch : stretches_) {
        ChainPart part{stretch.begin, stretch.end, nullptr, 0.0, 1.0, 0.0, 1.0};
        if (stretch.kind == StretchRequest::Kind::spline) {
            part.shape = curves[stretch.run];
            part.x0 = -stretch.shift;
        } else {
            part.y0 = stretch.from.value(x);
        }
        if (stretch.kind == StretchRequest::Kind::shape) {
            part.shape = stretch.shape;
            part.x0 = stretch.begin;
            part.x_scale = stretch.end - stretch.begin;
            part.y_scale = stretch.to.value(x) - part.y0;
        }
        parts.push_back(std::move(part));
    }
    return MotionChain(std::move(parts));
}

QuadraticForm MotionFamily::mean_square(int order, const std::vector<double>& weights) const {
    EnergySum sum(size_);
    double length = 0.0;
    for (const Piece& piece : pieces_) {
        if (piece.segment < 0 || piece.copy) continue;
        length += piece.end - piece.begin;
        const LocalMap& map = runs_[stretches_[piece.stretch].run].maps[piece.segment];
        const double weight = weights.empty() ? 1.0 : weights[piece.stretch];
        sum.add(map, order, piece.end - piece.begin, weight);
    }
    return sum.form(length > 0.0 ? 1.0 / length : 1.0);
}

}  // namespace camopt
