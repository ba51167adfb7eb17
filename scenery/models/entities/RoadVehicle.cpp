// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/entities/EntityGenerators.h"
#include "scenery/models/entities/LookOf.h"
#include "scenery/models/entities/RollingParts.h"
#include "scenery/models/vehicles/Vehicle.h"

namespace scenery::models
{

namespace
{

/// Returns x of the foremost (or hindmost) cross-section that contains (y, z); 0 where none does.
double surfaceX(const VehicleForm& form, const glm::dvec2& at, bool isAhead)
{
    constexpr int kSteps = 400;
    for (int i = 0; i < kSteps / 2; ++i)
    {
        const double x = (isAhead ? 1.0 : -1.0) * form.lengthM * (0.5 - static_cast<double>(i) / kSteps);
        if (form.half(x) >= at.x && form.top(x) >= at.y && form.bottom(x) <= at.y) return x;
    }
    return 0.0;
}

class LampBuilder
{
public:
    LampBuilder(const StretchedForm& body, double middleXM, EntityModel& model)
        : _body(body), _middleXM(middleXM), _model(model)
    {
    }

    /// Adds a lamp on both sides. `at`: y and z in the form's frame.
    void pair(EntityLamp::Kind left, EntityLamp::Kind right, const glm::dvec2& at, const glm::dvec2& size,
              bool looksAhead)
    {
        constexpr int kStrips = 4;
        const std::size_t before = _model.lamps.size();
        for (int i = 0; i < kStrips; ++i)
        {
            const double inner = std::max(at.x + size.x * (static_cast<double>(i) / kStrips - 0.5), 0.0);
            const double outer = at.x + size.x * (static_cast<double>(i + 1) / kStrips - 0.5);
            strip(left, right, {inner, outer}, {at.y, size.y}, looksAhead);
        }
        if (_model.lamps.size() > before) return; // else all of it is beside the body: it is moved onto it
        double inner = std::max(at.x - 0.5 * size.x, 0.0);
        while (inner > 0.0 && surfaceX(_body.form, {inner, at.y}, looksAhead) == 0.0)
            inner -= 0.01; // to where there is a body
        inner = std::max(inner - size.x, 0.0);
        strip(left, right, {inner, inner + size.x}, {at.y, size.y}, looksAhead, true);
    }

private:
    /// Adds a narrow part of a lamp on both sides, which lies on the body. `across`: y of its ends; `up`: z
    /// of its middle and its height; in the form's frame. Nothing where the body has ended or turned to its
    /// side, unless it is flat.
    void strip(EntityLamp::Kind left, EntityLamp::Kind right, const glm::dvec2& across, const glm::dvec2& up,
               bool looksAhead, bool isFlat = false)
    {
        constexpr double kAheadM = 0.012, kSteepest = 4.0;
        const double ahead = looksAhead ? 1.0 : -1.0;
        const double end = ahead * surfaceX(_body.form, {across.x, up.x}, looksAhead);
        const double at[2] = {end, isFlat ? end : ahead * surfaceX(_body.form, {across.y, up.x}, looksAhead)};
        if (end == 0.0 || at[0] - at[1] > kSteepest * (across.y - across.x)) return;
        const double middleX =
            ahead * (0.5 * (at[0] + at[1]) * _body.stretch.x + (isFlat ? 1.5 : 1.0) * kAheadM) + _middleXM;
        const double sweep = ahead * (at[1] - at[0]) * _body.stretch.x; // of the outer end against the inner
        const double middleY = 0.5 * (across.x + across.y) * _body.stretch.y;
        for (const double side : {1.0, -1.0})
            _model.lamps.push_back({side > 0.0 ? left : right,
                                    {middleX, side * middleY, up.x * _body.stretch.z},
                                    looksAhead,
                                    (across.y - across.x) * _body.stretch.y,
                                    up.y * _body.stretch.z,
                                    side * sweep});
    }

    const StretchedForm& _body;
    double _middleXM;
    EntityModel& _model;
};

void addLamps(EntityModel& model, const StretchedForm& body, const VehicleLook& look, double middleXM)
{
    using Lamp = EntityLamp::Kind;
    const LookLamp &head = look.headLamps, &tail = look.tailLamps;
    LampBuilder lamps(body, middleXM, model);
    const auto beside = [](const glm::dvec2& at, const glm::dvec2& size, double share)
    { return at + glm::dvec2(share * size.x, 0.0); };
    lamps.pair(Lamp::head, Lamp::head, head.at, head.sizeM, true);
    lamps.pair(Lamp::indicatorLeft, Lamp::indicatorRight, beside(head.at, head.sizeM, 0.65),
               head.sizeM * glm::dvec2(0.3, 0.8), true);
    lamps.pair(Lamp::tail, Lamp::tail, tail.at - glm::dvec2(0.0, 0.25 * tail.sizeM.y),
               tail.sizeM * glm::dvec2(1.0, 0.4), false);
    lamps.pair(Lamp::brake, Lamp::brake, tail.at + glm::dvec2(0.0, 0.25 * tail.sizeM.y),
               tail.sizeM * glm::dvec2(1.0, 0.45), false);
    lamps.pair(Lamp::indicatorLeft, Lamp::indicatorRight, beside(tail.at, tail.sizeM, 0.55),
               tail.sizeM * glm::dvec2(0.35, 0.8), false);
    lamps.pair(Lamp::reversing, Lamp::reversing, beside(tail.at, tail.sizeM, -0.7),
               tail.sizeM * glm::dvec2(0.4, 0.4), false);
}

/// Returns the form with its axles and wheels where the shape has them.
VehicleForm formFor(const EntityShape& shape, const VehicleLook& look, const glm::dvec3& stretch)
{
    VehicleForm form = look.form;
    if (shape.axles.size() < 2) return form;
    const auto inForm = [&](double x) { return (x - shape.middleXM) / stretch.x; };
    const double reach = 0.5 * form.lengthM - 1.4 * form.archRadiusM;
    form.axles = {std::clamp(inForm(shape.axles.front().xM), 0.0, reach),
                  std::clamp(inForm(shape.axles.back().xM), -reach, 0.0)};
    const double radius = shape.axles.front().wheelRadiusM / stretch.z;
    form.archRadiusM = radius * form.archRadiusM / form.wheelRadiusM;
    form.wheelRadiusM = radius;
    return form;
}

} // namespace

EntityModel makeRoadVehicle(const EntityShape& shape)
{
    const std::shared_ptr<const VehicleLook> look = lookOf(shape);
    const VehicleForm& usual = look->form;
    const glm::dvec3 stretch(shape.lengthM / usual.lengthM, shape.widthM / usual.widthM,
                             shape.heightM / usual.heightM);
    const VehicleForm form = formFor(shape, *look, stretch);
    const StretchedForm body{form, stretch};
    ModelBuilder builder;
    addVehicleShell(builder, look, body, {shape.red, shape.green, shape.blue});
    EntityModel model;
    model.parts = {model.addMesh(builder.finish(38.0))};
    addWheels(model, shape, glm::translate(glm::dmat4(1.0), {shape.middleXM, 0.0, 0.0}), form.wheelWidthM);
    addLamps(model, body, *look, shape.middleXM);
    const LookEye& eye = look->eye;
    model.eye = {shape.backXM() + (eye.alongShare * shape.lengthM + eye.alongM), eye.leftShare * shape.widthM,
                 eye.upShare * shape.heightM + eye.upM};
    return model;
}

} // namespace scenery::models
