// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/ModelCheck.h"

#include <limits>

#include <gtest/gtest.h>

#include "scenery/models/Catalogue.h"

using namespace scenery::models;

namespace
{

/// Returns what the check reports for a car after a deliberate defect.
template<class Spoil>
std::string saidOf(const Spoil& spoil)
{
    Model model = generate(Kind::saloon, 1);
    EXPECT_EQ(defectOf(model), "");
    spoil(model);
    return defectOf(model);
}

} // namespace

TEST(ModelCheck, FindsWhatIsSpoilt)
{
    EXPECT_NE(saidOf([](Model& m) { m.mesh.normals[5] *= 1.01F; }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.normals.clear(); }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.texCoords[0].clear(); }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.colours.clear(); }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.texCoords[0][3].x = std::numeric_limits<float>::quiet_NaN(); }),
              "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.materials[0].state = 9; }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.faces[7].wedges[1] = m.mesh.faces[7].wedges[0]; }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.positions[0].z = -0.1; }), "");
    EXPECT_NE(saidOf([](Model& m) { m.heightM += 0.5; }), "");
    EXPECT_NE(saidOf([](Model& m) { m.radiusM -= 0.5; }), "");
    EXPECT_NE(saidOf([](Model& m) { m.mesh.faces.clear(); }), "");
}

TEST(ModelCheck, AMissingOrTurnedFaceOpensABody)
{
    Model model = generate(Kind::saloon, 1);
    ASSERT_TRUE(isClosed(model.mesh, "body"));
    EXPECT_FALSE(isClosed(model.mesh, "no such part"));
    std::swap(model.mesh.faces[100].wedges[0], model.mesh.faces[100].wedges[1]);
    EXPECT_FALSE(isClosed(model.mesh, "body"));
    model.mesh.faces.erase(model.mesh.faces.begin() + 100);
    EXPECT_FALSE(isClosed(model.mesh, "body"));
}
