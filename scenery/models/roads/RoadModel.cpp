// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/roads/RoadModel.h"

#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

using RoadModelKind = RoadModel::Kind;

void addGreyBox(ModelBuilder& builder, const RoadModel& model)
{
    const double length = orElse(model.lengthM, 0.5), width = orElse(model.widthM, 0.5),
                 height = orElse(model.heightM, 1.0);
    builder.begin("box", kPlain, {0.6F, 0.6F, 0.6F});
    box(builder, {-0.5 * length, -0.5 * width, -model.postDepthM}, {0.5 * length, 0.5 * width, height});
}

} // namespace

Model makeRoadModel(const RoadModel& model)
{
    ModelBuilder builder;
    switch (model.kind)
    {
    case RoadModelKind::sign:
        addSign(builder, model);
        break;
    case RoadModelKind::board:
        addBoard(builder, model);
        break;
    case RoadModelKind::trafficLight:
    case RoadModelKind::pedestrianLight:
        addLights(builder, model);
        break;
    case RoadModelKind::pole:
        builder.begin("post", kPlain, kZinc);
        bar(builder, {0.0, 0.0, -kPostDepthM}, {0.0, 0.0, orElse(model.heightM, 3.0)},
            orElse(0.5 * model.widthM, kPostRadiusM));
        break;
    case RoadModelKind::delineator:
        addDelineator(builder, model);
        break;
    case RoadModelKind::lampPost:
        addLampPost(builder, model);
        break;
    case RoadModelKind::cone:
        addCone(builder, model);
        break;
    case RoadModelKind::bollard:
        addBollard(builder, model);
        break;
    case RoadModelKind::railPost:
        addRailPost(builder, model);
        break;
    case RoadModelKind::gantry:
        addGantry(builder, model);
        break;
    case RoadModelKind::runwaySign:
        addRunwaySign(builder, model);
        break;
    case RoadModelKind::box:
        addGreyBox(builder, model);
        break;
    }
    return builder.finish();
}

} // namespace scenery::models
