// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/ReadSelection.h"

#include <array>
#include <functional>

namespace scenery
{

namespace
{

using namespace osgPMObjects::core;

constexpr double kFar = 1e9, kMostPx = 1e9;
constexpr std::array kMethods{"ranges",      "overlapping-ranges", "box-area",
                              "sphere-area", "ellipsoid-area",     "facing-area",
                              "continuous",  "screen-error",       "budget"};
static_assert(kMethods.size() == kSelectionMethods);
constexpr std::array kSwitches{"discrete", "blend", "alpha", "continuous", "geomorph"};
constexpr std::array kProfiles{"cross", "over"};

void readAlpha(JsonFields& parent, AlphaRange& alpha)
{
    const nlohmann::json* const found = parent.find("alpha");
    if (!found) return;
    JsonFields fields(*found, parent.at("alpha"), parent.complaint());
    fields.number("fadeM", alpha.fadeM, 0.0, kFar);
    if (!fields.number("goneM", alpha.goneM, 1e-3, kFar) || !(alpha.fadeM <= alpha.goneM))
        fields.complaint().say(fields.at("goneM"), "is missing, or less than fadeM",
                               "give the distance from which on nothing is drawn");
}

void readWeights(JsonFields& parent, AttributeWeights& weights)
{
    const nlohmann::json* const found = parent.find("weights");
    if (!found) return;
    JsonFields fields(*found, parent.at("weights"), parent.complaint());
    const auto read = [&](const char* name, float& value)
    {
        double number = value;
        fields.number(name, number, 0.0, 1e6);
        value = static_cast<float>(number);
    };
    read("normal", weights.normal);
    read("texCoord", weights.texCoord);
    read("colour", weights.colour);
}

void checkOrder(JsonFields& fields, const char* name, const std::vector<double>& values, bool isDescending)
{
    const auto wrong = isDescending
                           ? std::adjacent_find(values.begin(), values.end(), std::less_equal<>())
                           : std::adjacent_find(values.begin(), values.end(), std::greater_equal<>());
    if (wrong != values.end())
        fields.complaint().say(fields.at(name), isDescending ? "does not fall" : "does not rise",
                               "sort the numbers, each once");
}

} // namespace

void readSelection(JsonFields& parent, SelectionPlan& plan)
{
    const nlohmann::json* const found = parent.find("selection");
    if (!found) return;
    JsonFields fields(*found, parent.at("selection"), parent.complaint());
    SelectionSettings& settings = plan.settings;
    fields.choice("method", settings.method, kMethods);
    if (fields.numbers("boundariesM", plan.boundariesM, 1e-3, kFar))
        checkOrder(fields, "boundariesM", plan.boundariesM, false);
    if (fields.numbers("leastPx", plan.leastPx, 1e-6, kMostPx))
        checkOrder(fields, "leastPx", plan.leastPx, true);
    if (fields.numbers("facesPercent", plan.facesPercent, 1e-6, 100.0))
        checkOrder(fields, "facesPercent", plan.facesPercent, true);
    fields.number("overlap", plan.overlap, 1.000001, 100.0);
    fields.number("referenceM", settings.referenceM, 0.0, kFar);
    fields.number("trianglePx", settings.trianglePx, 1e-3, 1e6);
    fields.number("tolerancePx", settings.tolerancePx, 1e-3, 1e6);
    fields.whole("leastFaces", settings.leastFaces, 0.0, 1e9);
    fields.number("band", settings.band, 1.0, 100.0);
    fields.number("continuousBand", settings.continuousBand, 1.0, 100.0);
    readWeights(fields, settings.weights);
    readAlpha(fields, settings.alpha);
    const bool isRanges =
        settings.method == SelectionMethod::ranges || settings.method == SelectionMethod::overlappingRanges;
    const std::size_t boundaries = isRanges ? plan.boundariesM.size() : plan.leastPx.size();
    if ((isRanges || boundaries > 0) && plan.facesPercent.size() != boundaries + 1)
        fields.complaint().say(fields.at("facesPercent"), "has not one number more than there are boundaries",
                               "give a share of the faces for each level, the finest first");
}

void readSwitching(JsonFields& parent, SwitchSettings& switching)
{
    const nlohmann::json* const found = parent.find("switching");
    if (!found) return;
    JsonFields fields(*found, parent.at("switching"), parent.complaint());
    fields.choice("method", switching.method, kSwitches);
    fields.choice("profile", switching.profile, kProfiles);
    double duration = switching.durationS, stagger = switching.staggerS;
    fields.number("durationS", duration, 1e-3, 60.0);
    fields.number("staggerS", stagger, 0.0, 60.0);
    switching.durationS = static_cast<float>(duration);
    switching.staggerS = static_cast<float>(stagger);
}

void readBudget(JsonFields& parent, SceneBudgetSettings& budget)
{
    const nlohmann::json* const found = parent.find("budget");
    if (!found) return;
    JsonFields fields(*found, parent.at("budget"), parent.complaint());
    double triangles = 0.0, ms = 0.0;
    const bool byTriangles = fields.number("triangles", triangles, 1.0, 1e12);
    const bool byTime = fields.number("ms", ms, 1e-3, 1e4);
    // Nanoseconds that a machine takes. The defaults are an estimate: whoever wants milliseconds has to
    // measure.
    double perTriangle = 100.0, perVertex = 30.0, perObject = 500.0;
    fields.number("nsPerTriangle", perTriangle, 0.0, 1e9);
    fields.number("nsPerVertex", perVertex, 0.0, 1e9);
    fields.number("nsPerObject", perObject, 0.0, 1e9);
    fields.number("band", budget.band, 1.0, 100.0);
    if (byTriangles == byTime)
        fields.complaint().say(fields.at("triangles"), "either triangles or ms has to be there", "give one");
    if (byTime) budget.cost = {perTriangle, perVertex, perObject};
    budget.budget = static_cast<std::uint64_t>(byTime ? ms * 1e6 : triangles);
}

} // namespace scenery
