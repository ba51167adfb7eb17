// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 9 (geometry); 1.4, 5.3.4.1.4 (poly3).
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

constexpr double kStraight =
    1e-12; ///< 1/m: a curvature below this bends a road by less than double arithmetic tells
constexpr double kNoLengthM = 1e-4; ///< programs end roads with such elements
constexpr double kLengthErrorM = 0.01;

struct GeometryRecord
{
    double s, length;
    glm::dvec2 position;
    double headingRad;
};

CurveCoefficients coefficients(NodeReader& element, const char* const (&names)[4])
{
    return {element.number(names[0]), element.number(names[1]), element.number(names[2]),
            element.number(names[3])};
}

/// A curve that winds too often is told, and replaced by a line.
PlanElement::Shape bentShape(NodeReader& element, const GeometryRecord& record, double sharpest,
                             const PlanElement::Shape& shape)
{
    const double turnRad = std::fabs(sharpest) * record.length;
    if (turnRad <= Clothoid::kMostTurnRad) return shape;
    element.mistake(std::string(element.node.name()) + " turns by " + shortNumber(turnRad) + " rad",
                    "check curvature and length; a line is used");
    return LineShape{};
}

/// A curve of another length than its record says is told, and a curve without length replaced by a line.
PlanElement::Shape cubicShape(NodeReader& element, const ParametricCubic& curve)
{
    const double ratio = curve.lengthRatio();
    if (!(ratio > 1e-6 && ratio < 1e6))
    {
        element.mistake(std::string(element.node.name()) + " has no usable length",
                        "check its coefficients; a line is used");
        return LineShape{};
    }
    if (std::fabs(ratio - 1.0) > 0.01)
        element.mistake(std::string(element.node.name()) + " is " + shortNumber(ratio) +
                            " times as long as its geometry says",
                        "correct length or coefficients; it is scaled to fit");
    return curve;
}

PlanElement::Shape paramPoly3(NodeReader& element, double length)
{
    const CurveCoefficients u = coefficients(element, {"aU", "bU", "cU", "dU"});
    const CurveCoefficients v = coefficients(element, {"aV", "bV", "cV", "dV"});
    const std::string range = element.text("pRange");
    if (range == "arcLength") return cubicShape(element, ParametricCubic::byArcLength(u, v, length));
    if (range != "normalized" && !range.empty())
        element.mistake("pRange has the unknown value \"" + range.substr(0, 40) + "\"",
                        "write arcLength or normalized, which is used");
    return cubicShape(element, ParametricCubic::normalized(u, v, length));
}

std::optional<PlanElement::Shape> readShape(NodeReader& geometry, const GeometryRecord& record)
{
    std::optional<PlanElement::Shape> shape;
    geometry.each("line", [&](NodeReader&) { shape = LineShape{}; });
    geometry.each("arc",
                  [&](NodeReader& element)
                  {
                      const double curvature = element.number("curvature");
                      shape = std::fabs(curvature) < kStraight
                                  ? PlanElement::Shape(LineShape{})
                                  : bentShape(element, record, curvature, ArcShape{curvature});
                  });
    geometry.each("spiral",
                  [&](NodeReader& element)
                  {
                      const double start = element.number("curvStart"), end = element.number("curvEnd");
                      shape = bentShape(element, record, std::max(std::fabs(start), std::fabs(end)),
                                        Clothoid(start, end, record.length));
                  });
    geometry.each("poly3",
                  [&](NodeReader& element)
                  {
                      shape = cubicShape(
                          element, ParametricCubic::function(coefficients(element, {"a", "b", "c", "d"}),
                                                             record.length));
                  });
    geometry.each("paramPoly3", [&](NodeReader& element) { shape = paramPoly3(element, record.length); });
    return shape;
}

/// Reads one geometry; nothing when it has no length or cannot be used, which `isSound` tells.
std::optional<PlanElement> readGeometry(NodeReader& geometry, double roadLength, bool& isSound)
{
    // Programs end roads with an element of length 0; the only element of a road stands for all of it.
    const bool isOnly =
        !geometry.node.previous_sibling("geometry") && !geometry.node.next_sibling("geometry");
    GeometryRecord record{geometry.number("s"), geometry.number("length"),
                          glm::dvec2(geometry.number("x"), geometry.number("y")), geometry.number("hdg")};
    if (record.length < 0.0 || record.length > kLongestRoadM || record.s < 0.0)
    {
        geometry.mistake("geometry has the length " + shortNumber(record.length) + " m at s " +
                             shortNumber(record.s),
                         "write lengths between 0 and 1e6 m; the road is left out");
        isSound = false;
        return std::nullopt;
    }
    if (record.length < kNoLengthM && !isOnly)
    {
        for (const char* word : {"line", "arc", "spiral", "poly3", "paramPoly3"})
            geometry.passOver(word);
        return std::nullopt;
    }
    if (record.length < kNoLengthM)
    {
        geometry.mistake("the only geometry has no length", "write it; that of the road is used");
        record.length = roadLength;
    }
    std::optional<PlanElement::Shape> shape = readShape(geometry, record);
    if (!shape)
    {
        geometry.mistake("geometry has no shape", "add line, arc, spiral or paramPoly3; a line is used");
        shape = LineShape{};
    }
    return PlanElement(record.s, record.length, record.position, record.headingRad, std::move(*shape));
}

/// Tells lengths that do not add up. A plan view that is shorter than its road ends the road.
void fitLengths(NodeReader& road, Road& into, const std::vector<PlanElement>& elements)
{
    for (std::size_t i = 0; i + 1 < elements.size(); ++i)
        if (const double end = elements[i].s + elements[i].length;
            std::fabs(end - elements[i + 1].s) > kLengthErrorM)
            road.mistake("a geometry ends at s " + shortNumber(end) + ", the next begins at " +
                             shortNumber(elements[i + 1].s),
                         "correct s or length");
    const double end = elements.back().s + elements.back().length;
    if (std::fabs(end - into.length) <= kLengthErrorM) return;
    road.mistake("the plan view ends at " + shortNumber(end) + " m, the road at " + shortNumber(into.length) +
                     " m",
                 "make both equal; the lesser is used");
    into.length = std::min(into.length, end);
}

} // namespace

void readPlanView(NodeReader& road, Road& into)
{
    std::vector<PlanElement> elements;
    bool isSound = true;
    const auto readAll = [&](NodeReader& planView)
    {
        planView.each("geometry",
                      [&](NodeReader& geometry)
                      {
                          if (auto element = readGeometry(geometry, into.length, isSound))
                              elements.push_back(std::move(*element));
                      });
        sortByStart(planView, "geometry", elements);
    };
    road.each("planView", readAll);
    if (!isSound) return;
    if (elements.empty())
    {
        road.mistake("there is no geometry in planView", "add one; the road is left out");
        return;
    }
    if (elements.front().s > kLengthErrorM)
        road.mistake("the plan view begins at s " + shortNumber(elements.front().s), "begin it at 0");
    elements.front().s = 0.0;
    fitLengths(road, into, elements);
    into.referenceLine = ReferenceLine(std::move(elements));
}

} // namespace osgRoads::core
