// SPDX-License-Identifier: MIT
// peaks_by_sampling FOLDER: peaks looked up on equally spaced samples, as many programs do, against the exact
// extrema.
//
// Writes peaks_by_sampling.csv: curve, samples (0: exact), relative errors of V, A, J, median seconds.
// Samples are equally spaced, both ends included; a sampled peak is never too large.

#include "benchmarks/parts/combination.hpp"
#include "benchmarks/parts/measurement.hpp"
#include "core/text/text_file.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "report/csv/csv_line.hpp"
#include "report/folders/result_folder.hpp"
#include "splines/curve.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;
using PeakTriple = std::array<double, 3>;  // V, A, J

constexpr int repeats = 9;

struct SampledCurve {
    std::string name;
    const Motion& motion;
    std::function<Peaks()> exact;
};

PeakTriple sampled(const Motion& motion, int samples) {
    PeakTriple peaks{};
    for (int i = 0; i <= samples; ++i) {
        const MotionPoint point = motion.at(motion.begin() + (motion.end() - motion.begin()) * i / samples);
        for (std::size_t r = 0; r < peaks.size(); ++r)
            peaks[r] = std::max(peaks[r], std::abs(point.derivative[r + 1]));
    }
    return peaks;
}

double median_seconds(const std::function<void()>& work) {
    std::vector<double> seconds;
    for (int i = 0; i < repeats; ++i) {
        const Clock::time_point begin = Clock::now();
        work();
        seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    return median(seconds);
}

void add_curve(std::string& text, const SampledCurve& curve) {
    const Peaks found = curve.exact();
    const PeakTriple exact = {found.velocity.value, found.acceleration.value, found.jerk.value};
    const double exact_seconds = median_seconds([&] { (void)curve.exact(); });
    text += CsvLine{}
                .words(curve.name)
                .count(0)
                .number(0.0)
                .number(0.0)
                .number(0.0)
                .number(exact_seconds)
                .finish();
    for (const int samples : {90, 180, 360, 720, 1440, 2880, 5760, 11520}) {
        PeakTriple peaks{};
        const double seconds = median_seconds([&] { peaks = sampled(curve.motion, samples); });
        CsvLine line;
        line.words(curve.name).count(samples);
        for (std::size_t r = 0; r < peaks.size(); ++r) line.number(peaks[r] / exact[r] - 1.0);
        text += line.number(seconds).finish();
    }
}

struct OptimumKind {
    MotionType motion;
    int degree, segments;
};

std::string peaks_by_sampling_csv() {
    std::string text = "curve,samples,error_velocity,error_acceleration,error_jerk,seconds_median\n";
    for (const OptimumKind& kind : {OptimumKind{MotionType::drd, 3, 12},
                                    {MotionType::drd, 5, 12},
                                    {MotionType::drd, 5, 24},
                                    {MotionType::rr, 3, 10},
                                    {MotionType::rr, 3, 14}}) {
        const Solution solution = solve(
            scene_of({"structured", kind.degree, kind.motion, DesignKind::states, kind.segments}, 60.0));
        if (!solution.curve) continue;
        const SplineCurve& curve = *solution.curve;
        add_curve(text, {fmt::format("optimum {} degree {} n = {}", motion_name(kind.motion), kind.degree,
                                     kind.segments),
                         curve, [&] { return peaks_of(curve); }});
    }
    for (const char* key : {"modified_sine", "polynomial_4567", "mcv_50"}) {
        const auto law = make_law(key);
        add_curve(text, {key, *law, [&] { return law->peaks(); }});
    }
    return text;
}

}  // namespace

}  // namespace camopt::benchmarks

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: peaks_by_sampling FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = words[1];
        camopt::prepare_folder(folder);
        camopt::write_text_file(folder / "peaks_by_sampling.csv",
                                camopt::benchmarks::peaks_by_sampling_csv());
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "peaks_by_sampling: %s\n", error.what());
        return 1;
    }
}
