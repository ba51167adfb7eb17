// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>

#include "TriangulationCheck.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Polygon;
using testsupport::Random;

double areaOf(const std::vector<glm::dvec2>& points, const Loop& piece)
{
    double area = 0.0;
    for (std::size_t i = 2; i < piece.size(); ++i)
        area += testsupport::areaOf(points, {piece[0], piece[i - 1], piece[i]});
    return area;
}

bool isConvex(const std::vector<glm::dvec2>& points, const Loop& piece)
{
    const std::size_t n = piece.size();
    double turned = 0.0;
    for (std::size_t i = 0; i < n; ++i)
    {
        const glm::dvec2 &a = points[piece[i]], &b = points[piece[(i + 1) % n]],
                         &c = points[piece[(i + 2) % n]];
        if (orientation(a, b, c) < 0.0) return false;
        const glm::dvec2 u = b - a, v = c - b;
        turned += std::atan2(u.x * v.y - u.y * v.x, glm::dot(u, v));
    }
    return std::abs(turned - 2.0 * std::numbers::pi) < 1e-6;
}

bool areApart(const std::vector<glm::dvec2>& points, const Loop& a, const Loop& b)
{
    for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (std::size_t i = 0; i < first->size(); ++i)
            if (std::all_of(second->begin(), second->end(),
                            [&, &one = *first](std::uint32_t p) { // clang 14 captures no structured bindings
                                return orientation(points[one[i]], points[one[(i + 1) % one.size()]],
                                                   points[p]) <= 0.0;
                            }))
                return true;
    return false;
}

/// Returns the defect of pieces that should fill a polygon of that area; empty: none.
std::string defectOf(const std::vector<glm::dvec2>& points, const std::vector<Loop>& pieces, double area)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        if (!isConvex(points, pieces[i])) return "a piece is not convex";
        sum += areaOf(points, pieces[i]);
        for (std::size_t j = 0; j < i; ++j)
            if (!areApart(points, pieces[i], pieces[j])) return "two pieces overlap";
    }
    return std::abs(sum - area) > 1e-9 * std::max(area, 1e-3) ? "the area differs" : "";
}

/// Returns the least number of convex pieces of a simple polygon, by trying all sets of diagonals that do not
/// cross.
class BruteForce
{
public:
    explicit BruteForce(std::vector<glm::dvec2> corners) : _corners(std::move(corners))
    {
        const std::size_t n = _corners.size();
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 2; j < n; ++j)
                if (isDiagonal(i, j)) _diagonals.emplace_back(i, j);
    }

    std::size_t leastPieces()
    {
        _best = _corners.size();
        choose(0);
        return _best;
    }

private:
    using Diagonal = std::pair<std::size_t, std::size_t>;

    bool isDiagonal(std::size_t i, std::size_t j) const
    {
        const std::size_t n = _corners.size();
        if ((j + 1) % n == i) return false;
        const glm::dvec2 &a = _corners[i], &b = _corners[j];
        for (std::size_t k = 0; k < n; ++k)
        {
            const std::size_t l = (k + 1) % n;
            if (k == i || k == j || l == i || l == j) continue;
            const glm::dvec2 &c = _corners[k], &d = _corners[l];
            if ((orientation(a, b, c) > 0.0) != (orientation(a, b, d) > 0.0) &&
                (orientation(c, d, a) > 0.0) != (orientation(c, d, b) > 0.0))
                return false;
        }
        Polygon polygon;
        polygon.add(_corners);
        return testsupport::windingNumber(polygon, (a + b) * 0.5) == 1;
    }

    bool isConvexAt(std::size_t corner) const
    {
        const std::size_t n = _corners.size();
        std::vector<std::size_t> ends{1, n - 1}; // counted from the corner on
        for (const Diagonal& d : _chosen)
            if (d.first == corner || d.second == corner)
                ends.push_back((d.first + d.second + n - 2 * corner) % n);
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            if (orientation(_corners[corner], _corners[(corner + ends[i]) % n],
                            _corners[(corner + ends[i + 1]) % n]) < 0.0)
                return false;
        return true;
    }

    void choose(std::size_t first)
    {
        if (_chosen.size() + 1 >= _best) return;
        bool isDone = true;
        for (std::size_t i = 0; i < _corners.size(); ++i)
            isDone = isDone && isConvexAt(i);
        if (isDone) _best = _chosen.size() + 1;
        for (std::size_t i = first; i < _diagonals.size(); ++i)
        {
            const auto [a, b] = _diagonals[i];
            if (std::any_of(_chosen.begin(), _chosen.end(),
                            [a = a, b = b](const Diagonal& d)
                            {
                                const auto isBetween = [&](std::size_t k) { return k > a && k < b; };
                                const auto isBeyond = [&](std::size_t k) { return k < a || k > b; };
                                return (isBetween(d.first) && isBeyond(d.second)) ||
                                       (isBeyond(d.first) && isBetween(d.second));
                            }))
                continue;
            _chosen.push_back(_diagonals[i]);
            choose(i + 1);
            _chosen.pop_back();
        }
    }

    std::vector<glm::dvec2> _corners;
    std::vector<Diagonal> _diagonals, _chosen;
    std::size_t _best = 0;
};

