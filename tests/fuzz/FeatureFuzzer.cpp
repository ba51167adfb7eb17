// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a map: it is read and cut into cells, or refused. The bytes are a file in memory,
// called a GeoJSON.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include <cpl_vsi.h>

#include <osgTerrainROAM/core/features/FeatureCover.h>
#include <osgTerrainROAM/core/features/FeatureImport.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace osgTerrainROAM::core;

const PlacedTile& tile()
{
    static const PlacedTile made = []
    {
        HeightField field;
        field.name = "fuzz";
        field.columns = field.rows = 33;
        field.spacingEastM = field.spacingNorthM = 30.0;
        field.heightsM.assign(33 * 33, 10.0f);
        return PlacedTile(std::move(field), Placement::planar);
    }();
    return made;
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr const char* kName = "/vsimem/fuzz.geojson";
    VSIFCloseL(VSIFileFromMemBuffer(kName, const_cast<std::uint8_t*>(data), size, FALSE));
    const auto set = importFeatures(kName, tile());
    VSIUnlink(kName);
    if (!set) return 0;
    const auto cells = FeatureCells::build(set->features);
    if (!cells) return 0;
    if (!cells->isConsistent()) std::abort();
    for (int i = 0; i < 64; ++i)
        featureCover(*cells, {15.0 * i, 960.0 - 15.0 * i}, 1.0);
    return 0;
}
