// SPDX-License-Identifier: Apache-2.0
#include "WindowRun.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

bool hasXvfb()
{
    return std::system("command -v Xvfb >/dev/null") == 0;
}

ProgramRun inWindow(std::vector<std::string> arguments, std::vector<std::string> command)
{
    command.insert(command.end(), {"--", OSGTRAINER_TRAINER});
    arguments = withoutWorld(std::move(arguments));
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), {"--size", "96x54", "--samples", "1", "--window"});
    return runProgram(command, 400.0);
}

std::string allOf(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}
