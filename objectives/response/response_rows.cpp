// SPDX-License-Identifier: MIT
#include "objectives/response/train_figures.hpp"

namespace camopt {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double same_event_x = 1e-9;

AffineRow scaled_row(AffineRow row, double factor) {
    row.offset *= factor;
    for (double& weight : row.weights) weight *= factor;
    return row;
}

/// A spline piece: y^{(k+1)} / k! · width^k at its begin.
AffinePiece spline_piece(const MotionFamily& family, const MotionFamily::Piece& piece, int degree) {
    AffinePiece result{piece.begin, piece.end - piece.begin, {}};
    double factor = 1.0;
    for (int k = 0; k < degree; ++k) {
        if (k > 0) factor *= result.width / k;
        result.slope.push_back(scaled_row(family.functional(piece.begin, k + 1, Side::right), factor));
    }
    return result;
}

/// A fixed shape between two displacements, subdivided as its slope requires.
void add_shape(std::vector<AffinePiece>& pieces, const MotionFamily::Stretch& stretch,
               const TrainFormulas& formulas) {
    const double width = stretch.end - stretch.begin;
    const AffineRow rise = combined(stretch.to, -1.0, stretch.from);
    for (const SlopePiece& part : formulas.pieces(*stretch.shape)) {
        AffinePiece piece{stretch.begin + width * part.begin, width * part.width, {}};
        for (const double coefficient : part.slope)
            piece.slope.push_back(scaled_row(rise, coefficient / width));
        pieces.push_back(std::move(piece));
    }
}

void add_stretch(std::vector<AffinePiece>& pieces, const MotionFamily& family, const MotionStretch& where,
                 const TrainFormulas& formulas) {
    const std::size_t before = pieces.size();
    int last_shape = -1;
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (piece.begin < where.begin - same_event_x || piece.end > where.end + same_event_x) continue;
        const MotionFamily::Stretch& stretch = family.stretches()[piece.stretch];
        if (stretch.kind == StretchRequest::Kind::dwell) {
            pieces.push_back({piece.begin, piece.end - piece.begin, {}});
        } else if (stretch.kind == StretchRequest::Kind::spline) {
            pieces.push_back(spline_piece(family, piece, family.run_space(stretch.run).degree()));
        } else if (piece.stretch != last_shape) {
            last_shape = piece.stretch;
            add_shape(pieces, stretch, formulas);
        }
    }
    if (pieces.size() == before) pieces.push_back({where.begin, where.end - where.begin, {}});
}

void add_product(MatrixXd& state, const VectorXd& direction, const AffineRow& row, double factor) {
    for (std::size_t k = 0; k < row.columns.size(); ++k)
        state.col(row.columns[k]) += factor * row.weights[k] * direction;
    state.col(state.cols() - 1) += factor * row.offset * direction;
}

}  // namespace

EventRows::EventRows(const MotionFamily& family, const MotionEvent& event, const TrainFormulas& formulas)
    : entries_(family.size()) {
    for (const MotionStretch& stretch : event.moving) add_stretch(pieces_, family, stretch, formulas);
    moving_ = pieces_.size();
    for (const MotionStretch& stretch : event.dwell) add_stretch(pieces_, family, stretch, formulas);
}

MatrixXd EventRows::advanced(const TrainAtSpeed& train, std::size_t pieces, double rest) const {
    MatrixXd state = MatrixXd::Zero(train.states(), entries_ + 1);
    const AffinePiece* before = nullptr;
    TrainAtSpeed::Step step;
    double step_width = -1.0;
    std::size_t step_size = 0;
    const auto advance = [&](const AffinePiece& piece, double part) {
        const double width = part * piece.width;
        const std::size_t size = std::max<std::size_t>(1, piece.slope.size());
        if (step_size != size || std::abs(width - step_width) > 1e-13 * width) {
            step = train.step(width, static_cast<int>(size) - 1);
            step_width = width;
            step_size = size;
        }
        state = step.state * state;
        double power = 1.0;
        for (std::size_t k = 0; k < piece.slope.size(); ++k, power *= part)
            add_product(state, step.drive.col(static_cast<Eigen::Index>(k)), piece.slope[k], power);
    };
    // A jump of y' (a joint of moving laws, or round-off of a spline) is an impulse on the train.
    const auto kick = [&](const AffinePiece* from, const AffinePiece* to) {
        if (from)
            for (const AffineRow& row : from->slope) add_product(state, train.kick(), row, -1.0);
        if (to && !to->slope.empty()) add_product(state, train.kick(), to->slope.front(), 1.0);
    };
    for (std::size_t i = 0; i < pieces; ++i) {
        kick(before, &pieces_[i]);
        advance(pieces_[i], 1.0);
        before = &pieces_[i];
    }
    const bool inside = rest > 0.0 && pieces < pieces_.size();
    kick(before, inside ? &pieces_[pieces] : nullptr);
    if (inside) advance(pieces_[pieces], rest);
    return state;
}

MatrixXd EventRows::state_at(const TrainAtSpeed& train, double x) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const AffinePiece& piece = pieces_[i];
        if (x < piece.begin - same_event_x || x > piece.begin + piece.width + same_event_x) continue;
        const double t = std::clamp((x - piece.begin) / piece.width, 0.0, 1.0);
        // t = 0 is the piece's begin, after the impulse there.
        return advanced(train, i, std::max(t, 1e-300));
    }
    return advanced(train, pieces_.size(), 0.0);
}

}  // namespace camopt
