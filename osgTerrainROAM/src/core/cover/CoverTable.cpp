// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <utility>

#include <osgTerrainROAM/core/cover/CoverTable.h>

#include "../TextLines.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

constexpr std::array<std::pair<std::string_view, GroundKind>, kGroundKinds> kNames{
    {{"unknown", GroundKind::unknown},
     {"rock", GroundKind::rock},
     {"soil", GroundKind::soil},
     {"dry_grass", GroundKind::dryGrass},
     {"meadow", GroundKind::meadow},
     {"shrub", GroundKind::shrub},
     {"forest", GroundKind::forest},
     {"sand", GroundKind::sand},
     {"snow", GroundKind::snow},
     {"water", GroundKind::water},
     {"crop", GroundKind::crop},
     {"urban", GroundKind::urban},
     {"wetland", GroundKind::wetland},
     {"garden", GroundKind::garden},
     {"yard", GroundKind::yard}}};

constexpr std::size_t kMostTableBytes = 1 << 20;
constexpr int kMostCodesOfARange = 70000; ///< codes in one range

std::optional<int> numberIn(std::string_view text)
{
    int number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// Parses a code or a range: "20", "20-29".
std::optional<std::pair<int, int>> rangeIn(std::string_view text)
{
    const std::size_t dash = text.find('-', 1); // a code may be negative
    const auto first = numberIn(trimmed(text.substr(0, dash)));
    const auto last = dash == std::string_view::npos ? first : numberIn(trimmed(text.substr(dash + 1)));
    if (!first || !last || *first < -1000000 || *last > 1000000 || *last < *first ||
        *last - *first > kMostCodesOfARange)
        return std::nullopt;
    return std::pair{*first, *last};
}

std::optional<GroundKind> kindIn(std::string_view text)
{
    for (const auto& [name, kind] : kNames)
        if (name == text) return kind;
    return std::nullopt;
}

std::string kindNames()
{
    std::string names;
    for (const auto& [name, kind] : kNames)
        names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

/// Adds one line to the table; returns an error when the line is invalid.
std::optional<Error> addLine(CoverTable& table, std::string_view line, const std::string& place)
{
    const std::size_t equals = line.find('=');
    const auto range = rangeIn(trimmed(line.substr(0, equals)));
    if (equals == std::string_view::npos || !range)
        return Error{place, "not of the form CODE = KIND", "write lines like 40 = crop, or 111-142 = urban"};
    const std::string_view word = trimmed(line.substr(equals + 1));
    const auto kind = kindIn(word);
    if (!kind) return Error{place, "unknown kind '" + std::string(word) + "'", "known kinds: " + kindNames()};
    for (int code = range->first; code <= range->second; ++code)
        if (!table.emplace(code, *kind).second)
            return Error{place, "code " + std::to_string(code) + " stands here a second time",
                         "keep one of them"};
    return std::nullopt;
}

} // namespace

CoverTable worldCoverTable()
{
    return {{10, GroundKind::forest},   {20, GroundKind::shrub},   {30, GroundKind::meadow},
            {40, GroundKind::crop},     {50, GroundKind::urban},   {51, GroundKind::garden},
            {52, GroundKind::yard},     {60, GroundKind::soil},    {70, GroundKind::snow},
            {80, GroundKind::water},    {90, GroundKind::wetland}, {95, GroundKind::wetland},
            {100, GroundKind::dryGrass}};
}

CoverTable corineTable()
{
    using enum GroundKind;
    // In the order of the raster's codes, 1 … 44.
    static constexpr std::array<std::pair<int, GroundKind>, 44> kClasses{
        {{111, urban},   {112, urban},    {121, urban}, {122, urban},  {123, urban},   {124, urban},
         {131, soil},    {132, soil},     {133, soil},  {141, meadow}, {142, meadow},  {211, crop},
         {212, crop},    {213, wetland},  {221, crop},  {222, crop},   {223, shrub},   {231, meadow},
         {241, crop},    {242, crop},     {243, crop},  {244, shrub},  {311, forest},  {312, forest},
         {313, forest},  {321, meadow},   {322, shrub}, {323, shrub},  {324, shrub},   {331, sand},
         {332, rock},    {333, dryGrass}, {334, soil},  {335, snow},   {411, wetland}, {412, wetland},
         {421, wetland}, {422, wetland},  {423, sand},  {511, water},  {512, water},   {521, water},
         {522, water},   {523, water}}};
    CoverTable table;
    int code = 1;
    for (const auto& [label, kind] : kClasses)
    {
        table[code++] = kind;
        table[label] = kind;
    }
    return table;
}

Result<CoverTable> parseCoverTable(std::string_view text, const std::string& name)
{
    CoverTable table;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view content = text.substr(at, end - at);
        const std::string_view line = trimmed(content.substr(0, content.find('#')));
        at = end + 1;
        ++number;
        if (line.empty()) continue;
        if (const auto error = addLine(table, line, name + ":" + std::to_string(number))) return *error;
    }
    if (table.empty()) return Error{name, "names no class", "write lines like 40 = crop"};
    return table;
}

Result<CoverTable> readCoverTable(const std::filesystem::path& nameOrFile)
{
    if (nameOrFile.empty() || nameOrFile == "worldcover") return worldCoverTable();
    if (nameOrFile == "corine") return corineTable();
    std::ifstream stream(nameOrFile, std::ios::binary);
    if (!stream)
        return Error{nameOrFile.string(), "cannot be read",
                     "give worldcover, corine, or a file of lines CODE = KIND"};
    std::string text(kMostTableBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    if (text.size() > kMostTableBytes)
        return Error{nameOrFile.string(), "is no table of classes", "see docs/reference/roam-file.md"};
    return parseCoverTable(text, nameOrFile.string());
}

} // namespace osgTerrainROAM::core
