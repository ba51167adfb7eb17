// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.7, 7 (geometry).
#include <variant>

#include "ElementWriters.h"
#include "XmlFields.h"

namespace osgRoads::core
{

namespace
{

struct ShapeWriter
{
    pugi::xml_node geometry;
    double lengthM;

    void operator()(const LineShape&) { geometry.append_child("line"); }

    void operator()(const ArcShape& arc) { set(geometry.append_child("arc"), "curvature", arc.curvature); }

    void operator()(const Clothoid& spiral)
    {
        const pugi::xml_node node = geometry.append_child("spiral");
        set(node, "curvStart", spiral.curvatureAt(0.0));
        set(node, "curvEnd", spiral.curvatureAt(lengthM));
    }

    void operator()(const ParametricCubic& curve)
    {
        const pugi::xml_node node = geometry.append_child("paramPoly3");
        set(node, "aU", curve.u().a), set(node, "bU", curve.u().b);
        set(node, "cU", curve.u().c), set(node, "dU", curve.u().d);
        set(node, "aV", curve.v().a), set(node, "bV", curve.v().b);
        set(node, "cV", curve.v().c), set(node, "dV", curve.v().d);
        set(node, "pRange", curve.isByArcLength() ? "arcLength" : "normalized");
    }
};

} // namespace

void writePlanView(pugi::xml_node roadNode, const ReferenceLine& line)
{
    pugi::xml_node plan = roadNode.append_child("planView");
    for (const PlanElement& element : line.elements())
    {
        const PlanPoint start = element.at(0.0);
        pugi::xml_node geometry = plan.append_child("geometry");
        set(geometry, "s", element.s);
        set(geometry, "x", start.position.x);
        set(geometry, "y", start.position.y);
        set(geometry, "hdg", start.headingRad);
        set(geometry, "length", element.length);
        std::visit(ShapeWriter{geometry, element.length}, element.shape());
    }
}

} // namespace osgRoads::core
