// SPDX-License-Identifier: Apache-2.0
// The mean colours of materials, as their states show them.
#include <gtest/gtest.h>

#include <osg/Image>
#include <osg/Material>
#include <osg/Texture2D>

#include <osgPMObjects/MaterialLooks>

namespace
{

using namespace osgPMObjects;

/// Two triangles, one of three times the other's area, red and blue.
core::Mesh twoColoured(std::uint32_t attributes, std::uint32_t unseen)
{
    core::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {8, 0, 0}, {5, 1, 0}};
    mesh.wedgePositions = {0, 1, 2, 3, 4, 5};
    mesh.colours = {{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}};
    mesh.faces = {{{0, 1, 2}, 0, 0}, {{3, 4, 5}, 0, 0}};
    mesh.materials = {{.name = "two", .attributes = attributes, .unseen = unseen}};
    mesh.parts = {{}};
    return mesh;
}

osg::ref_ptr<osg::StateSet> greenState()
{
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4(0.0f, 1.0f, 0.0f, 1.0f));
    state->setAttribute(material);
    return state;
}

/// A white texel, and one that is transparent.
osg::ref_ptr<osg::Texture2D> halfTransparent()
{
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setColor(osg::Vec4(1.0f, 0.2f, 0.0f, 1.0f), 0u, 0u);
    image->setColor(osg::Vec4(0.0f, 0.0f, 0.0f, 0.0f), 1u, 0u);
    return new osg::Texture2D(image);
}

void expectColour(const core::Mesh& mesh, const osg::ref_ptr<osg::StateSet>& state, const glm::vec3& wanted)
{
    const std::vector<osg::ref_ptr<osg::StateSet>> states{state};
    const auto colours = materialColours(mesh, states);
    ASSERT_EQ(colours.size(), 1u);
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(colours[0][channel], wanted[channel], 0.01f);
}

TEST(MaterialColours, AreThoseOfWedgesByAreaWhereTheStateShowsThem)
{
    expectColour(twoColoured(core::Material::colour, 0), greenState(), {0.25f, 0.0f, 0.75f});
}

TEST(MaterialColours, AreDiffuseWhereWedgesAreNotSeen)
{
    expectColour(twoColoured(core::Material::colour, core::Material::colour), greenState(),
                 {0.0f, 1.0f, 0.0f});
    expectColour(twoColoured(0, 0), greenState(), {0.0f, 1.0f, 0.0f});
}

TEST(MaterialColours, AreTimesTheOpaqueTexels)
{
    const osg::ref_ptr<osg::StateSet> state = greenState();
    state->setTextureAttributeAndModes(0, halfTransparent());
    expectColour(twoColoured(core::Material::texCoord0, 0), state, {0.0f, 0.2f, 0.0f});
}

} // namespace
