// SPDX-License-Identifier: MIT
// dxf_samples FOLDER: NAME.dxf for every follower and direction of rotation, and beside it NAME.csv, true
// points of the cam between and on the knots (x_mm, y_mm), for dxf_read_back.py.
#include "core/text/text_file.hpp"
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/csv/csv_line.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "tests/studies/cam_samples.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

namespace camopt {

namespace {

constexpr int points = 3001;

std::string points_csv(const ProfileShape& shape) {
    std::string text = "x_mm,y_mm\n";
    for (int i = 0; i < points; ++i) {
        const double theta = shape.begin() + (shape.end() - shape.begin()) * i / points;
        const Eigen::Vector2d place = in_plane(shape.at(theta).contact) / units::millimetre;
        text += CsvLine{}.number(place.x()).number(place.y()).finish();
    }
    return text;
}

void write_samples(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const MotionChain motion = test::turn_motion("modified_sine");
    for (const FollowerType follower : test::all_followers)
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
            const ProfileShape shape = profile_shape(disk_mechanism(test::sample_cam(follower, rotation)),
                                                     motion, test::sample_scale(follower));
            const std::string name = std::string(name_of(follower)) + "_" + name_of(rotation);
            write_text_file(folder / (name + ".dxf"), profile_dxf(shape).text);
            write_text_file(folder / (name + ".csv"), points_csv(shape));
        }
}

}  // namespace

}  // namespace camopt

int main(int count, char** words) {
    if (count != 2) {
        std::fputs("usage: dxf_samples FOLDER\n", stderr);
        return 2;
    }
    try {
        camopt::write_samples(words[1]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dxf_samples: %s\n", error.what());
        return 1;
    }
}
