// SPDX-License-Identifier: Apache-2.0
// Tests how generated models are drawn: visible, lit, with outward faces.
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "RenderedView.h"
#include "scenery/models/Catalogue.h"
#include "scenery/nodes/ModelStates.h"

using namespace scenery::models;

namespace
{

constexpr int kWidthPx = 160;
constexpr int kHeightPx = 160;

struct Looks
{
    double covered = 0.0; ///< share of the picture that the model covers
    double black = 0.0;   ///< share of the covered pixels that are black
    double holes = 0.0;   ///< share of the covered pixels that change when back faces are drawn too
};

osg::ref_ptr<osg::Image> pictureOf(const Model& model, bool drawsBacks)
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = kWidthPx;
    settings.heightPx = kHeightPx;
    const rendered::ViewScene scene;
    scenery::ModelStates states;
    const double size = std::max(model.radiusM, 0.6 * model.heightM);
    const osg::ref_ptr<osg::Group> node = scenery::makeModelNode(model, states);
    if (drawsBacks)
        node->getOrCreateStateSet()->setMode(GL_CULL_FACE,
                                             osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
    scene.root->addChild(node);
    return rendered::pictureFrom(
        scene.root, scenery::poseLookingAt({2.6 * size, -2.2 * size, 1.2 * size}, {0.0, 0.0, 0.4 * size}),
        settings);
}

int differenceAt(const osg::Image& a, const osg::Image& b, unsigned x, unsigned y)
{
    int largest = 0;
    for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(a.data(x, y)[c] - b.data(x, y)[c]));
    return largest;
}

Looks looksOf(const Model& model)
{
    // The background from the same eye: the bounds of the model, without its faces.
    Model nothing = model;
    nothing.mesh.faces.clear();
    const auto background = pictureOf(nothing, false);
    const auto drawn = pictureOf(model, false);
    const auto withBacks = pictureOf(model, true);
    Looks looks;
    for (unsigned y = 0; y < kHeightPx; ++y)
        for (unsigned x = 0; x < kWidthPx; ++x)
        {
            const bool isModel = differenceAt(*drawn, *background, x, y) > 6;
            const unsigned char* pixel = drawn->data(x, y);
            looks.covered += isModel ? 1.0 : 0.0;
            looks.black += isModel && std::max({pixel[0], pixel[1], pixel[2]}) < 14 ? 1.0 : 0.0;
            looks.holes += differenceAt(*drawn, *withBacks, x, y) > 6 ? 1.0 : 0.0;
        }
    const double seen = std::max(looks.covered, 1.0);
    return {looks.covered / (kWidthPx * kHeightPx), looks.black / seen, looks.holes / seen};
}

constexpr double kMostHoles = 0.01, kMostAtWings = 0.015; ///< edges of wings are thinner than a pixel

bool isSound(const Looks& looks, double mostHoles = kMostHoles)
{
    return looks.covered > 0.02 && looks.covered < 0.6 && looks.black < 0.01 && looks.holes < mostHoles;
}

std::string textOf(const Looks& looks)
{
    return "covered " + std::to_string(looks.covered) + ", black " + std::to_string(looks.black) +
           ", holes " + std::to_string(looks.holes);
}

} // namespace

TEST(GeneratedModels, AreSeenLitAndWithoutHoles)
{
    for (const KindFacts& facts : kinds())
    {
        const Looks looks = looksOf(generate(facts.kind, 2));
        const bool hasLowWings = facts.kind == Kind::airliner || facts.kind == Kind::lightAircraft;
        const double mostHoles = hasLowWings ? kMostAtWings : kMostHoles;
        EXPECT_TRUE(isSound(looks, mostHoles)) << facts.name << ": " << textOf(looks);
    }
}

TEST(GeneratedModels, TurnedFacesWouldBeSeen)
{
    for (const Kind kind : {Kind::saloon, Kind::familyHouse, Kind::townHouses})
    {
        Model model = generate(kind, 2);
        for (std::size_t i = 0; i < model.mesh.faces.size(); i += 10)
            std::swap(model.mesh.faces[i].wedges[0], model.mesh.faces[i].wedges[1]);
        EXPECT_FALSE(isSound(looksOf(model))) << factsOf(kind).name;
    }
}

TEST(GeneratedModels, BlackPatchesWouldBeSeen)
{
    for (const Kind kind : {Kind::oak, Kind::barn})
    {
        Model model = generate(kind, 2);
        for (std::size_t i = 0; i < model.mesh.colours.size() / 2; ++i)
            model.mesh.colours[i] = glm::vec4(0.0F, 0.0F, 0.0F, 1.0F);
        EXPECT_FALSE(isSound(looksOf(model))) << factsOf(kind).name;
    }
}

TEST(GeneratedModels, NormalsThatAreNoNumbersWouldBeSeen)
{
    Model model = generate(Kind::barn, 2);
    for (glm::vec3& normal : model.mesh.normals)
        normal.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(isSound(looksOf(model)));
}

TEST(GeneratedModels, NothingWouldBeSeen)
{
    Model model = generate(Kind::bush, 2);
    model.mesh.faces.clear();
    EXPECT_FALSE(isSound(looksOf(model)));
}
