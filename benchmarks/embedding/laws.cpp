// SPDX-License-Identifier: MIT
// The smallest embedding: the peaks of a classical law. Links camopt::motions and nothing else.
#include "motions/laws/law_catalogue.hpp"

#include <cstdio>

int main() {
    const auto law = camopt::make_law("modified_sine");
    std::printf("%.6f\n", law->peaks().acceleration.value);
}
