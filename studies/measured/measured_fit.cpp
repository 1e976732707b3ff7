// SPDX-License-Identifier: MIT
#include "studies/measured/measured_fit.hpp"

#include "objectives/scene_model.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/delivered/solution_report.hpp"

#include <Eigen/SparseLU>
#include <fmt/format.h>

namespace camopt {

namespace {

// Of the squares' own size: far below the square of what a double can tell of a displacement's error.
constexpr double smoothing = 1e-12;

/// Entries stand for derivatives: in these units they are of the order of displacements.
Eigen::VectorXd entry_units(const MotionFamily& family) {
    const double width = (family.end() - family.begin()) /
                         static_cast<double>(std::max<std::size_t>(1, family.pieces().size()));
    Eigen::VectorXd units(family.size());
    for (int j = 0; j < family.size(); ++j) units[j] = std::pow(width, -family.order(j));
    return units;
}

using Triplets = std::vector<Eigen::Triplet<double>>;

/// The normal equations bordered by the conditions.
class NearestMotion {
 public:
    explicit NearestMotion(const MotionFamily& family)
        : family_(family),
          units_(entry_units(family)),
          right_(Eigen::VectorXd::Zero(size() + conditions())) {}

    void add_rows(const std::vector<MeasuredRow>& rows) {
        const double weight = 1.0 / static_cast<double>(rows.size());
        for (const MeasuredRow& measured : rows) {
            const AffineRow row = family_.functional(measured.x, 0);
            for (std::size_t a = 0; a < row.columns.size(); ++a) {
                const double at = row.weights[a] * units_[row.columns[a]];
                right_[row.columns[a]] += weight * at * (measured.y - row.offset);
                for (std::size_t b = 0; b < row.columns.size(); ++b) {
                    const double value = weight * at * row.weights[b] * units_[row.columns[b]];
                    entries_.emplace_back(row.columns[a], row.columns[b], value);
                    largest_ = std::max(largest_, std::abs(value));
                }
            }
        }
    }

    void smooth() {
        const QuadraticForm energy = family_.mean_square(3);
        double largest = 0.0;
        for (int j = 0; j < size(); ++j)
            largest = std::max(largest, std::abs(energy.matrix.coeff(j, j)) * units_[j] * units_[j]);
        if (!(largest > 0.0)) return;
        const double factor = smoothing * largest_ / largest;
        for (int column = 0; column < energy.matrix.outerSize(); ++column)
            for (Eigen::SparseMatrix<double>::InnerIterator e(energy.matrix, column); e; ++e)
                entries_.emplace_back(e.row(), column, factor * units_[e.row()] * units_[column] * e.value());
        right_.head(size()) -= factor * units_.cwiseProduct(energy.linear);
    }

    void keep_conditions() {
        for (int i = 0; i < conditions(); ++i) {
            const AffineRow& row = family_.equalities()[static_cast<std::size_t>(i)].row;
            double scale = 0.0;
            for (std::size_t k = 0; k < row.columns.size(); ++k)
                scale = std::max(scale, std::abs(row.weights[k] * units_[row.columns[k]]));
            if (!(scale > 0.0)) scale = 1.0;
            for (std::size_t k = 0; k < row.columns.size(); ++k) {
                const double value = row.weights[k] * units_[row.columns[k]] / scale;
                entries_.emplace_back(size() + i, row.columns[k], value);
                entries_.emplace_back(row.columns[k], size() + i, value);
            }
            right_[size() + i] = -row.offset / scale;
        }
    }

    [[nodiscard]] Eigen::VectorXd solved() const {
        Eigen::SparseMatrix<double> system(right_.size(), right_.size());
        system.setFromTriplets(entries_.begin(), entries_.end());
        const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(system);
        Eigen::VectorXd found = Eigen::VectorXd::Zero(right_.size());
        if (factor.info() == Eigen::Success) {
            found = factor.solve(right_);
            found += factor.solve(right_ - system * found);  // what the first left of the equations
        }
        if (factor.info() != Eigen::Success || !found.allFinite())
            throw SceneError(
                {"measured", "rows that do not determine a spline", "rows all along the motion"});
        return units_.cwiseProduct(found.head(size()));
    }

 private:
    const MotionFamily& family_;
    Eigen::VectorXd units_;
    Eigen::VectorXd right_;
    Triplets entries_;
    double largest_ = 0.0;

    [[nodiscard]] int size() const { return family_.size(); }
    [[nodiscard]] int conditions() const { return static_cast<int>(family_.equalities().size()); }
};

/// What the fit is one of: the scene without all that a measured motion need not keep.
Scene space_of(const Scene& scene) {
    Scene plain = scene;
    plain.motion.via.clear();
    for (ProgramSegment& segment : plain.motion.segments) segment.via.clear();
    plain.motion.symmetric = false;
    plain.spline.rest = 2;
    plain.cam.reset();
    plain.forces.reset();
    plain.limits = {};
    plain.own_terms.clear();
    plain.own_limits.clear();
    return plain;
}

bool weighs_motion_alone(const Scene& scene) {
    return scene.own_terms.empty() &&
           std::ranges::none_of(scene.objective.dimensions, [](double weight) { return weight > 0.0; });
}

}  // namespace

Eigen::VectorXd nearest_design(const MotionFamily& family, const Scene& scene) {
    const std::vector<MeasuredRow> rows = measured_rows(scene, family.begin(), family.end());
    if (static_cast<int>(rows.size()) < family.freedom())
        throw SceneError(
            {"measured",
             fmt::format("{} rows for a spline with {} free numbers", rows.size(), family.freedom()),
             "as many rows at least, or fewer spline.segments"});
    NearestMotion nearest(family);
    nearest.add_rows(rows);
    nearest.smooth();
    nearest.keep_conditions();
    return nearest.solved();
}

MeasuredReport measured_report(const Scene& scene, const Peaks& reference) {
    const MeasuredMotion& measured = *scene.measured;
    Solution fit;
    fit.scene = space_of(scene);
    fit.reference_peaks = reference;
    const MotionFamily family = scene_family(fit.scene, DesignKind::states);
    const auto motion = std::make_shared<const MotionChain>(family.motion(nearest_design(family, scene)));
    MeasuredReport report;
    report.name = measured.name;
    report.motion = motion;
    const std::vector<MeasuredRow> rows = measured_rows(scene, family.begin(), family.end());
    report.rows = static_cast<int>(rows.size());
    report.freedom = family.freedom();
    report.laws = nearest_laws(family, scene.motion.type == MotionType::rr, rows);
    const Deviation deviation = deviation_of(rows, *motion);
    report.largest_error = deviation.largest.value;
    report.at = deviation.largest.at;
    report.rms_error = deviation.rms;
    report_delivered(fit, {motion, {}});
    report.peaks = fit.peaks;
    if (weighs_motion_alone(scene)) report.objective = defined_objective(fit);
    return report;
}

bool began_from_measured(const Solution& solution) {
    const Scene& scene = solution.scene;
    return scene.measured && scene.measured->start && !scene.spline.free_knots && !searches_angles(scene) &&
           !solution.solver.convex && solution.solver.starts > 0;
}

}  // namespace camopt
