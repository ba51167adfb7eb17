// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/method/PrepareTerrain.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

TEST(Method, HasOneName)
{
    for (std::size_t i = 0; i < kMethods.size(); ++i)
    {
        EXPECT_EQ(static_cast<std::size_t>(kMethods[i].method), i)
            << "the table is not in the enumeration's order";
        EXPECT_EQ(methodNamed(kMethods[i].name), kMethods[i].method);
    }
    EXPECT_EQ(methodsByName().size(), kMethods.size());
    EXPECT_FALSE(methodNamed("magic"));
    EXPECT_FALSE(methodNamed(""));
}

TEST(Method, RefusesWhatItCannotDoByItsName)
{
    for (const MethodTraits& traits : kMethods)
    {
        const auto accepts = [&](const MethodRequest& request)
        {
            const auto checked = checkMethod(request, "RoamDrawable");
            if (!checked)
            {
                EXPECT_EQ(checked.error().place, "RoamDrawable.method");
                EXPECT_NE(checked.error().what.find(traits.name), std::string::npos);
                EXPECT_FALSE(checked.error().remedy.empty());
            }
            return static_cast<bool>(checked);
        };
        EXPECT_TRUE(accepts({.method = traits.method}));
        EXPECT_EQ(accepts({.method = traits.method, .patchExponent = 4}), traits.hasPatches);
        EXPECT_EQ(accepts({.method = traits.method, .morphing = true}), traits.morphs);
        EXPECT_EQ(accepts({.method = traits.method, .limitsTime = true}), traits.stopsInTime);
    }
}

TEST(Method, EveryOneDrawsATile)
{
    const auto tile = testsupport::planarTile(testsupport::hills(40, 35));
    for (const MethodTraits& traits : kMethods)
    {
        const auto prepared = prepareTerrain(tile, {.method = traits.method});
        ASSERT_TRUE(prepared) << traits.name;
        const std::unique_ptr<TerrainMesh> mesh = (*prepared)->newMesh();
        EXPECT_EQ(&mesh->tile(), tile.get());
        const RefineResult coarse = mesh->refine(1e9);
        EXPECT_LE(coarse.leaves, (*prepared)->fewestTriangles()) << traits.name;
        const RefineResult fine = mesh->refine(5.0);
        EXPECT_GT(fine.triangles, coarse.triangles) << traits.name;
        EXPECT_EQ(fine.triangles, mesh->drawn().triangles.size()) << traits.name;
        EXPECT_TRUE(mesh->isValid()) << traits.name;
    }
}

} // namespace
