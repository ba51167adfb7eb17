// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/BlendFunc>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Image>
#include <osg/Material>
#include <osg/Texture2D>

#include <osgPMObjects/core/mesh/MeshCheck.h>

#include <osgPMObjects/BakeModel>

namespace
{

using namespace osgPMObjects;

/// A square of side 1 at a height, front side up, with texture coordinates from 0 to `repeats`.
osg::ref_ptr<osg::Geometry> square(double height, float repeats = 1.0f)
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> texels = new osg::Vec2Array;
    for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    {
        corners->push_back(osg::Vec3d(x, y, height));
        texels->push_back({repeats * static_cast<float>(x), repeats * static_cast<float>(y)});
    }
    geometry->setVertexArray(corners);
    geometry->setTexCoordArray(0, texels, osg::Array::BIND_PER_VERTEX);
    osg::ref_ptr<osg::Vec3Array> normal = new osg::Vec3Array(osg::Array::BIND_OVERALL);
    normal->push_back({0, 0, 1});
    geometry->setNormalArray(normal);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    return geometry;
}

osg::ref_ptr<osg::Material> material(const osg::Vec4& ambient, const osg::Vec4& diffuse,
                                     const osg::Vec4& specular)
{
    osg::ref_ptr<osg::Material> m = new osg::Material;
    m->setAmbient(osg::Material::FRONT_AND_BACK, ambient);
    m->setDiffuse(osg::Material::FRONT_AND_BACK, diffuse);
    m->setSpecular(osg::Material::FRONT_AND_BACK, specular);
    return m;
}

/// A texture, its left half black, its right half white.
osg::ref_ptr<osg::Texture2D> halves()
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    image->data()[0] = 0;
    image->data()[1] = 255;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

ImportedModel imported(const std::vector<osg::ref_ptr<osg::Geometry>>& geometries)
{
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (const auto& geometry : geometries)
        geode->addDrawable(geometry);
    auto model = importNode(*geode, "made");
    EXPECT_TRUE(model);
    return *model;
}

BakedModel baked(const ImportedModel& full, int sizePx = 64)
{
    auto result = bakeModel(full, full.mesh, {.charts = {}, .atlas = {.sizePx = sizePx}, .maps = {}});
    EXPECT_TRUE(result) << result.error().message();
    return result ? *result : BakedModel();
}

const osg::Image& mapOf(const BakedModel& model, unsigned unit, std::uint32_t state = 0)
{
    const auto* texture = dynamic_cast<const osg::Texture2D*>(
        model.model.states[state]->getTextureAttribute(unit, osg::StateAttribute::TEXTURE));
    return *texture->getImage();
}

/// Returns the colour map at a position, times the diffuse colour of the material there.
osg::Vec4 diffuseAt(const BakedModel& baked, std::uint32_t f, const glm::dvec2& place)
{
    const core::Mesh& mesh = baked.model.mesh;
    const core::Face& face = mesh.faces[f];
    const auto at = [&](int c) { return glm::dvec2(mesh.at(face, c)); };
    const glm::dvec2 ab = at(1) - at(0), ac = at(2) - at(0), ap = place - at(0);
    const double whole = ab.x * ac.y - ab.y * ac.x;
    const float v = static_cast<float>((ap.x * ac.y - ap.y * ac.x) / whole);
    const float w = static_cast<float>((ab.x * ap.y - ab.y * ap.x) / whole);
    const auto& uv = mesh.texCoords[0];
    const glm::vec2 texel =
        (1.0f - v - w) * uv[face.wedges[0]] + v * uv[face.wedges[1]] + w * uv[face.wedges[2]];
    const osg::StateSet& state = *baked.model.states[mesh.materials[face.material].state];
    const auto* look = dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    const osg::Image& map = mapOf(baked, 0);
    const osg::Vec4 colour = map.getColor(static_cast<unsigned>(texel.x * static_cast<float>(map.s())),
                                          static_cast<unsigned>(texel.y * static_cast<float>(map.t())));
    return look ? osg::componentMultiply(colour, look->getDiffuse(osg::Material::FRONT)) : colour;
}

void expectNear(const osg::Vec4& a, const osg::Vec4& b)
{
    EXPECT_LT((a - b).length(), 0.02) << a.r() << ' ' << a.g() << ' ' << a.b() << ' ' << a.a() << " is not "
                                      << b.r() << ' ' << b.g() << ' ' << b.b() << ' ' << b.a();
}

TEST(BakeModel, ColoursAreTextureTimesMaterial)
{
    const auto geometry = square(0.0, 2.0f); // the texture repeats twice
    geometry->getOrCreateStateSet()->setTextureAttributeAndModes(0, halves());
    geometry->getOrCreateStateSet()->setAttribute(
        material({0.2f, 0.1f, 0.05f, 1.0f}, {0.8f, 0.4f, 0.2f, 1.0f}, {0.1f, 0.1f, 0.1f, 1.0f}));
    const BakedModel model = baked(imported({geometry}));
    EXPECT_EQ(core::defectOf(model.model.mesh), "");
    expectNear(diffuseAt(model, 0, {0.875, 0.5}), {0.8f, 0.4f, 0.2f, 1.0f});
    expectNear(diffuseAt(model, 0, {0.625, 0.4}), {0.0f, 0.0f, 0.0f, 1.0f});
    expectNear(diffuseAt(model, 1, {0.375, 0.8}), {0.8f, 0.4f, 0.2f, 1.0f});
    expectNear(diffuseAt(model, 1, {0.125, 0.8}), {0.0f, 0.0f, 0.0f, 1.0f});
}

