// SPDX-License-Identifier: MIT
#include "dynamics/train_formulas.hpp"

#include "dynamics/linear_train.hpp"
#include "dynamics/motion_pieces.hpp"
#include "dynamics/train_at_speed.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <utility>

namespace camopt {
namespace {

class LinearTrainFormulas final : public TrainFormulas {
 public:
    explicit LinearTrainFormulas(LinearTrain train) : train_(std::move(train)) {
        const Eigen::JacobiSVD<Eigen::MatrixXd> values(train_.elongations());
        frequencies_.assign(values.singularValues().begin(), values.singularValues().end());
        std::ranges::sort(frequencies_);
        vibrates_ = at(1.0, 1.0, 1.0)->modes().rows() > 0;
    }

    [[nodiscard]] std::unique_ptr<const TrainAtSpeed> at(double speed, double unit_angle,
                                                         double lift) const override {
        return std::make_unique<LinearTrainAtSpeed>(train_, speed, unit_angle, lift);
    }
    [[nodiscard]] std::vector<SlopePiece> pieces(const Motion& motion) const override {
        return slope_pieces(motion);
    }
    [[nodiscard]] const std::vector<double>& natural_frequencies() const override { return frequencies_; }
    [[nodiscard]] bool vibrates() const override { return vibrates_; }

 private:
    LinearTrain train_;
    std::vector<double> frequencies_;
    bool vibrates_ = false;
};

}  // namespace

std::shared_ptr<const TrainFormulas> train_formulas(const DynamicsSpec& spec) {
    return std::make_shared<LinearTrainFormulas>(linear_train(spec));
}

void complete_dynamics(Scene& scene) {
    if (scene.dynamics && !scene.dynamics->formulas)
        scene.dynamics->formulas = train_formulas(*scene.dynamics);
}

}  // namespace camopt
