// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include <osg/Vec3d>

#include <osgTraversal/ValueLines>

namespace paint
{

enum class Coat
{
    matt,
    gloss
};

constexpr auto sceneFileNames(Coat)
{
    return std::array{"matt", "gloss"};
}

struct Layer
{
    double thicknessM = 0.0;
    bool isDry = false;
};

void visitNumbers(auto& layer, auto&& visit)
{
    visit(layer.thicknessM);
    visit(layer.isDry);
}

struct Can
{
    Coat coat = Coat::matt;
    float share = 0.0f;
    osg::Vec3d colour;
    std::optional<double> priceEuros;
    std::vector<Layer> layers;
};

void visitFields(auto& can, auto& visit)
{
    visit("coat", can.coat);
    visit("share", can.share);
    visit("colour", can.colour);
    visit("priceEuros", can.priceEuros);
    visit("layers", can.layers);
}

} // namespace paint

namespace
{

std::vector<std::string> linesOf(const paint::Can& can)
{
    osgTraversal::LineWriter writer;
    visitFields(can, writer);
    return writer.lines;
}

std::string complaintOf(const std::vector<std::string>& lines)
{
    paint::Can can;
    osgTraversal::LineReader reader(lines);
    visitFields(can, reader);
    return reader.complaint();
}

} // namespace

TEST(ValueLines, AreWrittenAndReadAsTheyWere)
{
    const paint::Can can{paint::Coat::gloss,
                         0.1f,
                         {1.0, std::numeric_limits<double>::infinity(), -2.5},
                         7.25,
                         {{0.5, true}, {2.0, false}}};
    const std::vector<std::string> lines = linesOf(can);
    EXPECT_EQ(lines, (std::vector<std::string>{"coat=gloss", "share=0.1", "colour=1,inf,-2.5",
                                               "priceEuros=7.25", "layers=0.5,1,2,0"}));
    paint::Can read;
    osgTraversal::LineReader reader(lines);
    visitFields(read, reader);
    EXPECT_EQ(reader.complaint(), "");
    EXPECT_EQ(linesOf(read), lines);
}

TEST(ValueLines, OfAnAbsentValueAreNone)
{
    const std::vector<std::string> lines = linesOf({});
    EXPECT_EQ(lines, (std::vector<std::string>{"coat=matt", "share=0", "colour=0,0,0", "layers"}));
    EXPECT_EQ(complaintOf(lines), "");
    EXPECT_EQ(complaintOf({}), "");
}

TEST(ValueLines, ThatCannotBeReadAreNamed)
{
    EXPECT_EQ(complaintOf({"coat=rough"}), "coat cannot be \"rough\"");
    EXPECT_EQ(complaintOf({"share=0.1,0.2"}), "share cannot be \"0.1,0.2\"");
    EXPECT_EQ(complaintOf({"colour=1,2"}), "colour cannot be \"1,2\"");
    EXPECT_EQ(complaintOf({"layers=1,2"}), "layers cannot be \"1,2\"");
    EXPECT_EQ(complaintOf({"layers=1,1,"}), "layers cannot be \"1,1,\"");
    EXPECT_EQ(complaintOf({"lid=1"}), "\"lid\" is not known");
}
