// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/Paint.h"

#include <array>
#include <cassert>

#include "scenery/models/cockpit/PaintInstruments.h"
#include "scenery/models/paint/PaintBark.h"
#include "scenery/models/paint/PaintHouseDetails.h"
#include "scenery/models/paint/PaintLeaves.h"
#include "scenery/models/paint/PaintRoofs.h"
#include "scenery/models/paint/PaintVehicle.h"
#include "scenery/models/paint/PaintWalls.h"
#include "scenery/models/paint/PaintWheel.h"
#include "scenery/models/roads/PaintSigns.h"

namespace scenery::models
{

Picture paint(Painting painting, const VehicleLook* look)
{
    assert((painting == Painting::vehicle) == (look != nullptr));
    if (look) return paintVehicle(*look);
    using Painter = Picture (*)();
    constexpr std::array<Painter, static_cast<std::size_t>(Painting::vehicle)> kPainters{
        paintOakBark,      paintBirchBark,  paintPineBark,      paintOakLeaves, paintBirchLeaves,
        paintPoplarLeaves, paintBushLeaves, paintSpruceNeedles, paintPlaster,   paintBricks,
        paintSheetMetal,   paintPlanks,     paintRoofTiles,     paintRoofMetal, paintHouseDetails,
        paintWheel,        paintSigns,      paintInstruments};
    return kPainters[static_cast<std::size_t>(painting)]();
}

} // namespace scenery::models
