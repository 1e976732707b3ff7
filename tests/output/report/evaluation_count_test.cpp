// SPDX-License-Identifier: MIT
// Writing a result folder evaluates each point of the cam once.
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "output/page/result_page.hpp"
#include "output/report/result_folder_reader.hpp"
#include "output/sheet/cam_sheet.hpp"
#include "scene/cam_flanks.hpp"
#include "studies/solve/solve.hpp"
#include "tests/output/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace camopt {
namespace evaluation_count_test {

/// Counts the points of another cam, by angle and station; all else is that cam's.
class CountingCam final : public CamMechanism {
 public:
    explicit CountingCam(std::shared_ptr<const CamMechanism> cam) : cam_(std::move(cam)) {}

    /// Of one point: the largest.
    [[nodiscard]] int most() const {
        int most = 0;
        for (const auto& [place, count] : counts_) most = std::max(most, count);
        return most;
    }
    /// The first place that was evaluated more than once.
    [[nodiscard]] std::string twice() const {
        for (const auto& [place, count] : counts_)
            if (count > 1) return " at " + std::to_string(std::get<0>(place)) + " rad";
        return {};
    }
    [[nodiscard]] std::size_t places() const { return counts_.size(); }

    MechanismPoint point(double theta, const MechanismState& state, int station) const override {
        // Two sides of a breakpoint are two states at one angle.
        ++counts_[{theta, state.output.velocity, state.output.acceleration, station}];
        return cam_->point(theta, state, station);
    }
    std::string type() const override { return cam_->type(); }
    bool swings() const override { return cam_->swings(); }
    Rotation rotation() const override { return cam_->rotation(); }
    int stations() const override { return cam_->stations(); }
    std::string station_name(int station) const override { return cam_->station_name(station); }
    bool binds(MechanismQuantity which, int station) const override { return cam_->binds(which, station); }
    bool has_all_stations(MechanismQuantity which) const override { return cam_->has_all_stations(which); }
    int roller_radius() const override { return cam_->roller_radius(); }
    int roller_radius_at(int station) const override { return cam_->roller_radius_at(station); }
    double surface_offset(std::span<const double> dimensions, int station) const override {
        return cam_->surface_offset(dimensions, station);
    }
    bool planar() const override { return cam_->planar(); }
    bool has_guide() const override { return cam_->has_guide(); }
    bool is_direct() const override { return cam_->is_direct(); }
    bool has_pitch_curve() const override { return cam_->has_pitch_curve(); }
    int base_radius_index() const override { return cam_->base_radius_index(); }
    std::optional<double> pushed_offset(std::span<const double> dimensions) const override {
        return cam_->pushed_offset(dimensions);
    }
    std::vector<std::vector<SignedIndex>> reach() const override { return cam_->reach(); }
    std::string undercut_words() const override { return cam_->undercut_words(); }
    std::string check_words(int points) const override { return cam_->check_words(points); }
    double length(std::span<const double> dimensions) const override { return cam_->length(dimensions); }
    std::string fault(std::span<const double> dimensions, double least, double most) const override {
        return cam_->fault(dimensions, least, most);
    }
    std::optional<SceneFault> find_fault(const CamSpec& spec, const MotionSpec& motion) const override {
        return cam_->find_fault(spec, motion);
    }
    MechanismValue quantity(MechanismQuantity which, const MechanismState& state, int station,
                            std::span<const int> active) const override {
        return cam_->quantity(which, state, station, active);
    }
    MechanismValue pressure_excess(double limit, int sign, const MechanismState& state, int station,
                                   std::span<const int> active) const override {
        return cam_->pressure_excess(limit, sign, state, station, active);
    }
    Curvature pressure_shape(const PressureSide& side, const MechanismSetting& setting, double least,
                             double most) const override {
        return cam_->pressure_shape(side, setting, least, most);
    }
    Interval pressure_slopes(const PressureSide& side, std::span<const double> dimensions) const override {
        return cam_->pressure_slopes(side, dimensions);
    }
    bool upper_side_rises(int station) const override { return cam_->upper_side_rises(station); }
    bool leans_at_rest(int station, const MechanismSetting& setting) const override {
        return cam_->leans_at_rest(station, setting);
    }
    Curvature shape(MechanismQuantity which, const MechanismSetting& setting) const override {
        return cam_->shape(which, setting);
    }
    double face_turn() const override { return cam_->face_turn(); }
    std::optional<RangeOver> quantity_over(MechanismQuantity which, const MechanismStateOver& state,
                                           int station) const override {
        return cam_->quantity_over(which, state, station);
    }
    std::optional<RangeOver> pressure_over(double limit, int sign, const MechanismStateOver& state,
                                           int station) const override {
        return cam_->pressure_over(limit, sign, state, station);
    }
    std::optional<RangeOver> regularity_over(double margin, const MechanismStateOver& state,
                                             int station) const override {
        return cam_->regularity_over(margin, state, station);
    }
    std::optional<RangeOver> radius_over(double shift, const MechanismStateOver& state,
                                         int station) const override {
        return cam_->radius_over(shift, state, station);
    }
    std::optional<RangeAlong> quantity_along(MechanismQuantity which, const MechanismStateAlong& state,
                                             int station) const override {
        return cam_->quantity_along(which, state, station);
    }
    std::optional<RangeAlong> pressure_along(double limit, int sign, const MechanismStateAlong& state,
                                             int station) const override {
        return cam_->pressure_along(limit, sign, state, station);
    }
    std::string follower_name() const override { return cam_->follower_name(); }
    std::string form_name() const override { return cam_->form_name(); }
    std::string form_words() const override { return cam_->form_words(); }
    std::vector<NamedDimension> named_dimensions(std::span<const double> dimensions) const override {
        return cam_->named_dimensions(dimensions);
    }
    std::optional<Eigen::Vector2d> arm_pivot(std::span<const double> dimensions) const override {
        return cam_->arm_pivot(dimensions);
    }
    std::optional<double> groove_wall(std::span<const double> dimensions) const override {
        return cam_->groove_wall(dimensions);
    }
    std::vector<DrivenMechanism> pieces(std::span<const double> dimensions) const override {
        return cam_->pieces(dimensions);
    }
    double turned(const MechanismState& state) const override { return cam_->turned(state); }
    std::vector<MechanismShape> shapes(const MechanismState& state) const override {
        return cam_->shapes(state);
    }
    std::optional<FollowerGeometry> follower(std::span<const double> dimensions, int station) const override {
        return cam_->follower(dimensions, station);
    }
    std::optional<CamFlanks> flanks(std::span<const double> dimensions) const override {
        return cam_->flanks(dimensions);
    }
    std::optional<RollerGuide> guide(std::span<const double> dimensions) const override {
        return cam_->guide(dimensions);
    }

 private:
    std::shared_ptr<const CamMechanism> cam_;
    mutable std::map<std::tuple<double, double, double, int>, int> counts_;
};

std::vector<std::string> quick(const std::string& name) {
    if (name != "cam_grooved") return {"solver.starts=1"};
    return {"solver.starts=1", "spline.segments=6"};
}

TEST(ResultFolder, EvaluatesEachCamPointOnce) {
    for (const std::string name : {"cam_roller", "cam_grooved", "inverse_feeder"}) {
        Solution solution = solve(input::read_scene_file(source_folder() + "/scenes/" + name + ".toml",
                                                         known_names(), quick(name)));
        ASSERT_TRUE(solution.cam) << name;
        const auto counting = std::make_shared<CountingCam>(solution.cam->cam.formulas);
        solution.cam->cam.formulas = counting;
        const test::TemporaryFolder folder;
        const View view(solution);
        write_result_folder(folder.path(), view, {}, {.dxf = true, .also = result_extras(view)});
        if (counting->is_direct()) (void)cam_sheets(view);
        EXPECT_GT(counting->places(), 1000U) << name;
        EXPECT_EQ(counting->most(), 1) << name << counting->twice();
    }
}

}  // namespace evaluation_count_test
}  // namespace camopt
