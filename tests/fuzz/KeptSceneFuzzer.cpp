// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as what was kept of a scene: lamps, clouds, airfields and what maps paint come back
// as they were written, or nothing does.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "material/FeatureMaps.h"
#include "scene/SceneRunways.h"
#include "scenery/clouds/CloudVolumeBytes.h"
#include "scenery/lights/StreetLampBytes.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

/// What is read is written as bytes that give the same again.
template<class Read>
void readAndWrite(std::string_view bytes, const Read& read)
{
    const auto found = read(bytes);
    if (!found) return;
    const auto written = bytesOf(*found);
    const auto again = read(written);
    if (!again || bytesOf(*again) != written) std::abort();
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    readAndWrite(bytes, scenery::streetLampsIn);
    readAndWrite(bytes, scenery::clouds::cloudVolumeIn);
    readAndWrite(bytes, trainer::sceneAirfieldsIn);
    readAndWrite(bytes, osgTerrainROAM::featureMapsIn);
    return 0;
}
