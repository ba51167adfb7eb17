// SPDX-License-Identifier: Apache-2.0
// The published triangle counts of a bintree with exact nested error, on the three crops they were measured on.
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "RealData.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

struct Crop
{
    const char* file;
    int firstColumn, firstRowFromNorth, size;
    double cellM;
    std::vector<std::pair<double, std::uint32_t>> trianglesAtErrorM;
};

HeightField cropped(const HeightField& all, const Crop& crop)
{
    HeightField field;
    field.columns = field.rows = crop.size;
    field.spacingEastM = field.spacingNorthM = crop.cellM;
    const int south = all.rows - crop.firstRowFromNorth - crop.size;
    for (int row = 0; row < crop.size; ++row)
        for (int column = 0; column < crop.size; ++column)
            field.heightsM.push_back(all.heightM(crop.firstColumn + column, south + row));
    return field;
}

class Anchors : public testing::TestWithParam<Crop>
{
};

TEST_P(Anchors, NestedRowIsMetExactly)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("dem") / GetParam().file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    RoamMesh mesh(testsupport::planarTile(cropped(*imported, GetParam()), Storage::exact));
    for (const auto& [errorM, triangles] : GetParam().trianglesAtErrorM)
        EXPECT_EQ(mesh.refine(errorM).triangles, triangles) << GetParam().file << " at " << errorM << " m";
}

TEST_P(Anchors, OneRaisedSampleChangesTheCount)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, std::filesystem::path("dem") / GetParam().file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    HeightField field = cropped(*imported, GetParam());
    field.heightsM[field.heightsM.size() / 2 + 101] += 500.0f;
    RoamMesh mesh(testsupport::planarTile(field, Storage::exact));
    const auto& [errorM, triangles] = GetParam().trianglesAtErrorM.front();
    EXPECT_NE(mesh.refine(errorM).triangles, triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Crops, Anchors,
    testing::Values(
        Crop{"N44W072.hgt", 88, 88, 1025, 90.0, {{20, 129615}, {10, 307452}, {5, 652220}}},
        Crop{"S33W071.tif", 88, 88, 1025, 90.0, {{50, 171580}, {20, 569718}}},
        Crop{"greenriver.tif", 700, 300, 513, 1.0, {{1, 1345}, {0.5, 4340}, {0.25, 12927}, {0.1, 51929}}}),
    [](const auto& crop) { return std::string(crop.param.file, 6); });

} // namespace