TEST(BakeModel, MaterialsKeepTheRatiosOfTheirLight)
{
    const auto geometry = square(0.0);
    const osg::Vec4 ambient(0.9f, 0.3f, 0.0f, 1.0f), diffuse(0.3f, 0.6f, 0.0f, 0.5f),
        gloss(0.1f, 0.1f, 0.8f, 1.0f);
    geometry->getOrCreateStateSet()->setAttribute(material(ambient, diffuse, gloss));
    const BakedModel model = baked(imported({geometry}));
    const auto* look = dynamic_cast<const osg::Material*>(
        model.model.states[0]->getAttribute(osg::StateAttribute::MATERIAL));
    ASSERT_TRUE(look);
    const osg::Vec4 map = mapOf(model, 0).getColor(32u, 32u);
    constexpr auto kFront = osg::Material::FRONT;
    const auto times = [&](osg::Vec4 c)
    {
        c = osg::componentMultiply(c, map);
        c.a() = 1.0f;
        return c;
    };
    expectNear(times(look->getAmbient(kFront)), ambient);
    expectNear(times(look->getSpecular(kFront)), gloss);
    expectNear(diffuseAt(model, 0, {0.6, 0.3}), diffuse);
}

TEST(BakeModel, VertexColoursAreKept)
{
    const auto geometry = square(0.0);
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(osg::Array::BIND_PER_VERTEX);
    for (const float x : {0.0f, 1.0f, 1.0f, 0.0f})
        colours->push_back({x, 0.5f, 1.0f - x, 1.0f});
    geometry->setColorArray(colours);
    for (const bool isLit : {true, false})
    {
        geometry->getOrCreateStateSet()->setMode(GL_LIGHTING, isLit);
        const BakedModel model = baked(imported({geometry}));
        expectNear(diffuseAt(model, 0, {0.75, 0.25}), {0.75f, 0.5f, 0.25f, 1.0f});
        EXPECT_EQ(model.model.states[0]->getAttribute(osg::StateAttribute::PROGRAM) != nullptr, isLit);
    }
}

TEST(BakeModel, StatesThatDifferedInColourOnlyBecomeOne)
{
    std::vector<osg::ref_ptr<osg::Geometry>> squares;
    for (int i = 0; i < 4; ++i)
    {
        squares.push_back(square(i));
        const float x = 0.2f + 0.2f * static_cast<float>(i);
        const osg::Vec4 colour(x, 1.0f - x, 0.5f, 1.0f);
        squares.back()->getOrCreateStateSet()->setAttribute(material(colour, colour, {0, 0, 0, 1}));
    }
    squares[3]->getOrCreateStateSet()->setAttributeAndModes(new osg::BlendFunc);
    const BakedModel model = baked(imported(squares), 128);
    EXPECT_EQ(model.model.states.size(), 2u);
    EXPECT_EQ(model.model.mesh.materials.size(), 2u);
    EXPECT_TRUE(model.model.mesh.materials[1].isTransparent);
    for (std::uint32_t f = 0; f < 8; ++f)
    {
        const float x = 0.2f + 0.2f * static_cast<float>(f / 2);
        expectNear(diffuseAt(model, f, {f % 2 == 0 ? 0.6 : 0.4, 0.5}), {x, 1.0f - x, 0.5f, 1.0f});
    }
}

TEST(BakeModel, FixedFunctionSeesTheColoursAndNotTheNormals)
{
    const BakedModel model = baked(imported({square(0.0)}));
    const osg::StateSet& state = *model.model.states[0];
    EXPECT_TRUE(state.getTextureMode(0, GL_TEXTURE_2D) & osg::StateAttribute::ON);
    EXPECT_FALSE(state.getTextureMode(1, GL_TEXTURE_2D) & osg::StateAttribute::ON);
    EXPECT_TRUE(state.getTextureAttribute(1, osg::StateAttribute::TEXTURE));
    const osg::Vec4 up = mapOf(model, 1).getColor(32u, 32u);
    EXPECT_LT((up - osg::Vec4(0.5f, 0.5f, 1.0f, 1.0f)).length(), 0.01);
}

TEST(BakeModel, CountsTexturesThatCannotBeRead)
{
    const auto geometry = square(0.0);
    geometry->getOrCreateStateSet()->setTextureAttributeAndModes(0, new osg::Texture2D);
    EXPECT_EQ(baked(imported({geometry})).report.texturesNotRead, 1u);
}

TEST(BakeModel, SaysWhatItCannotDo)
{
    const ImportedModel full = imported({square(0.0)});
    EXPECT_FALSE(bakeModel(full, full.mesh, {.charts = {}, .atlas = {.sizePx = 100}, .maps = {}}));
    core::Mesh nothing = full.mesh;
    nothing.faces.clear();
    const auto refused = bakeModel(full, nothing);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message().find("no faces"), std::string::npos);
}

TEST(BakeModelMutation, AnotherColourIsSeen)
{
    const auto geometry = square(0.0);
    geometry->getOrCreateStateSet()->setAttribute(
        material({0.8f, 0.4f, 0.2f, 1.0f}, {0.8f, 0.4f, 0.2f, 1.0f}, {0, 0, 0, 1}));
    BakedModel model = baked(imported({geometry}));
    auto& map = const_cast<osg::Image&>(mapOf(model, 0));
    map.data()[3 * (32 * 64 + 32)] = 0;
    const core::Mesh& mesh = model.model.mesh;
    double least = 1.0; // the least red of the map over the square
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            least =
                std::min<double>(least, diffuseAt(model, 0, {(x + 0.5) / 64.0, 0.5 * (y + 0.5) / 64.0}).r());
    EXPECT_EQ(mesh.faces.size(), 2u);
    EXPECT_EQ(least, 0.0);
}

} // namespace
