// SPDX-License-Identifier: Apache-2.0
#include "FeatureBytes.h"

#include <array>

#include <foundation/PlainBytes.h>

#include "PathBytes.h"

namespace osgTerrainROAM::core
{

namespace
{

/// The numbers of a feature's style.
using StyleNumbers = std::array<double, 9>;

StyleNumbers numbersOf(const GroundFeature& feature)
{
    const FeatureStyle& style = feature.style;
    return {static_cast<double>(style.kind),     style.widthM,
            static_cast<double>(style.lanes),    style.marked ? 1.0 : 0.0,
            static_cast<double>(style.pavement), static_cast<double>(style.crop),
            style.isCropKnown ? 1.0 : 0.0,       feature.isArea ? 1.0 : 0.0,
            static_cast<double>(style.taxiing)};
}

/// Whether a number is one of an enumeration.
bool isUpTo(double number, double most)
{
    return number >= 0.0 && number <= most && number == static_cast<int>(number);
}

bool takeStyle(foundation::ValueTaker& taker, GroundFeature& feature)
{
    constexpr double kMostLanes = 1e6;
    StyleNumbers numbers{};
    FeatureStyle& style = feature.style;
    if (!taker.take(numbers) || !taker.take(style.designator)) return false;
    if (!isUpTo(numbers[0], static_cast<double>(FeatureKind::runway)) ||
        !isUpTo(numbers[4], static_cast<double>(Pavement::earth)) ||
        !isUpTo(numbers[5], static_cast<double>(Crop::orchard)) ||
        !isUpTo(numbers[8], static_cast<double>(Taxiing::taxilane)) ||
        !(numbers[2] >= -kMostLanes && numbers[2] <= kMostLanes))
        return false;
    style.kind = static_cast<FeatureKind>(static_cast<int>(numbers[0]));
    style.widthM = numbers[1];
    style.lanes = static_cast<int>(numbers[2]);
    style.marked = numbers[3] != 0.0;
    style.pavement = static_cast<Pavement>(static_cast<int>(numbers[4]));
    style.crop = static_cast<Crop>(static_cast<int>(numbers[5]));
    style.isCropKnown = numbers[6] != 0.0;
    feature.isArea = numbers[7] != 0.0;
    style.taxiing = static_cast<Taxiing>(static_cast<int>(numbers[8]));
    return true;
}

} // namespace

std::string bytesOf(const FeatureSet& set)
{
    std::string bytes;
    const FeatureReport& report = set.report;
    for (const std::size_t count :
         {report.read, report.taken, report.outside, report.invalid, report.unknown.size()})
        foundation::appendValue(bytes, static_cast<std::uint64_t>(count));
    for (const auto& [name, count] : report.unknown)
    {
        foundation::appendText(bytes, name);
        foundation::appendValue(bytes, static_cast<std::uint64_t>(count));
    }
    foundation::appendTexts(bytes, report.notes);
    foundation::appendValue(bytes, static_cast<std::uint64_t>(set.features.size()));
    for (const GroundFeature& feature : set.features)
    {
        foundation::appendValue(bytes, numbersOf(feature));
        foundation::appendText(bytes, feature.style.designator);
        appendPaths(bytes, feature.paths);
    }
    return bytes;
}

std::optional<FeatureSet> featuresIn(std::string_view bytes)
{
    FeatureSet set;
    foundation::ValueTaker taker(bytes);
    std::array<std::uint64_t, 4> counts{};
    std::uint64_t count = 0, seen = 0;
    if (!taker.take(counts) || !taker.takeCount(count, 2 * sizeof(count))) return std::nullopt;
    set.report.read = static_cast<std::size_t>(counts[0]);
    set.report.taken = static_cast<std::size_t>(counts[1]);
    set.report.outside = static_cast<std::size_t>(counts[2]);
    set.report.invalid = static_cast<std::size_t>(counts[3]);
    std::string name;
    for (; count > 0; --count)
    {
        if (!taker.take(name) || !taker.take(seen)) return std::nullopt;
        set.report.unknown.emplace(name, static_cast<std::size_t>(seen));
    }
    if (!taker.take(set.report.notes) || !taker.takeCount(count, sizeof(StyleNumbers))) return std::nullopt;
    set.features.resize(static_cast<std::size_t>(count));
    for (GroundFeature& feature : set.features)
        if (!takeStyle(taker, feature) || !takePaths(taker, feature.paths)) return std::nullopt;
    return taker.isEmpty() ? std::optional(std::move(set)) : std::nullopt;
}

} // namespace osgTerrainROAM::core
