// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/methods/CompareJson.h"

#include "compare/terrain/methods/Verdicts.h"

namespace terraintool
{

namespace
{

nlohmann::ordered_json jsonOf(const std::optional<double>& figure)
{
    return figure ? nlohmann::ordered_json(*figure) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json jsonOf(const MethodFigures& m)
{
    nlohmann::ordered_json row;
    row["name"] = m.name;
    row["triangles"] = m.triangles;
    row["trueErrorPx"] = m.trueErrorPx;
    row["adaptUsP50"] = m.adapts ? nlohmann::ordered_json(m.adaptUsP50) : nullptr;
    row["adaptUsP99"] = m.adapts ? nlohmann::ordered_json(m.adaptUsP99) : nullptr;
    row["adaptUsMax"] = m.adapts ? nlohmann::ordered_json(m.adaptUsMax) : nullptr;
    row["changedPercent"] = m.changedPercent;
    row["popPx"] = m.popPx;
    row["transformsPerTriangle"] = jsonOf(m.transformsPerTriangle);
    row["memoryMB"] = m.memoryMB;
    row["preparationS"] = m.preparationS;
    row["parts"] = m.parts;
    row["frameMs"] = jsonOf(m.frameMs);
    row["stripLength"] = jsonOf(m.stripLength);
    row["dualStripLength"] = jsonOf(m.dualStripLength);
    row["lightPercent"] = m.lightPercent;
    row["lightDeg"] = m.lightDeg;
    row["regularPercent"] = m.regularPercent;
    row["visiblePercent"] = jsonOf(m.visiblePercent);
    row["editUs"] = jsonOf(m.editUs);
    row["morph"] = nullptr;
    if (m.morph)
        row["morph"] = {{"us", m.morph->us},
                        {"plainUs", m.morph->plainUs},
                        {"verticesWritten", m.morph->vertices},
                        {"plainVerticesWritten", m.morph->plain}};
    row["fit"] = nullptr;
    if (m.fit)
        row["fit"] = {{"baseUs", m.fit->baseUs},
                      {"nsPerTriangle", m.fit->nsPerTriangle},
                      {"nsPerChange", m.fit->nsPerChange},
                      {"sizePercent", m.fit->sizePercent},
                      {"changePercent", m.fit->changePercent}};
    return row;
}

nlohmann::ordered_json jsonOf(const DemComparison& dem)
{
    nlohmann::ordered_json json;
    json["dem"] = dem.dem;
    json["methods"] = nlohmann::ordered_json::array();
    json["requirements"] = nlohmann::ordered_json::array();
    for (const MethodFigures& m : dem.methods)
        json["methods"].push_back(jsonOf(m));
    for (const RequirementVerdict& v : requirementVerdicts(dem))
        json["requirements"].push_back({{"requirement", v.requirement},
                                        {"method", v.method},
                                        {"verdict", v.verdict},
                                        {"figure", v.figure}});
    json["reworks"] = nlohmann::ordered_json::array();
    for (const ReworkFigures& r : dem.reworks)
        json["reworks"].push_back({{"path", r.path},
                                   {"way", r.way},
                                   {"adaptUsP50", r.adaptUsP50},
                                   {"adaptUsMax", r.adaptUsMax},
                                   {"changedTriangles", r.changedTriangles}});
    return json;
}

} // namespace

nlohmann::ordered_json comparisonJson(const std::vector<DemComparison>& dems)
{
    nlohmann::ordered_json json;
    json["dems"] = nlohmann::ordered_json::array();
    json["claims"] = nlohmann::ordered_json::array();
    for (const DemComparison& dem : dems)
        json["dems"].push_back(jsonOf(dem));
    for (const ClaimVerdict& v : claimVerdicts(dems))
        json["claims"].push_back({{"claim", v.claim}, {"verdict", v.verdict}, {"figure", v.figure}});
    json["qualities"] = nlohmann::ordered_json::array();
    for (const QualityVerdict& v : qualityVerdicts(dems))
        json["qualities"].push_back({{"section", v.section},
                                     {"method", v.method},
                                     {"kind", v.kind},
                                     {"quality", v.quality},
                                     {"verdict", v.verdict},
                                     {"figure", v.figure}});
    return json;
}

} // namespace terraintool
