// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/things/ObjectModels.h"

#include <algorithm>
#include <cctype>

namespace scenery::roads
{

namespace
{

using models::RoadModel;
using osgRoads::core::ObjectInstance;

bool isUpper(char c)
{
    return std::isupper(static_cast<unsigned char>(c)) != 0;
}

void addWords(const std::string& text, std::vector<std::string>& words)
{
    std::string word;
    const auto finish = [&]
    {
        if (!word.empty()) words.push_back(word);
        word.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const char c = text[i];
        if (!std::isalpha(static_cast<unsigned char>(c)))
        {
            finish();
            continue;
        }
        if (isUpper(c) && i > 0 && !isUpper(text[i - 1])) finish();
        word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    finish();
}

double widthOf(const ObjectInstance& instance)
{
    return instance.radius > 0.0 ? 2.0 * instance.radius : instance.width;
}

} // namespace

ObjectWords::ObjectWords(const osgRoads::core::RoadObject& object)
{
    addWords(object.type, _words);
    addWords(object.subtype, _words);
    addWords(object.name, _words);
}

bool ObjectWords::any(std::initializer_list<std::string_view> wanted) const
{
    for (const std::string_view one : wanted)
        for (std::size_t i = 0; i < _words.size(); ++i)
            if (_words[i] == one || (i + 1 < _words.size() && _words[i] + _words[i + 1] == one)) return true;
    return false;
}

bool isPlant(const ObjectWords& words)
{
    return words.any({"vegetation", "tree", "trees", "bush", "hedge", "shrub"});
}

StretchForm stretchForm(const ObjectWords& words, double widthM, double heightM)
{
    if (words.any({"jersey", "jerseybarrier", "newjersey"})) return StretchForm::jersey;
    if (words.any({"guardrail", "railing", "rail", "leitplanke"})) return StretchForm::guardRail;
    if (words.any({"fence"})) return StretchForm::fence;
    if (words.any({"curb", "kerb", "curbstone", "kerbstone", "bordstein"})) return StretchForm::kerb;
    if (words.any({"wall", "soundbarrier", "noiseprotection"})) return StretchForm::wall;
    return widthM <= 0.3 && heightM <= 1.2 ? StretchForm::guardRail : StretchForm::wall;
}

std::optional<RoadModel> objectModel(const ObjectWords& words, const ObjectInstance& instance)
{
    RoadModel model;
    model.heightM = instance.height;
    if (words.any({"guide", "delineator", "guidepost", "permanentdelineator"}))
        model.kind = RoadModel::Kind::delineator;
    else if (words.any({"lamp", "streetlamp", "streetlight", "lamppost"}))
        model.kind = RoadModel::Kind::lampPost;
    else if (words.any({"cone", "trafficcone", "pylon"}))
        model.kind = RoadModel::Kind::cone;
    else if (words.any({"bollard"}))
        model.kind = RoadModel::Kind::bollard;
    else if (words.any({"railpole", "railpost", "railingpole"}))
        model.kind = RoadModel::Kind::railPost;
    else if (words.any({"gantry"}))
        model.kind = RoadModel::Kind::gantry;
    else if (words.any({"pole", "post"}))
        model.kind = RoadModel::Kind::pole;
    else
        return {};
    const bool isWideAsTold = model.kind == RoadModel::Kind::pole || model.kind == RoadModel::Kind::bollard ||
                              model.kind == RoadModel::Kind::gantry;
    if (isWideAsTold) model.widthM = widthOf(instance);
    return model;
}

RoadModel boxOf(const ObjectInstance& instance)
{
    RoadModel model;
    model.heightM = instance.height;
    model.lengthM = instance.radius > 0.0 ? 2.0 * instance.radius : instance.length;
    model.widthM = widthOf(instance);
    return model;
}

bool isBoxLike(const ObjectWords& words)
{
    return words.any({"building", "barrier", "obstacle", "trafficisland", "wall", "railing", "soundbarrier",
                      "fence", "curb", "kerb"});
}

} // namespace scenery::roads
