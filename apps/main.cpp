// SPDX-License-Identifier: MIT
// The camopt program.
#include "apps/command_line.hpp"
#include "core/platform/console.hpp"

int main(int count, char** words) {
    const std::vector<std::string> texts = camopt::program_words(count, words);
    std::vector<const char*> pointers;
    pointers.reserve(texts.size());
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    return camopt::apps::run_command_line(static_cast<int>(pointers.size()), pointers.data());
}
