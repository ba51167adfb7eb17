// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/KeptFrom.h>
#include <glm/glm.hpp>

#include <osg/Image>
#include <osg/ref_ptr>

#include <osgTerrainROAM/core/features/FeatureCells.h>

namespace osgTerrainROAM
{

/// Shaders compute so many runways (shaders/FeatureMaps.glsl); where there are more, the far map has them
/// all.
inline constexpr std::size_t kMostRunways = 16;

/// What vector features are painted by: cells and records as texels of floats, and far maps of the shares of
/// crops and beds in each texel. Memory: 16 B a cell and a record, and two far maps of up to 4096×4096 texels
/// of 4 B; a texel is between an eighth of a cell and a whole cell.
struct FeatureMaps
{
    using Image = osg::ref_ptr<osg::Image>;

    glm::ivec2 firstCell{0};
    int columns = 0, rows = 0;
    double cellM = 64.0;
    int farPerCell = 1; ///< texels of the far maps along a cell
    std::vector<core::FeatureCells::Runway> runways;
    Image cells, records, crops; ///< null where only beds are wanted
    /// River, asphalt, gravel, runway; of() puts the shade of fields (0…1, times their share) into the last
    /// where it is larger and runways are kMostRunways at most; asphalt alone (GL_RED) where farOf() found
    /// nothing else.
    Image beds;

    /// Of everything that is painted. Cost: about 1 µs a texel of the far maps where something is painted;
    /// several threads. `kept`: what follows from the program alone; the far maps are found there the second
    /// time.
    static FeatureMaps of(const core::FeatureCells& cells, const foundation::KeptFrom& kept = {});

    /// Of beds alone, with texels of a sixteenth of a cell or more; without images where there are no cells.
    /// Where roads of asphalt are all there is, the map has one share and up to 8192×8192 texels.
    static FeatureMaps farOf(const core::FeatureCells& cells, const foundation::KeptFrom& kept = {});
};

/// Returns maps as bytes, for featureMapsIn().
std::string bytesOf(const FeatureMaps& maps);

/// Absent: bytesOf() did not write them.
std::optional<FeatureMaps> featureMapsIn(std::string_view bytes);

} // namespace osgTerrainROAM
