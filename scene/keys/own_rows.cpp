// SPDX-License-Identifier: MIT
#include "scene/keys/own_rows.hpp"

namespace camopt {
namespace {

struct OwnRows {
    std::vector<KeyRow> rows;
    std::size_t before_cam = 0;
};

const OwnRows& made_rows() {
    static const OwnRows made = [] {
        using namespace key_rows;
        OwnRows own{joined(of_motion(), of_measured(), of_search()), 0};
        own.before_cam = own.rows.size();
        own.rows = joined(std::move(own.rows), other_tables(), of_loads(), of_limits(), of_tolerance());
        return own;
    }();
    return made;
}

}  // namespace

const std::vector<KeyRow>& own_rows() {
    return made_rows().rows;
}

namespace key_rows {

std::span<const KeyRow> before_cam() {
    return std::span(own_rows()).first(made_rows().before_cam);
}

std::span<const KeyRow> after_cam() {
    return std::span(own_rows()).subspan(made_rows().before_cam);
}

}  // namespace key_rows
}  // namespace camopt
