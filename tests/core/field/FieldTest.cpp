// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "FieldScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::FieldSubject;

TEST(Field, HasEveryObjectInOneCell)
{
    const Field field = testsupport::scatteredField({FieldSubject::torus().model()}, 10000, 2000.0);
    EXPECT_TRUE(isField(field));
    EXPECT_GT(field.cells().size(), 150u);
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < field.objects().size(); ++i)
        numbers.push_back(field.numberOf(i));
    std::sort(numbers.begin(), numbers.end());
    for (std::uint32_t i = 0; i < numbers.size(); ++i)
        ASSERT_EQ(numbers[i], i);
}

TEST(Field, TakesAwkwardArrangements)
{
    const FieldModel model = FieldSubject::torus().model();
    EXPECT_TRUE(isField(Field({model}, {})));
    EXPECT_TRUE(isField(Field({model}, {FieldObject{}})));
    EXPECT_TRUE(isField(Field({model}, std::vector<FieldObject>(5000)))) << "all at one place";
    std::vector<FieldObject> row(3000);
    for (std::size_t i = 0; i < row.size(); ++i)
        row[i].position.x = 7.0 * static_cast<double>(i);
    const Field avenue({model}, row);
    EXPECT_TRUE(isField(avenue));
    EXPECT_GT(avenue.cells().size(), 30u);
    row.back().position = {1e7, -1e7, 0.0};
    EXPECT_TRUE(isField(Field({model}, row))) << "one far off";
}

/// The visible objects are those whose spheres are in the frustum, tested one by one.
TEST(Field, IsCulledToWhatEverySphereAloneWouldBe)
{
    const Field field = testsupport::scatteredField({FieldSubject::torus().model()}, 4000, 500.0);
    testsupport::Random random(3);
    for (std::uint64_t frame = 1; frame < 60; ++frame)
    {
        const auto view =
            testsupport::viewTo(testsupport::direction(random) * testsupport::between(random, 5.0, 700.0),
                                testsupport::direction(random) * 100.0);
        FieldView memory(field);
        const FieldDrawList drawList = memory.update(testsupport::cameraFrom(view, frame));
        std::uint32_t seen = 0, withoutTheirSize = 0;
        for (const BoundingSphere& sphere : field.spheres())
        {
            seen += !view.frustum.classify(sphere.centre, sphere.radius, 0x0F).outside;
            withoutTheirSize += !view.frustum.classify(sphere.centre, 0.0, 0x0F).outside;
        }
        ASSERT_EQ(drawList.visible, seen) << frame;
        if (seen < 500) continue;
        EXPECT_NE(drawList.visible, withoutTheirSize) << "would not be noticed";
    }
}

} // namespace
