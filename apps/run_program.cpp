// SPDX-License-Identifier: MIT
#include "apps/run_program.hpp"

#include "apps/command_line.hpp"
#include "core/platform/console.hpp"

namespace camopt::apps {

int run_program(int count, char** words) {
    const std::vector<std::string> texts = program_words(count, words);
    std::vector<const char*> pointers;
    pointers.reserve(texts.size());
    for (const std::string& text : texts) pointers.push_back(text.c_str());
    return run_command_line(static_cast<int>(pointers.size()), pointers.data());
}

}  // namespace camopt::apps
