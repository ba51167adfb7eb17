// SPDX-License-Identifier: Apache-2.0
// The published triangle counts of a bintree with exact nested error, on the three crops they were measured
// on.
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RealData.h"
#include "SyntheticField.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;

struct Crop
{
    measurement::RasterCrop square;
    std::vector<std::pair<double, std::uint32_t>> trianglesAtErrorM;
};

class TriangleCounts : public testing::TestWithParam<Crop>
{
};

TEST_P(TriangleCounts, NestedRowIsMetExactly)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().square.file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    RoamMesh mesh(testsupport::planarTile(GetParam().square.of(*imported), Storage::exact));
    for (const auto& [errorM, triangles] : GetParam().trianglesAtErrorM)
        EXPECT_EQ(mesh.refine(errorM).triangles, triangles)
            << GetParam().square.file << " at " << errorM << " m";
}

TEST_P(TriangleCounts, OneRaisedSampleChangesTheCount)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().square.file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    HeightField field = GetParam().square.of(*imported);
    field.heightsM[field.heightsM.size() / 2 + 101] += 500.0f;
    RoamMesh mesh(testsupport::planarTile(field, Storage::exact));
    const auto& [errorM, triangles] = GetParam().trianglesAtErrorM.front();
    EXPECT_NE(mesh.refine(errorM).triangles, triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Crops, TriangleCounts,
    testing::Values(Crop{measurement::kWhiteMountains, {{20, 129615}, {10, 307452}, {5, 652220}}},
                    Crop{measurement::kAconcagua, {{50, 171580}, {20, 569718}}},
                    Crop{measurement::kGreenRiver, {{1, 1345}, {0.5, 4340}, {0.25, 12927}, {0.1, 51929}}}),
    [](const auto& crop)
    { return std::filesystem::path(crop.param.square.file).stem().string().substr(0, 6); });

} // namespace
