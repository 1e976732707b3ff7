// SPDX-License-Identifier: MIT
#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "tests/report/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace camopt::apps {
namespace offline_page_test {

using Json = nlohmann::ordered_json;

class OfflinePage : public testing::Test {
 protected:
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }
    std::string page(const std::string& engine = "any carnal pleas") {
        return make_offline_page(engine, "Licence of the engine\n", folder_,
                                 [this](const std::string& why) { left_out_.push_back(why); });
    }
    static Json block(const std::string& page, const std::string& id) {
        const std::string begin = "<script type=\"application/json\" id=\"" + id + "\">";
        const std::size_t at = page.find(begin) + begin.size();
        return Json::parse(page.substr(at, page.find("</script>", at) - at));
    }

    test::TemporaryFolder scratch_;
    std::filesystem::path folder_ = scratch_.path();
    std::vector<std::string> left_out_;
};

const char* const rise = R"(title = "Rise </script>"
# First line of why,
# and the second.

# Not this one.
[motion]
type = "DRD"
[spline]
segments = 12
[objective]
jerk = 1
)";

TEST_F(OfflinePage, HoldsEngineExamplesAndFirstAnswer) {
    write("rise_10.toml", rise);
    write("rise_9.toml",
          "# Alone.\n[motion]\ntype = \"RR\"\n[spline]\nsegments = 12\n[objective]\njerk = 1\n");
    const std::string made = page();
    EXPECT_NE(made.find("<script type=\"text/plain\" id=\"engine\">YW55IGNhcm5hbCBwbGVhcw==</script>"),
              std::string::npos);
    const std::string opening = "<script type=\"application/json\" id=\"opening-scene\">null</script>";
    EXPECT_EQ(made.find(opening), made.rfind(opening));
    EXPECT_NE(made.find(opening), std::string::npos);
    EXPECT_NE(made.find("script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:"),
              std::string::npos);
    EXPECT_NE(made.find("connect-src 'none'"), std::string::npos);
    const Json examples = block(made, "examples");
    ASSERT_EQ(examples.size(), 2U);
    EXPECT_EQ(examples[0]["title"], "rise_9") << "a scene without a title has its file's name";
    EXPECT_EQ(examples[0]["words"], "Alone.");
    EXPECT_EQ(examples[1]["title"], "Rise </script>");
    EXPECT_EQ(examples[1]["kind"], "Rise between two dwells");
    EXPECT_EQ(examples[1]["group"], "Motions");
    EXPECT_EQ(examples[1]["words"], "First line of why, and the second.");
    EXPECT_EQ(examples[1]["scene"], rise);
    EXPECT_EQ(examples[1]["curve"].front(), 0);
    EXPECT_EQ(examples[1]["curve"].back(), 100);
    EXPECT_EQ(block(made, "page-data")["studio"]["stage"], "rest");
    EXPECT_TRUE(left_out_.empty());
}

TEST_F(OfflinePage, CarriesTheLicencesOfItsEngine) {
    write("rise.toml", rise);
    EXPECT_NE(page().find("id=\"licences\">\nLicence of the engine\nuPlot\n"), std::string::npos);
}

TEST_F(OfflinePage, LeavesOutMachinesAndNamedTables) {
    write("rise.toml", rise);
    write("machine.toml", "[machine]\nspeed_rpm = 60\n");
    write("table.toml", "[motion]\ntype = \"DRD\"\n[measured]\nfile = \"table.csv\"\n");
    EXPECT_EQ(block(page(), "examples").size(), 1U);
    EXPECT_EQ(left_out_.size(), 2U);
}

TEST_F(OfflinePage, IsTheSameEachTime) {
    write("rise.toml", rise);
    EXPECT_TRUE(page() == page());
}

TEST_F(OfflinePage, NeedsScenes) {
    EXPECT_THROW(page(), InputError);
}

TEST(StudioSession, DownloadsTheCertificate) {
    StudioSession session;
    const Json request = {{"page", "test"}, {"scene", first_scene().scene}, {"what", "certificate"}};
    const StudioAnswer answer = session.download(request.dump());
    EXPECT_EQ(answer.status, 200);
    EXPECT_EQ(answer.file_name, "certificate.json");
    EXPECT_EQ(Json::parse(answer.body)["verdict"], "optimal");
}

}  // namespace offline_page_test
}  // namespace camopt::apps
