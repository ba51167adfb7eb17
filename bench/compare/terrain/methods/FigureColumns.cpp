// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/FigureColumns.h"

#include <optional>

#include "measurement/HtmlPage.h"

namespace terraintool
{

namespace
{

using measurement::figureText;

std::string orNone(const std::optional<double>& value)
{
    return value ? figureText(*value) : "–";
}

/// A figure of adaptation; nothing where there is none.
std::optional<double> adaptation(const MethodFigures& m, double figure)
{
    return m.adapts ? std::optional(figure) : std::nullopt;
}

} // namespace

const std::vector<FigureColumn>& figureColumns()
{
    static const std::vector<FigureColumn> all{
        {"triangles", [](const MethodFigures& m) { return figureText(m.triangles); }},
        {"true error, px", [](const MethodFigures& m) { return figureText(m.trueErrorPx); }},
        {"own tolerance, px", [](const MethodFigures& m) { return figureText(m.tolerancePx); }},
        {"error at ROAM's triangles, px", [](const MethodFigures& m)
         { return orNone(m.ceiling ? std::optional(m.ceiling->trueErrorPx) : std::nullopt); }},
        {"adaptation, µs", [](const MethodFigures& m) { return orNone(adaptation(m, m.adaptUsP50)); }},
        {"99 %", [](const MethodFigures& m) { return orNone(adaptation(m, m.adaptUsP99)); }},
        {"worst", [](const MethodFigures& m) { return orNone(adaptation(m, m.adaptUsMax)); }},
        {"changed, %", [](const MethodFigures& m) { return figureText(m.changedPercent); }},
        {"pop, px", [](const MethodFigures& m) { return figureText(m.popPx); }},
        {"transforms a triangle", [](const MethodFigures& m) { return orNone(m.transformsPerTriangle); }},
        {"memory, MB", [](const MethodFigures& m) { return figureText(m.memoryMB); }},
        {"preparation, s", [](const MethodFigures& m) { return figureText(m.preparationS); }},
        {"parts", [](const MethodFigures& m) { return figureText(m.parts); }},
        {"picture, ms", [](const MethodFigures& m) { return orNone(m.frameMs); }}};
    return all;
}

const std::vector<FigureColumn>& furtherFigureColumns()
{
    static const std::vector<FigureColumn> all{
        {"strip of the dual graph, triangles",
         [](const MethodFigures& m) { return orNone(m.dualStripLength); }},
        {"strip of slots, triangles", [](const MethodFigures& m) { return orNone(m.stripLength); }},
        {"left by culling, %", [](const MethodFigures& m) { return orNone(m.visiblePercent); }},
        {"normals turned, %", [](const MethodFigures& m) { return figureText(m.lightPercent); }},
        {"largest turn, °", [](const MethodFigures& m) { return figureText(m.lightDeg); }},
        {"right and isosceles, %", [](const MethodFigures& m) { return figureText(m.regularPercent); }},
        {"an edit, µs", [](const MethodFigures& m) { return orNone(m.editUs); }},
        {"morphing, µs",
         [](const MethodFigures& m) { return orNone(m.morph ? std::optional(m.morph->us) : std::nullopt); }},
        {"the same without, µs", [](const MethodFigures& m)
         { return orNone(m.morph ? std::optional(m.morph->plainUs) : std::nullopt); }},
        {"a frame, µs",
         [](const MethodFigures& m) { return orNone(m.fit ? std::optional(m.fit->baseUs) : std::nullopt); }},
        {"+ a triangle, ns", [](const MethodFigures& m)
         { return orNone(m.fit ? std::optional(m.fit->nsPerTriangle) : std::nullopt); }},
        {"+ a change, ns", [](const MethodFigures& m)
         { return orNone(m.fit ? std::optional(m.fit->nsPerChange) : std::nullopt); }}};
    return all;
}

} // namespace terraintool
