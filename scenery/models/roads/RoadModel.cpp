// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/RoadModel.h"

#include <algorithm>

#include "scenery/models/roads/Plate.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

using Kind = RoadModel::Kind;

constexpr glm::vec3 kHousing(0.09F, 0.10F, 0.10F);
constexpr double kLensStepM = 0.28; ///< from lens to lens
constexpr double kHeadDepthM = 0.22, kLightPostM = 0.06;
constexpr double kLensX = -kHeadDepthM - kLightPostM; ///< the front of the head; its back touches the post

/// The radius of the post and the arm behind a plate.
double postRadiusOf(const RoadModel& model)
{
    return model.armM == 0.0 ? kPostRadiusM : 2.0 * kPostRadiusM;
}

/// Adds the post at x = 0, beside the road with an arm where the model has one.
void post(ModelBuilder& builder, const RoadModel& model, double topM, double thick)
{
    if (model.postDepthM <= 0.0) return;
    const double aside = -model.armM;
    builder.begin("post", kRoadSigns, kZinc);
    bar(builder, {0.0, aside, -model.postDepthM}, {0.0, aside, topM}, thick);
    if (model.armM == 0.0) return;
    builder.begin("arm", kRoadSigns, kZinc);
    bar(builder, {0.0, aside, topM - 0.2}, {0.0, 0.0, topM - 0.1}, 0.8 * thick);
}

void addSign(ModelBuilder& builder, const RoadModel& model)
{
    Plate plate;
    plate.widthM = orElse(model.widthM, 0.6);
    plate.heightM = orElse(model.heightM, plate.widthM);
    plate.middle.x = -postRadiusOf(model) - plate.thicknessM;
    plate.middle.z = model.raisedM + 0.5 * plate.heightM;
    plate.shape = model.shape;
    plate.front =
        model.number > 0 ? cellOfLimit(model.number, model.face == SignFace::least) : cellOf(model.face);
    plate.back = model.isTwoSided ? plate.front : cellOf(SignFace::back);
    builder.begin("plate", kRoadSigns);
    addPlate(builder, plate);
    post(builder, model, model.raisedM + 0.9 * plate.heightM, postRadiusOf(model));
}

/// Adds a board: its face is a row of letters in a frame of plain cells, so nothing lies in front of anything.
void addBoard(ModelBuilder& builder, const RoadModel& model)
{
    const double height = orElse(model.heightM, 0.6);
    const double letter =
        std::min(0.6 * height, 0.9 * orElse(model.widthM, 1e3) /
                                   std::max<double>(1.0, static_cast<double>(model.text.size())));
    const double width =
        std::max(orElse(model.widthM, 0.0), letter * static_cast<double>(model.text.size()) + 0.2);
    const double back = -postRadiusOf(model), low = model.raisedM,
                 textWidth = letter * static_cast<double>(model.text.size());
    builder.begin("plate", kRoadSigns, {0.98F, 0.82F, 0.10F});
    box(builder, {back - 0.03, -0.5 * width, low}, {back, 0.5 * width, low + height});
    builder.begin("letters", kRoadSigns, {0.98F, 0.82F, 0.10F});
    for (std::size_t i = 0; i < model.text.size(); ++i)
    {
        const SignCell cell = cellOfGlyph(model.text[i]);
        const double left = 0.5 * textWidth - letter * static_cast<double>(i), middle = low + 0.5 * height;
        addBox(builder, {{back - 0.05, left - letter, middle - 0.5 * letter},
                         {back - 0.03, left, middle + 0.5 * letter},
                         {cell.high.x, cell.low.y},
                         {cell.low.x, cell.high.y},
                         1.0F});
    }
    post(builder, model, low + height, postRadiusOf(model));
}

void addLights(ModelBuilder& builder, const RoadModel& model)
{
    const std::vector<Lens> lenses = lensesOf(model);
    const double top = lenses.front().middle.z + 0.5 * kLensStepM,
                 low = lenses.back().middle.z - 0.5 * kLensStepM;
    builder.begin("housing", kRoadSigns, kHousing);
    box(builder, {kLensX, -0.15, low}, {kLensX + kHeadDepthM, 0.15, top});
    builder.begin("lenses", kRoadSigns);
    for (const Lens& lens : lenses)
        addPlate(builder, {lens.middle, 2.0 * lens.radiusM, 2.0 * lens.radiusM, 0.015,
                           RoadModel::Shape::round, cellOf(lens.face), cellOf(SignFace::back)});
    builder.begin("visors", kRoadSigns, kHousing);
    for (const Lens& lens : lenses)
        box(builder, lens.middle + glm::dvec3(-0.18, -lens.radiusM, lens.radiusM),
            lens.middle + glm::dvec3(0.015, lens.radiusM, lens.radiusM + 0.012));
    post(builder, model, top, kLightPostM);
}

void addGreyBox(ModelBuilder& builder, const RoadModel& model)
{
    const double length = orElse(model.lengthM, 0.5), width = orElse(model.widthM, 0.5),
                 height = orElse(model.heightM, 1.0);
    builder.begin("box", kRoadSigns, {0.6F, 0.6F, 0.6F});
    box(builder, {-0.5 * length, -0.5 * width, -model.postDepthM}, {0.5 * length, 0.5 * width, height});
}

} // namespace

std::vector<Lens> lensesOf(const RoadModel& model)
{
    std::vector<SignFace> faces;
    if (model.kind == Kind::trafficLight)
        faces = {SignFace::lampRed, SignFace::lampAmber, SignFace::lampGreen};
    if (model.kind == Kind::pedestrianLight) faces = {SignFace::lampRed, SignFace::lampGreen};
    std::vector<Lens> lenses;
    for (std::size_t i = 0; i < faces.size(); ++i)
        lenses.push_back({{kLensX - 0.015, 0.0,
                           model.raisedM + kLensStepM * (static_cast<double>(faces.size() - i) - 0.5)},
                          0.105,
                          faces[i]});
    return lenses;
}

Model makeRoadModel(const RoadModel& model)
{
    ModelBuilder builder;
    switch (model.kind)
    {
    case Kind::sign:
        addSign(builder, model);
        break;
    case Kind::board:
        addBoard(builder, model);
        break;
    case Kind::trafficLight:
    case Kind::pedestrianLight:
        addLights(builder, model);
        break;
    case Kind::pole:
        builder.begin("post", kRoadSigns, kZinc);
        bar(builder, {0.0, 0.0, -kPostDepthM}, {0.0, 0.0, orElse(model.heightM, 3.0)},
            orElse(0.5 * model.widthM, kPostRadiusM));
        break;
    case Kind::delineator:
        addDelineator(builder, model);
        break;
    case Kind::lampPost:
        addLampPost(builder, model);
        break;
    case Kind::cone:
        addCone(builder, model);
        break;
    case Kind::bollard:
        addBollard(builder, model);
        break;
    case Kind::railPost:
        addRailPost(builder, model);
        break;
    case Kind::gantry:
        addGantry(builder, model);
        break;
    case Kind::box:
        addGreyBox(builder, model);
        break;
    }
    return builder.finish();
}

} // namespace scenery::models