TEST(ConvexDecomposition, OfAnLIsTwoPieces)
{
    Polygon l;
    l.add({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
    for (const ConvexMethod method : {ConvexMethod::quick, ConvexMethod::leastPieces})
    {
        const auto made = decomposeConvex(l.inSpace(), l.contourSizes, method);
        ASSERT_TRUE(made);
        EXPECT_EQ(made->pieces.size(), 2u);
        EXPECT_EQ(made->isLeast, method == ConvexMethod::leastPieces);
    }
}

TEST(ConvexDecomposition, OfAConvexPolygonWithStraightCornersIsOnePiece)
{
    Polygon square;
    square.add({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    for (const ConvexMethod method : {ConvexMethod::quick, ConvexMethod::leastPieces})
    {
        const auto made = decomposeConvex(square.inSpace(), square.contourSizes, method);
        ASSERT_TRUE(made);
        ASSERT_EQ(made->pieces.size(), 1u);
        EXPECT_EQ(made->pieces[0].size(), 7u);
    }
}

TEST(ConvexDecomposition, HasTheLeastPiecesThatBruteForceFinds)
{
    Random random(21);
    int quickIsWorse = 0;
    for (int i = 0; i < 1000; ++i)
    {
        Polygon made;
        made.add(testsupport::star(random, {0, 0}, 1.0, 5 + random.below(6)));
        const auto least = decomposeConvex(made.inSpace(), made.contourSizes, ConvexMethod::leastPieces);
        const auto quick = decomposeConvex(made.inSpace(), made.contourSizes, ConvexMethod::quick);
        ASSERT_TRUE(least);
        ASSERT_TRUE(quick);
        EXPECT_TRUE(least->isLeast);
        const std::size_t expected = BruteForce(made.corners).leastPieces();
        ASSERT_EQ(least->pieces.size(), expected) << i;
        EXPECT_LE(quick->pieces.size(), 4 * expected); // Hertel and Mehlhorn's bound
        quickIsWorse += quick->pieces.size() > expected;
    }
    EXPECT_GT(quickIsWorse, 0); // else nothing was compared
}

TEST(ConvexDecomposition, FillsPolygonsWithHolesAndTangles)
{
    Random random(22);
    for (int i = 0; i < 2000; ++i)
    {
        const Polygon made = i % 2 == 0 ? testsupport::starWithHoles(random) : testsupport::tangle(random);
        const auto outline = outlinePolygon(made.inSpace(), made.contourSizes);
        ASSERT_TRUE(outline);
        Polygon inPlane = made;
        std::copy_n(outline->points.begin(), made.corners.size(), inPlane.corners.begin());
        const double area = testsupport::oddArea(inPlane);
        for (const ConvexMethod method : {ConvexMethod::quick, ConvexMethod::leastPieces})
        {
            const auto cut = decomposeConvex(made.inSpace(), made.contourSizes, method);
            ASSERT_TRUE(cut);
            ASSERT_EQ(defectOf(outline->points, cut->pieces, area), "") << i;
        }
    }
}

TEST(ConvexDecomposition, OfALoopThatIsTooLargeIsQuick)
{
    Random random(23);
    Polygon large;
    large.add(testsupport::star(random, {0, 0}, 1.0, kMostCornersForLeastPieces + 1));
    const auto made = decomposeConvex(large.inSpace(), large.contourSizes, ConvexMethod::leastPieces);
    ASSERT_TRUE(made);
    EXPECT_FALSE(made->isLeast);
    large = {};
    large.add(testsupport::star(random, {0, 0}, 1.0, kMostCornersForLeastPieces));
    const auto most = decomposeConvex(large.inSpace(), large.contourSizes, ConvexMethod::leastPieces);
    ASSERT_TRUE(most);
    EXPECT_TRUE(most->isLeast);
}

TEST(ConvexDecomposition, CheckFindsEveryKindOfDefect)
{
    const std::vector<glm::dvec2> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0.5, 1}};
    EXPECT_EQ(defectOf(points, {{0, 1, 2, 3}}, 4.0), "");
    EXPECT_EQ(defectOf(points, {{0, 1, 2, 3, 4}}, 3.5), "a piece is not convex");
    EXPECT_EQ(defectOf(points, {{0, 1, 2, 3}, {0, 4, 3}}, 4.0), "two pieces overlap");
    EXPECT_EQ(defectOf(points, {{0, 1, 2}}, 4.0), "the area differs");
    EXPECT_EQ(defectOf(points, {{0, 1, 2, 3, 0, 1, 2, 3}}, 4.0), "a piece is not convex"); // around it twice
}

} // namespace
