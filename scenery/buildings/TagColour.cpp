// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/TagColour.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <utility>

namespace scenery
{

namespace
{

constexpr std::array<std::pair<std::string_view, std::uint32_t>, 40> kNames{
    {{"white", 0xf4f4f0},     {"black", 0x202020},       {"gray", 0x808080},
     {"grey", 0x808080},      {"silver", 0xc0c0c0},      {"lightgray", 0xd3d3d3},
     {"lightgrey", 0xd3d3d3}, {"darkgray", 0x6a6a6a},    {"darkgrey", 0x6a6a6a},
     {"dimgray", 0x606060},   {"red", 0xb03028},         {"darkred", 0x7a1c18},
     {"maroon", 0x7a2a24},    {"brown", 0x8a5a3c},       {"saddlebrown", 0x8b4513},
     {"sienna", 0xa0522d},    {"chocolate", 0xa8642c},   {"peru", 0xcd853f},
     {"tan", 0xd2b48c},       {"beige", 0xf0e8d0},       {"wheat", 0xf0dcb4},
     {"ivory", 0xf6f4e4},     {"linen", 0xf4ece0},       {"cream", 0xf4ecc8},
     {"yellow", 0xe8d060},    {"lightyellow", 0xf4f0c8}, {"gold", 0xd8b040},
     {"orange", 0xd88838},    {"salmon", 0xe0907c},      {"pink", 0xe8b8b8},
     {"green", 0x4c8050},     {"darkgreen", 0x305a38},   {"lightgreen", 0xa8d0a0},
     {"olive", 0x808040},     {"blue", 0x4868a0},        {"lightblue", 0xb0cce0},
     {"navy", 0x283860},      {"slategray", 0x708090},   {"slategrey", 0x708090},
     {"firebrick", 0xa03028}}};

glm::vec3 colourOf(std::uint32_t rgb)
{
    return glm::vec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0F;
}

} // namespace

std::optional<glm::vec3> colourOfTag(std::string_view text)
{
    for (const auto& [name, rgb] : kNames)
        if (text == name) return colourOf(rgb);
    if (text.empty() || text.front() != '#' || (text.size() != 4 && text.size() != 7)) return std::nullopt;
    std::string digits(text.substr(1));
    if (digits.size() == 3) digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    std::uint32_t rgb = 0;
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), rgb, 16);
    if (failure != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    return colourOf(rgb);
}

} // namespace scenery
