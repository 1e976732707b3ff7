// SPDX-License-Identifier: MIT
// The modified sine at its middle, by the headers of a camopt inside the project.
#include <camopt/laws.hpp>
#include <camopt/motion.hpp>
#include <iostream>

int main() {
    std::cout << "law midpoint " << camopt::make_law("modified_sine")->at(0.5).derivative[0] << '\n';
}
