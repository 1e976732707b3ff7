// SPDX-License-Identifier: MIT
// A result depends on the scene and its seed, not on what the process did before: the same scene again, in a
// heap of another shape and with other leftovers in it, gives every digit again.
#include "report/json/result_json.hpp"
#include "solvers/registry.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <memory>
#include <random>
#include <string>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace camopt {
namespace same_result_test {

using Json = nlohmann::ordered_json;

struct Case {
    std::string name, scene;
    std::vector<std::string> settings;
    friend void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
};

void drop_seconds(Json& json) {
    if (json.is_object()) {
        for (auto entry = json.begin(); entry != json.end();) {
            if (entry.key().find("seconds") != std::string::npos && entry.key() != "max_seconds")
                entry = json.erase(entry);
            else
                drop_seconds(*entry++);
        }
    } else if (json.is_array()) {
        for (Json& entry : json) drop_seconds(entry);
    }
}

/// Blocks of many sizes, filled with leftovers, every other one given back.
class Disorder {
 public:
    explicit Disorder(unsigned seed) {
        std::mt19937 random(seed);
#ifdef __GLIBC__
        mallopt(M_PERTURB, static_cast<int>(seed % 255));  // what is allocated is never zero by chance
#endif
        for (int k = 0; k < 4000; ++k) {
            const std::size_t size = 8 * (1 + random() % 600);
            blocks_.emplace_back(new unsigned char[size]);
            std::memset(blocks_.back().get(), static_cast<int>(random() % 255), size);
        }
        for (std::size_t k = 0; k < blocks_.size(); k += 2) blocks_[k].reset();
    }
    ~Disorder() {
#ifdef __GLIBC__
        mallopt(M_PERTURB, 0);
#endif
    }
    Disorder(const Disorder&) = delete;
    Disorder& operator=(const Disorder&) = delete;

 private:
    std::vector<std::unique_ptr<unsigned char[]>> blocks_;
};

class SameResult : public testing::TestWithParam<Case> {
 protected:
    Scene scene() const {
        return testing_support::scene_named(GetParam().scene)
            .with_all(GetParam().settings)
            .with("solver.max_seconds=1e6");
    }
    bool is_available() const {
        for (const std::string& setting : GetParam().settings)
            for (const SolverEntry& entry : solver_entries())
                if (setting == "solver.name=" + entry.name && !entry.available) return false;
        return true;
    }
};

TEST_P(SameResult, ToTheLastDigit) {
    if (!is_available()) GTEST_SKIP() << "the solver is not part of this build";
    const Scene scene = this->scene();
    Json first;
    for (unsigned again = 0; again < 3; ++again) {
        const Disorder disorder(17 * again + 1);
        Json json = Json::parse(result_json(solve(scene)));
        drop_seconds(json);
        if (again == 0) first = json;
        ASSERT_EQ(Json::diff(first, json), Json::array()) << "time " << again;
    }
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"linear", "drd_cubic_12", {}},
        {"infeasible", "cam_infeasible", {"spline.segments=8"}},
        {"free_breakpoints", "drd_free_knots", {"spline.segments=4", "solver.starts=2"}},
        {"knife", "cam_knife", {"spline.segments=8", "solver.starts=2"}},
        {"roller", "cam_undercut", {"spline.segments=8", "solver.starts=2"}},
        {"flat", "cam_flat", {"spline.segments=8", "solver.starts=2"}},
        {"arm_roller", "cam_arm_roller", {"spline.segments=8", "solver.starts=2"}},
        {"arm_flat", "cam_arm_flat", {"spline.segments=8", "solver.starts=2"}},
        {"arm_flat_structured",
         "cam_arm_flat",
         {"spline.segments=8", "solver.starts=2", "solver.name=structured"}},
        {"barrel", "barrel_paper_cup", {"spline.segments=6", "solver.starts=1"}},
        {"cylinder", "cylinder_slide", {"spline.segments=6", "solver.starts=1"}},
        {"tappet", "tappet_75", {"spline.segments=6", "solver.starts=1", "solver.name=structured"}},
        {"tappet_ipopt", "tappet_75", {"spline.segments=6", "solver.starts=1", "solver.name=ipopt"}},
        {"guide", "inverse_feeder", {"spline.segments=6", "solver.starts=1"}},
        {"torque", "drd_torque", {"spline.segments=8", "solver.starts=2"}},
        {"ipopt", "drd_cubic_12", {"solver.name=ipopt"}},
        {"slsqp", "drd_cubic_8", {"solver.name=nlopt.slsqp"}},
        {"cobyla", "drd_cubic_4", {"solver.name=nlopt.cobyla"}},
        {"mma", "drd_cubic_4", {"solver.name=nlopt.mma"}},
        {"ccsaq", "drd_cubic_4", {"solver.name=nlopt.ccsaq"}},
        {"isres", "drd_cubic_4", {"solver.name=nlopt.isres"}},
    };
    return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameResult, testing::ValuesIn(cases()),
                         [](const auto& one) { return one.param.name; });

}  // namespace same_result_test
}  // namespace camopt
