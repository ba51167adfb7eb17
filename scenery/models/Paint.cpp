// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/Paint.h"

#include <array>

#include "scenery/models/cockpit/PaintInstruments.h"
#include "scenery/models/paint/PaintBark.h"
#include "scenery/models/paint/PaintHouseDetails.h"
#include "scenery/models/paint/PaintLeaves.h"
#include "scenery/models/paint/PaintRoofs.h"
#include "scenery/models/paint/PaintVehicles.h"
#include "scenery/models/paint/PaintWalls.h"
#include "scenery/models/paint/PaintWheel.h"
#include "scenery/models/roads/PaintSigns.h"

namespace scenery::models
{

Picture paint(Painting painting)
{
    using Painter = Picture (*)();
    constexpr std::array<Painter, static_cast<std::size_t>(Painting::count)> kPainters{
        paintOakBark,      paintBirchBark,  paintPineBark,      paintOakLeaves, paintBirchLeaves,
        paintPoplarLeaves, paintBushLeaves, paintSpruceNeedles, paintPlaster,   paintBricks,
        paintSheetMetal,   paintPlanks,     paintRoofTiles,     paintRoofMetal, paintHouseDetails,
        paintSaloon,       paintVan,        paintBus,           paintWheel,     paintSigns,
        paintEstate,       paintInstruments};
    return kPainters[static_cast<std::size_t>(painting)]();
}

} // namespace scenery::models
