// SPDX-License-Identifier: MIT
// A thousand solves leave nothing behind: the bytes in use by malloc, and the memory of the process.
#include "tests/bindings/c/c_face.hpp"

#include <fstream>
#include <malloc.h>
#include <unistd.h>

namespace camopt {
namespace c_leaks_test {

using namespace testing_support;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool malloc_is_counted = false;
#else
constexpr bool malloc_is_counted = true;
#endif

int count_row(const camopt_sweep_row*, void* user) {
    return ++*static_cast<int*>(user) >= 3 ? 1 : 0;
}

/// All that a program does with a scene, errors and a cancelled sweep too.
void use_once(int number) {
    const CScene scene = c_scene(paper_toml);
    EXPECT_OK(camopt_set_number(scene.get(), "spline.segments", 6 + number % 3));
    EXPECT_EQ(camopt_set_number(scene.get(), "spline.segmnts", 6), CAMOPT_ERROR_INPUT);
    const CSolution solution = c_solved(scene);
    EXPECT_EQ(summary_of(solution).verdict, CAMOPT_OPTIMAL);
    EXPECT_FALSE(text_of(solution, CAMOPT_RESULT_JSON).empty());
    EXPECT_FALSE(text_of(solution, CAMOPT_MOTION_CSV).empty());
    if (number % 10 != 0) return;
    const char* const keys[] = {"objective.jerk"};
    const double values[] = {0.1, 0.2, 0.3, 0.4};
    const camopt_sweep_axis axis{keys, 1, values, 4};
    int rows = 0;
    EXPECT_EQ(camopt_sweep(scene.get(), &axis, 1, nullptr, count_row, &rows), CAMOPT_ERROR_CANCELLED);
}

long resident_bytes() {
    std::ifstream file("/proc/self/statm");
    long all = 0, resident = 0;
    file >> all >> resident;
    return resident * ::sysconf(_SC_PAGESIZE);
}

TEST(CLeaks, AThousandSolvesLeaveNothing) {
    for (int i = 0; i < 100; ++i) use_once(i);
    const auto used_before = mallinfo2().uordblks;
    const long resident_before = resident_bytes();
    for (int i = 100; i < 1100; ++i) use_once(i);
    const long used = static_cast<long>(mallinfo2().uordblks) - static_cast<long>(used_before);
    const long resident = resident_bytes() - resident_before;
    RecordProperty("malloc_growth_bytes", std::to_string(used));
    RecordProperty("resident_growth_bytes", std::to_string(resident));
    std::printf("growth over 1000 solves: %ld bytes in use, %ld bytes resident\n", used, resident);
    if (!malloc_is_counted) {
        std::printf("SKIPPED: a sanitizer has a malloc of its own; its leak check looks at this program\n");
        return;
    }
    EXPECT_LT(used, 4096);         // one byte a solve is 1000
    EXPECT_LT(resident, 4 << 20);  // fragments of the heap
}

}  // namespace c_leaks_test
}  // namespace camopt
