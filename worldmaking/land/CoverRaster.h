// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Classes of ESA WorldCover and two of ours, which land_cover_classes = worldcover knows.
enum class Cover : std::uint8_t
{
    none = 0, ///< the ground's own look
    trees = 10,
    shrubs = 20,
    grass = 30,
    crops = 40,
    garden = 51, ///< ours, as yard: land of settlements
    yard = 52,   ///< paved or gravel: squares, industry, between houses that stand close
    bare = 60,
    ice = 70,
    water = 80,
    wetland = 90,
};

/// A raster of classes over a part of the plane. Units: metres.
class CoverRaster
{
public:
    /// At most kMostCells along a side; the texels are then larger than `texelM`.
    CoverRaster(const MapBox& box, double texelM);

    static constexpr int kMostCells = 8000;

    /// Gives the texels whose middle lies within an outline a class. Source:
    /// even-odd rule, row by row.
    void paint(const PlanRings& rings, Cover cover);

    /// Gives each texel without a class what `choose(its middle)` returns.
    template<class Choose>
    void fillRest(const Choose& choose)
    {
        change(Cover::none, choose);
    }

    /// Gives each texel of a class what `choose(its middle)` returns.
    template<class Choose>
    void change(Cover from, const Choose& choose)
    {
        for (std::size_t i = 0; i < _classes.size(); ++i)
            if (_classes[i] == static_cast<std::uint8_t>(from))
            {
                const auto columns = static_cast<std::size_t>(_columns);
                const glm::dvec2 cell(static_cast<double>(i % columns), static_cast<double>(i / columns));
                _classes[i] = static_cast<std::uint8_t>(choose(_box.low + _texelM * (cell + 0.5)));
            }
    }

    Cover at(const glm::dvec2& plan) const;
    const MapBox& box() const { return _box; }
    double texelM() const { return _texelM; }
    std::size_t count(Cover cover) const;

    /// Writes a GeoTIFF with the plane's coordinate system (`proj`: text of
    /// PROJ), whole or not at all.
    foundation::Outcome write(const std::filesystem::path& file, const std::string& proj) const;

private:
    MapBox _box;
    double _texelM;
    int _columns = 1, _rows = 1;
    std::vector<std::uint8_t> _classes; ///< row by row, the southernmost first
};

} // namespace worldmaking
