// SPDX-License-Identifier: MIT
// A program that embeds camopt may have set a locale in which 1234.5 is written 1.234,5: what camopt reads,
// solves and writes is the same to the last byte.
#include "benchmarks/papers/paper_json.hpp"
#include "benchmarks/papers/papers.hpp"
#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "input/loading/load_scene.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/folders/result_folder.hpp"
#include "report/json/certificate_json.hpp"
#include "scene/scene.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/nc/post_processor.hpp"
#include "shop/plc/plc_export.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <map>
#include <memory>
#include <regex>
#include <sstream>
#include <string>

namespace camopt {
namespace locale_test {

using testing_support::refusal;

class CommaPunctuation final : public std::numpunct<char> {
    [[nodiscard]] char do_decimal_point() const override { return ','; }
    [[nodiscard]] char do_thousands_sep() const override { return '.'; }
    [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

/// The locale of C++: what streams read and write.
class StreamLocale {
 public:
    StreamLocale()
        : before_(std::locale::global(std::locale(std::locale::classic(), new CommaPunctuation))) {}
    ~StreamLocale() { std::locale::global(before_); }
    StreamLocale(const StreamLocale&) = delete;
    StreamLocale& operator=(const StreamLocale&) = delete;

 private:
    std::locale before_;
};

/// The locale of C: what strtod and printf take. Made for the occasion, as a machine need not have one.
class ProcessLocale {
 public:
    explicit ProcessLocale(const std::string& folder) {
        const std::string make =
            "localedef -c -i de_DE -f UTF-8 '" + folder + "/de_DE.UTF-8' >/dev/null 2>&1";
        static_cast<void>(std::system(make.c_str()));
        ::setenv("LOCPATH", folder.c_str(), 1);
        there_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
        ::unsetenv("LOCPATH");
        if (!there_) there_ = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
    }
    ~ProcessLocale() { std::setlocale(LC_ALL, "C"); }
    ProcessLocale(const ProcessLocale&) = delete;
    ProcessLocale& operator=(const ProcessLocale&) = delete;
    [[nodiscard]] bool there() const { return there_; }

 private:
    bool there_ = false;
};

/// Without the seconds that a solve took.
std::string without_times(const std::string& text) {
    const std::regex times(
        "(\"(total|solve|setup|solver|judgement|proof|tie_break|report|search|seconds|[a-z]*_us)\": )[^,\n}]*"
        "|[0-9.e+-]+ (s|ms|seconds)\\b");
    return std::regex_replace(text, times, "$1…");
}

using Texts = std::map<std::string, std::string>;

void add_folder(Texts& texts, const std::string& name) {
    const test::TemporaryFolder folder;
    Solution solution = solve_without_explaining(testing_support::scene_named(name), {});
    WriteOptions options;
    options.points = 720;
    options.also = dxf_files(solution);
    for (const auto& file : write_result_folder(folder.path(), solution, {}, options))
        texts[name + "/" + file.filename().string()] = without_times(read_text_file(file));
    for (const ConflictReport& conflict : solution.conflict)
        texts[name + "/conflict"] += fmt::format("{} {} {}\n", conflict.key, conflict.at, conflict.weight);
    if (solution.motion) {
        std::vector<std::string> formats = plc_format_keys();
        if (solution.scene.spline.degree < 7) std::erase(formats, "twincat7");  // the jerk jumps
        for (const FolderFile& file : plc_export(solution, formats, {}).files)
            texts[name + "/" + file.name] = file.text;
        texts[name + "/table.csv"] = uniform_table(solution, {.digits = 9}).text;
    }
    if (solution.certificate.proof)
        texts[name + "/bound again"] =
            fmt::format("{}", recomputed_bound(read_certificate(folder.path() + "/certificate.json")));
}

/// What a user can read off everything that has numbers in it.
Texts everything() {
    Texts texts;
    for (const char* name : {"drd_cubic_12", "cam_roller", "cam_infeasible"}) add_folder(texts, name);
    for (const double value : varied_key("limits.velocity=1.5:6.25:7:log").values)
        texts["axis"] += fmt::format("{} ", value);
    for (const double value : weights_of_csv("velocity,jerk\n0.25,0.75\n", "w.csv").values)
        texts["weights"] += fmt::format("{} ", value);
    texts["as written"] = fmt::format("{}", as_written(29.999999999999996));
    texts["paper"] = without_times(paper_report_json(paper_000()));
    texts["post"] = refusal([] { (void)post_of_text("block_step = 1234567\nname = 0.5\n", "p.toml", {}); });
    texts["scene"] = refusal([] {
        (void)scene_of_toml("motion.type = \"DRD\"\nobjective.jerk = 1\nspline.segments = 1234567.5\n");
    });
    return texts;
}

const Texts& usual() {
    static const Texts texts = everything();
    return texts;
}

void expect_the_same(const Texts& found) {
    EXPECT_EQ(found.size(), usual().size());
    for (const auto& [name, text] : usual()) {
        const auto other = found.find(name);
        ASSERT_NE(other, found.end()) << name;
        if (other->second == text) continue;
        std::istringstream one(text), two(other->second);
        std::string left, right;
        while (std::getline(one, left) && std::getline(two, right) && left == right) {
        }
        ADD_FAILURE() << name << "\n  usually: " << left << "\n  here:    " << right;
    }
}

TEST(CommaLocale, OfCppStreamsChangesNothing) {
    usual();
    const StreamLocale locale;
    std::ostringstream proof;
    proof << 1234.5;
    ASSERT_EQ(proof.str(), "1.234,5");
    expect_the_same(everything());
}

TEST(CommaLocale, OfTheProcessChangesNothing) {
    usual();
    const test::TemporaryFolder folder;
    const ProcessLocale locale(folder.path());
    if (!locale.there())
        GTEST_SKIP()
            << "no German locale here, and localedef could not make one: install the package locales";
    char proof[32];
    std::snprintf(proof, sizeof proof, "%.1f", 0.5);
    ASSERT_STREQ(proof, "0,5");
    expect_the_same(everything());
}

}  // namespace locale_test
}  // namespace camopt
