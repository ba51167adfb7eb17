// SPDX-License-Identifier: Apache-2.0
#include "import/ArrayValues.h"

#include <gtest/gtest.h>

namespace
{

using osgPMObjects::valuesOf;

TEST(ArrayValues, FillsMissingComponentsAsOpenGlDoes)
{
    osg::ref_ptr<osg::Vec2Array> array = new osg::Vec2Array;
    array->push_back({3.0f, -4.0f});
    const auto values = valuesOf(*array, false);
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0], glm::dvec4(3.0, -4.0, 0.0, 1.0));
}

TEST(ArrayValues, KeepsTheDigitsOfDoubles)
{
    osg::ref_ptr<osg::Vec3dArray> array = new osg::Vec3dArray;
    array->push_back({6378137.123456, 1.0, 2.0});
    EXPECT_EQ(valuesOf(*array, false).at(0).x, 6378137.123456);
}

TEST(ArrayValues, ScalesIntegersOnlyWhereTheyAreNormalised)
{
    osg::ref_ptr<osg::Vec4ubArray> bytes = new osg::Vec4ubArray;
    bytes->push_back({255, 0, 51, 255});
    EXPECT_EQ(valuesOf(*bytes, true).at(0), glm::dvec4(1.0, 0.0, 0.2, 1.0));
    EXPECT_EQ(valuesOf(*bytes, false).at(0), glm::dvec4(255.0, 0.0, 51.0, 255.0));
    osg::ref_ptr<osg::Vec3sArray> shorts = new osg::Vec3sArray;
    shorts->push_back({-32768, 32767, 0});
    EXPECT_EQ(valuesOf(*shorts, true).at(0), glm::dvec4(-1.0, 1.0, 0.0, 1.0));
}

TEST(ArrayValues, GivesNothingForWhatIsNoAttribute)
{
    osg::ref_ptr<osg::MatrixfArray> array = new osg::MatrixfArray;
    array->resize(3);
    EXPECT_TRUE(valuesOf(*array, false).empty());
}

} // namespace
