// SPDX-License-Identifier: MIT
#include <camopt/camopt.hpp>

int main() {
    return camopt::version().empty() ? 1 : 0;
}
