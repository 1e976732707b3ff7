// SPDX-License-Identifier: MIT
#include "scene/keys/own_rows.hpp"

namespace camopt {

const std::vector<KeyRow>& own_rows() {
    static const std::vector<KeyRow> rows = key_rows::joined(key_rows::before_cam(), key_rows::after_cam());
    return rows;
}

namespace key_rows {

Rows before_cam() {
    return joined(of_motion(), of_measured(), of_search());
}

Rows after_cam() {
    return joined(other_tables(), of_loads(), of_limits());
}

}  // namespace key_rows
}  // namespace camopt
