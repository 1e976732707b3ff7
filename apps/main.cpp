// SPDX-License-Identifier: MIT
// The camopt program.
#include "apps/command_line.hpp"

int main(int count, char** words) {
    return camopt::apps::run_command_line(count, words);
}
