// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimLastWords.h"

#include <array>
#include <fstream>
#include <string_view>

#include <foundation/Excerpt.h>

namespace simulation
{
namespace
{

constexpr std::array<std::string_view, 6> kWords{"trim failed", "message was", "could not",
                                                 "cannot",      "error",       "no property"};

bool contains(const std::string& line, std::string_view word)
{
    std::string lower;
    for (const char c : line)
        lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return lower.find(word) != std::string::npos;
}

bool tellsError(const std::string& line)
{
    for (const std::string_view word : kWords)
        if (contains(line, word)) return true;
    return false;
}

} // namespace

std::string jsbsimLastWords(const std::filesystem::path& outputFile)
{
    std::ifstream stream(outputFile);
    std::string last, error;
    bool isReason = false; // a reason outweighs the words that follow it
    for (std::string line; std::getline(stream, line);)
    {
        const std::size_t begin = line.find_first_not_of(" \t\r");
        if (begin == std::string::npos) continue;
        line = line.substr(begin);
        last = line;
        const bool names = contains(line, "message was") || contains(line, "trim failed");
        if (!tellsError(line) || (isReason && !names)) continue;
        error = line;
        isReason = names;
    }
    return foundation::excerpt(error.empty() ? last : error);
}

bool jsbsimLostItsPort(const std::filesystem::path& outputFile)
{
    std::ifstream stream(outputFile);
    for (std::string line; std::getline(stream, line);)
        if (contains(line, "could not bind")) return true;
    return false;
}

} // namespace simulation
