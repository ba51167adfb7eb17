// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/RoadModel.h"

#include <algorithm>

#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/Tube.h"
#include "scenery/models/roads/Plate.h"

namespace scenery::models
{

namespace
{

using Kind = RoadModel::Kind;

constexpr glm::vec3 kZinc(0.58F, 0.60F, 0.61F);
constexpr glm::vec3 kHousing(0.09F, 0.10F, 0.10F);
constexpr double kPostRadiusM = 0.038; ///< of a tube of 76 mm
constexpr double kLensStepM = 0.28;    ///< from lens to lens
constexpr double kHeadDepthM = 0.22;

double orElse(double value, double otherwise)
{
    return value > 0.0 ? value : otherwise;
}

glm::vec2 plainUv()
{
    const SignCell cell = cellOf(SignFace::plain);
    return 0.5F * (cell.low + cell.high);
}

void bar(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double radiusM)
{
    addBar(builder, from, to, radiusM, 8, plainUv());
}

void box(ModelBuilder& builder, const glm::dvec3& low, const glm::dvec3& high)
{
    addBox(builder, {low, high, plainUv(), plainUv(), 0.7F});
}

void post(ModelBuilder& builder, const RoadModel& model, double topM, double behindM)
{
    if (model.postDepthM <= 0.0) return;
    builder.begin("post", kRoadSigns, kZinc);
    bar(builder, {behindM, 0.0, -model.postDepthM}, {behindM, 0.0, topM}, kPostRadiusM);
}

void addSign(ModelBuilder& builder, const RoadModel& model)
{
    Plate plate;
    plate.widthM = orElse(model.widthM, 0.6);
    plate.heightM = orElse(model.heightM, plate.widthM);
    plate.middle.z = model.raisedM + 0.5 * plate.heightM;
    plate.shape = model.shape;
    plate.front =
        model.number > 0 ? cellOfLimit(model.number, model.face == SignFace::least) : cellOf(model.face);
    plate.back = model.isTwoSided ? plate.front : cellOf(SignFace::back);
    builder.begin("plate", kRoadSigns);
    addPlate(builder, plate);
    post(builder, model, model.raisedM + 0.9 * plate.heightM, plate.thicknessM + kPostRadiusM);
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
    const double low = model.raisedM, textWidth = letter * static_cast<double>(model.text.size());
    builder.begin("plate", kRoadSigns, {0.98F, 0.82F, 0.10F});
    box(builder, {0.0, -0.5 * width, low}, {0.03, 0.5 * width, low + height});
    builder.begin("letters", kRoadSigns, {0.98F, 0.82F, 0.10F});
    for (std::size_t i = 0; i < model.text.size(); ++i)
    {
        const SignCell cell = cellOfGlyph(model.text[i]);
        const double left = 0.5 * textWidth - letter * static_cast<double>(i), middle = low + 0.5 * height;
        addBox(builder, {{-0.02, left - letter, middle - 0.5 * letter},
                         {0.0, left, middle + 0.5 * letter},
                         {cell.high.x, cell.low.y},
                         {cell.low.x, cell.high.y},
                         1.0F});
    }
    post(builder, model, low + height, 0.03 + kPostRadiusM);
}

void addLights(ModelBuilder& builder, const RoadModel& model)
{
    const std::vector<Lens> lenses = lensesOf(model);
    const double top = lenses.front().middle.z + 0.5 * kLensStepM,
                 low = lenses.back().middle.z - 0.5 * kLensStepM;
    builder.begin("housing", kRoadSigns, kHousing);
    box(builder, {0.0, -0.15, low}, {kHeadDepthM, 0.15, top});
    builder.begin("lenses", kRoadSigns);
    for (const Lens& lens : lenses)
        addPlate(builder, {lens.middle, 2.0 * lens.radiusM, 2.0 * lens.radiusM, 0.015,
                           RoadModel::Shape::round, cellOf(lens.face), cellOf(SignFace::back)});
    builder.begin("visors", kRoadSigns, kHousing);
    for (const Lens& lens : lenses)
        box(builder, lens.middle + glm::dvec3(-0.18, -lens.radiusM, lens.radiusM),
            lens.middle + glm::dvec3(0.015, lens.radiusM, lens.radiusM + 0.012));
    if (model.postDepthM <= 0.0) return;
    builder.begin("post", kRoadSigns, kZinc);
    bar(builder, {kHeadDepthM + 0.06, 0.0, -model.postDepthM}, {kHeadDepthM + 0.06, 0.0, top}, 0.06);
}

void addDelineator(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 1.05);
    builder.begin("post", kRoadSigns, {0.95F, 0.95F, 0.93F});
    box(builder, {-0.06, -0.05, -0.3}, {0.06, 0.05, high - 0.32});
    builder.begin("cap", kRoadSigns, {0.95F, 0.95F, 0.93F});
    box(builder, {-0.06, -0.05, high - 0.08}, {0.06, 0.05, high});
    builder.begin("band", kRoadSigns, {0.07F, 0.07F, 0.08F});
    box(builder, {-0.06, -0.05, high - 0.32}, {0.06, 0.05, high - 0.08});
    builder.begin("reflector", kRoadSigns, {0.98F, 0.98F, 0.98F});
    box(builder, {-0.068, -0.025, high - 0.28}, {-0.06, 0.025, high - 0.12});
}

void addLampPost(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 8.0);
    builder.begin("post", kRoadSigns, kZinc);
    addTube(builder,
            {{{0.0, 0.0, -kPostDepthM}, {0.0, 0.0, high - 0.6}, {0.0, 0.3, high - 0.15}, {0.0, 1.2, high}},
             {0.09, 0.06, 0.05, 0.04},
             8,
             {0.0, 0.0},
             0.0,
             {}});
    builder.begin("luminaire", kRoadSigns, {0.45F, 0.46F, 0.47F});
    box(builder, {-0.14, 1.1, high - 0.06}, {0.14, 1.75, high + 0.06});
}

void addCone(ModelBuilder& builder, const RoadModel& model)
{
    const double high = orElse(model.heightM, 0.75);
    builder.begin("foot", kRoadSigns, {0.12F, 0.12F, 0.12F});
    box(builder, {-0.2, -0.2, 0.0}, {0.2, 0.2, 0.04});
    for (int band = 0; band < 4; ++band)
    {
        const double from = 0.04 + (high - 0.04) * band / 4.0, to = 0.04 + (high - 0.04) * (band + 1) / 4.0;
        const auto radiusAt = [&](double z) { return 0.15 - 0.125 * z / high; };
        builder.begin("band " + std::to_string(band), kRoadSigns,
                      band % 2 == 0 ? glm::vec3(0.92F, 0.28F, 0.05F) : glm::vec3(0.95F, 0.95F, 0.94F));
        addTube(
            builder,
            {{{0.0, 0.0, from}, {0.0, 0.0, to}}, {radiusAt(from), radiusAt(to)}, 12, {0.0, 0.0}, 0.0, {}});
    }
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
        lenses.push_back(
            {{-0.015, 0.0, model.raisedM + kLensStepM * (static_cast<double>(faces.size() - i) - 0.5)},
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
    case Kind::box:
        addGreyBox(builder, model);
        break;
    }
    return builder.finish();
}

} // namespace scenery::models
