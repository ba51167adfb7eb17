// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "pmtool/LevelMaker.h"

namespace pmtool
{

void LevelErrors::addTo(MadeLevel& level, const LevelWish& wish) const
{
    using Json = nlohmann::ordered_json;
    const osgPMObjects::core::MeasuredError error = _meter.measure(level.mesh);
    const auto finite = [](float value) { return std::isfinite(value) ? Json(value) : Json(); };
    level.row["errorMax"] = finite(error.maximum);
    level.row["errorRms"] = finite(error.rootMeanSquare);
    if (_hasSpecks)
        level.row["specksVanished"] =
            _meter.countVanished(level.mesh, wish.faces ? error.maximum : wish.tolerance);
}

} // namespace pmtool
