// SPDX-License-Identifier: MIT
// Writing a result folder evaluates each point of the cam once.
#include "report/folders/result_folder_reader.hpp"
#include "report/page/result_page.hpp"
#include "scene/cam_flanks.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/cam_sheet.hpp"
#include "studies/solve/solve.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/forwarding_cam.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace camopt {
namespace evaluation_count_test {

/// Counts the points of another cam, by angle and station; all else is that cam's.
class CountingCam final : public testing_support::ForwardingCam {
 public:
    using ForwardingCam::ForwardingCam;

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
        return own().point(theta, state, station);
    }
    std::optional<CamFlanks> flanks(std::span<const double> dimensions) const override {
        return own().flanks(dimensions);
    }
    std::optional<RollerGuide> guide(std::span<const double> dimensions) const override {
        return own().guide(dimensions);
    }

 private:
    mutable std::map<std::tuple<double, double, double, int>, int> counts_;
};

TEST(ResultFolder, EvaluatesEachCamPointOnce) {
    for (const std::string name : {"cam_roller", "cam_grooved", "inverse_feeder"}) {
        const testing_support::TestScene scene = testing_support::scene_named(name).with("solver.starts=1");
        Solution solution = solve(name == "cam_grooved" ? scene.with("spline.segments=6") : scene);
        ASSERT_TRUE(solution.cam) << name;
        const auto counting = std::make_shared<CountingCam>(solution.cam->cam.formulas);
        solution.cam->cam.formulas = counting;
        const test::TemporaryFolder folder;
        const View view(solution);
        std::vector<FolderFile> also = result_extras(view);
        std::ranges::move(dxf_files(view), std::back_inserter(also));
        write_result_folder(folder.path(), view, {}, {.also = std::move(also)});
        if (counting->direct() != nullptr) (void)cam_sheets(view);
        EXPECT_GT(counting->places(), 1000U) << name;
        EXPECT_EQ(counting->most(), 1) << name << counting->twice();
    }
}

}  // namespace evaluation_count_test
}  // namespace camopt
