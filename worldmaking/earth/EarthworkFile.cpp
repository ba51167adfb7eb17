// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/EarthworkFile.h"

#include <cstdio>
#include <string>

#include "worldmaking/land/MapFile.h"

namespace worldmaking
{

namespace
{

std::string textOf(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
}

} // namespace

foundation::Outcome writeEarthworks(std::span<const osgTerrainROAM::core::Earthwork> works,
                                    const MapPlane& plane, const std::filesystem::path& file)
{
    MapFile made(file);
    // The order counts, and a layer holds shapes of one form: a new one wherever the form changes.
    int layer = 0;
    const osgTerrainROAM::core::Earthwork* before = nullptr;
    for (const auto& work : works)
    {
        if (!before || before->isArea != work.isArea)
            made.beginLayer((work.isArea ? "areas" : "lines") + std::to_string(++layer),
                            work.isArea ? ShapeForm::area : ShapeForm::line,
                            {"width", "crossfall", "strip", "strip_fall", "slope", "rise", "river"}, true);
        before = &work;
        if (const auto degrees = plane.toDegrees(work.paths))
            made.add(*degrees,
                     {{"width", textOf(work.widthM)},
                      {"crossfall", textOf(work.crossfall)},
                      {"strip", textOf(work.stripM)},
                      {"strip_fall", textOf(work.stripFall)},
                      {"slope", textOf(work.slope)},
                      {"rise", textOf(work.riseM)},
                      {"river", std::to_string(work.river)}},
                     work.heightsM);
    }
    return made.finish();
}

} // namespace worldmaking
