// SPDX-License-Identifier: Apache-2.0
#include "terraintool/compare/CompareJson.h"

#include "terraintool/compare/Verdicts.h"

namespace terraintool
{

namespace
{

nlohmann::ordered_json jsonOf(const MethodFigures& m)
{
    nlohmann::ordered_json row;
    row["name"] = m.name;
    row["triangles"] = m.triangles;
    row["trueErrorPx"] = m.trueErrorPx;
    row["adaptUsP50"] = m.adaptUsP50;
    row["adaptUsP99"] = m.adaptUsP99;
    row["adaptUsMax"] = m.adaptUsMax;
    row["changedPercent"] = m.changedPercent;
    row["popPx"] = m.popPx;
    row["transformsPerTriangle"] = nullptr;
    if (m.transformsPerTriangle) row["transformsPerTriangle"] = *m.transformsPerTriangle;
    row["memoryMB"] = m.memoryMB;
    row["preparationS"] = m.preparationS;
    row["frameMs"] = nullptr; // this program does not draw
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
    return json;
}

} // namespace terraintool
