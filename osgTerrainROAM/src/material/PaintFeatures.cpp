// SPDX-License-Identifier: Apache-2.0
#include "PaintFeatures.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <foundation/KeptFrom.h>
#include <foundation/PlainBytes.h>
#include <foundation/SoleFile.h>

#include <osg/Notify>

#include <osgTerrainROAM/core/features/FeatureImport.h>

#include "../core/features/FeatureBytes.h"
#include "FeatureMaps.h"

namespace osgTerrainROAM
{

namespace
{

/// What is painted, and what is told of it.
struct PaintedFeatures
{
    std::optional<FeatureMaps> maps; ///< absent: there is nothing
    core::FeatureSet told;           ///< the report; it has no features
    std::vector<std::string> notices;
};

std::string bytesOf(const PaintedFeatures& painted)
{
    std::string bytes;
    foundation::appendText(bytes, painted.maps ? bytesOf(*painted.maps) : std::string());
    foundation::appendText(bytes, core::bytesOf(painted.told));
    foundation::appendTexts(bytes, painted.notices);
    return bytes;
}

std::optional<PaintedFeatures> paintedIn(std::string_view bytes)
{
    foundation::ValueTaker taker(bytes);
    std::string_view maps, told;
    PaintedFeatures painted;
    if (!taker.take(maps) || !taker.take(told) || !taker.take(painted.notices) || !taker.isEmpty())
        return std::nullopt;
    if (!maps.empty() && !(painted.maps = featureMapsIn(maps))) return std::nullopt;
    auto report = core::featuresIn(told);
    if (!report || !report->features.empty()) return std::nullopt;
    painted.told = *std::move(report);
    return painted;
}

/// The mark of what all sources hold. Absent: some source has none, or there are other features besides.
std::optional<foundation::ContentMark> markOfSources(const core::RoamFile& description,
                                                     const MoreFeatures& more)
{
    if (description.features.empty() || !more.everywhere.empty()) return std::nullopt;
    foundation::ContentMark all;
    for (const std::filesystem::path& source : description.features)
    {
        const auto mark = foundation::markOfSoleFile(source);
        if (!mark) return std::nullopt;
        all.add(mark->text()).add(source.string()); // notices name it
    }
    return all;
}

foundation::Result<PaintedFeatures> importAll(const core::RoamFile& description, const core::PlacedTile& tile,
                                              const MoreFeatures& more, const foundation::KeptFrom& kept,
                                              bool isKeptWhole)
{
    core::FeatureSet all;
    PaintedFeatures painted;
    all.features = more.everywhere;
    for (const std::filesystem::path& source : description.features)
    {
        auto set = core::importFeatures(source, tile, kept);
        if (!set) return set.error();
        if (set->report.taken < set->report.read)
            painted.notices.push_back(source.string() + ": " + set->report.message());
        painted.notices.insert(painted.notices.end(), set->report.notes.begin(), set->report.notes.end());
        all.append(std::move(*set));
    }
    if (!all.features.empty())
    {
        const auto cells = core::FeatureCells::build(all.features);
        if (!cells) return cells.error();
        painted.maps = FeatureMaps::of(*cells, isKeptWhole ? foundation::KeptFrom() : kept.withoutMark());
    }
    painted.told.report = std::move(all.report);
    return painted;
}

foundation::Result<FeatureMaps> buildFar(const MoreFeatures& more, const foundation::KeptFrom& kept)
{
    const auto cells = core::FeatureCells::build(more.far());
    if (!cells) return cells.error();
    return FeatureMaps::farOf(*cells, kept);
}

foundation::Outcome paintFar(TerrainMaterial& material, const MoreFeatures& more)
{
    if (!more.far) return foundation::success();
    const auto& kept = material.kept();
    const auto maps = more.farMark
                          ? kept.findOrMake(
                                "far-roads", *more.farMark, featureMapsIn, [&] { return buildFar(more, {}); },
                                [](const FeatureMaps& made) { return bytesOf(made); })
                          : buildFar(more, kept.withoutMark());
    if (!maps) return maps.error();
    if (maps->columns > 0) material.setFarFeatures(*maps, more.farFromM);
    return foundation::success();
}

} // namespace

foundation::Result<core::FeatureReport> paintFeatures(TerrainMaterial& material,
                                                      const core::RoamFile& description,
                                                      const core::PlacedTile& tile, const MoreFeatures& more)
{
    const auto& kept = material.kept();
    const auto mark = kept ? markOfSources(description, more) : std::nullopt;
    const auto import = [&] { return importAll(description, tile, more, kept, mark.has_value()); };
    const auto painted = mark ? kept.findOrMake("painted", *mark, paintedIn, import,
                                                [](const PaintedFeatures& made) { return bytesOf(made); })
                              : import();
    if (!painted) return painted.error();
    for (const std::string& notice : painted->notices)
        osg::notify(osg::NOTICE) << notice << std::endl;
    if (painted->maps) material.setFeatures(*painted->maps);
    if (const auto far = paintFar(material, more); !far) return far.error();
    return painted->told.report;
}

} // namespace osgTerrainROAM
