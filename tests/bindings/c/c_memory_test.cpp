// SPDX-License-Identifier: MIT
// No memory is left at the n-th allocation, for one n after another: the call says so, or does without;
// nothing is lost, what was made before still works. The operators below serve the library too. Left out are
// TOML read and JSON written: toml++ and nlohmann-json allocate where they may not throw.
#include "tests/bindings/c/c_face.hpp"

#include <cstdlib>
#include <new>

namespace {

thread_local long allocations_left = -1;  // < 0: as many as there are
thread_local bool was_refused = false;

void* allocated(std::size_t size) {
    if (allocations_left == 0) {
        was_refused = true;
        throw std::bad_alloc();
    }
    if (allocations_left > 0) --allocations_left;
    void* const memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocated(size);
}
void* operator new[](std::size_t size) {
    return allocated(size);
}
// Those that do not throw too: a sanitizer's own would not fit the delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    try {
        return allocated(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void* operator new[](std::size_t size, const std::nothrow_t& tag) noexcept {
    return operator new(size, tag);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

// Eigen 3.4 loses the first of a sparse matrix's arrays where there is no memory for the second, while it
// copies.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:Eigen::SparseMatrix<double, *, int>::resize\n";
}

namespace camopt {
namespace {

using namespace testing_support;

/// Runs a call with 0, step, 2 step, … allocations until it needs no more. Returns how many it needs, to
/// `step`.
template <class Call>
long refused_everywhere(Call&& call, long step) {
    for (long left = 0; left < 100'000'000; left += step) {
        was_refused = false;
        allocations_left = left;
        const camopt_error code = call();
        allocations_left = -1;
        if (!was_refused) {
            EXPECT_EQ(code, CAMOPT_OK) << camopt_error_text();
            return left;
        }
        if (code != CAMOPT_OK) {
            EXPECT_EQ(code, CAMOPT_ERROR_MEMORY) << left << ": " << camopt_error_text();
            EXPECT_NE(std::string(camopt_error_text()).find("no memory was left"), std::string::npos);
        }
        if (::testing::Test::HasFailure()) return left;
    }
    ADD_FAILURE() << "has no end";
    return 0;
}

TEST(CMemory, ScenesSayWhereThereIsNone) {
    const CScene scene = c_scene(paper_toml);
    const auto copy = [&] {
        camopt_scene* made = nullptr;
        const camopt_error code = camopt_scene_copy(scene.get(), &made);
        EXPECT_EQ(made == nullptr, code != CAMOPT_OK);
        camopt_scene_free(made);
        return code;
    };
    EXPECT_GT(refused_everywhere(copy, 1), 10);
    EXPECT_GT(refused_everywhere([&] { return camopt_scene_check(scene.get()); }, 1), 10);
    EXPECT_EQ(toml_of(scene), paper_toml);
    const auto set = [&] {
        const camopt_error code = camopt_set_number(scene.get(), "motion.speed_rpm", 300.5);
        if (code != CAMOPT_OK) {
            allocations_left = -1;
            EXPECT_EQ(toml_of(scene), paper_toml);
        }
        return code;
    };
    EXPECT_GT(refused_everywhere(set, 1), 10);
    EXPECT_GT(refused_everywhere([&] { return camopt_unset(scene.get(), "motion.speed_rpm"); }, 1), 10);
    const auto write = [&] {
        camopt_text text{};
        const camopt_error code = camopt_scene_to_toml(scene.get(), &text);
        EXPECT_EQ(text.data == nullptr, code != CAMOPT_OK);
        camopt_text_free(&text);
        return code;
    };
    EXPECT_GT(refused_everywhere(write, 1), 1);
}

TEST(CMemory, SolveAndTextsReportExhaustion) {
    const CScene scene = c_scene(paper_toml);
    const CSolution before = c_solved(scene);
    const auto solve = [&] {
        camopt_solution* made = nullptr;
        const camopt_error code = camopt_solve(scene.get(), nullptr, &made);
        EXPECT_EQ(made == nullptr, code != CAMOPT_OK);
        camopt_solution_free(made);
        return code;
    };
    EXPECT_GT(refused_everywhere(solve, 1), 1000);
    // Not the report, which reads its scene again: where memory ends inside toml++ the program ends
    // (camopt.h).
    for (const camopt_document document : {CAMOPT_MOTION_CSV, CAMOPT_MOTION_SVG}) {
        const auto write = [&] {
            camopt_text text{};
            const camopt_error code = camopt_solution_text(before.get(), document, &text);
            EXPECT_EQ(text.data == nullptr, code != CAMOPT_OK);
            camopt_text_free(&text);
            return code;
        };
        EXPECT_GT(refused_everywhere(write, 7), 10);
    }
    EXPECT_EQ(text_of(before, CAMOPT_MOTION_CSV), text_of(c_solved(scene), CAMOPT_MOTION_CSV));
}

}  // namespace
}  // namespace camopt
