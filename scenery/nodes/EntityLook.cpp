// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/EntityLook.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <foundation/SmallLetters.h>

#include "scenery/models/entities/DefaultSize.h"
#include "scenery/models/entities/StandingAircraft.h"

namespace scenery
{

namespace
{

using models::EntityKind;
using models::EntityShape;

struct Colour
{
    float red, green, blue;
};

/// The words that can tell what an object is, in lower case.
std::string wordsOf(const simulation::ScenarioObject& object, const models::VehicleLook* vehicle)
{
    // Of a look its name, not its path: the folder "redwood" makes no car red.
    std::string words = object.name + ' ' + (vehicle ? vehicle->name : object.model3d());
    std::visit(
        [&](const auto& content)
        {
            if constexpr (requires { content.category; }) words += ' ' + content.name;
        },
        object.object);
    return foundation::inSmallLetters(words);
}

bool hasAny(const std::string& words, std::initializer_list<std::string_view> searched)
{
    return std::any_of(searched.begin(), searched.end(),
                       [&](std::string_view word) { return words.find(word) != std::string::npos; });
}

/// FNV-1a.
std::uint32_t hashOf(const std::string& name)
{
    std::uint32_t hash = 2166136261U;
    for (const char c : name)
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash;
}

/// The kind of something that flies.
EntityKind flyingKind(const simulation::ScenarioObject& object, const std::string& words)
{
    constexpr double kAirlinerFromM = 20.0;
    const auto* vehicle = std::get_if<simulation::Vehicle>(&object.object);
    if ((vehicle && vehicle->category == "helicopter") ||
        hasAny(words, {"helicopter", "heli_", "rotorcraft"}))
        return EntityKind::helicopter;
    if (hasAny(words, {"glider", "sailplane", "soar"})) return EntityKind::glider;
    const bool isLarge = object.box().lengthM > kAirlinerFromM;
    return isLarge || hasAny(words, {"airliner", "airbus", "boeing", "a320", "b737", "jet"})
               ? EntityKind::airliner
               : EntityKind::lightAircraft;
}

EntityKind animalKind(const std::string& words)
{
    if (hasAny(words, {"dog", "wolf", "fox"})) return EntityKind::dog;
    if (hasAny(words, {"cow", "cattle", "bull", "calf"})) return EntityKind::cow;
    if (hasAny(words, {"sheep", "lamb", "goat"})) return EntityKind::sheep;
    if (hasAny(words, {"horse", "pony", "donkey"})) return EntityKind::horse;
    return EntityKind::deer;
}

EntityKind kindOf(const simulation::Vehicle& vehicle, const std::string& words)
{
    const std::string& category = vehicle.category;
    if (category == "bus" || category == "train" || category == "tram") return EntityKind::bus;
    if (category == "van") return EntityKind::van;
    if (category == "truck" || category == "semitractor")
    {
        if (category == "semitractor" || hasAny(words, {"tractor"})) return EntityKind::tractor;
        return vehicle.box.lengthM < 4.5 && hasAny(words, {"van"}) ? EntityKind::van : EntityKind::lorry;
    }
    if (category == "semitrailer") return EntityKind::semitrailer;
    if (category == "trailer") return hasAny(words, {"semi"}) ? EntityKind::semitrailer : EntityKind::trailer;
    if (category == "motorbike") return EntityKind::motorbike;
    if (category == "bicycle") return EntityKind::bicycle;
    return hasAny(words, {"van"}) && vehicle.box.heightM > 1.9 ? EntityKind::van : EntityKind::car;
}

EntityKind kindOf(const simulation::Pedestrian& pedestrian, const std::string& words)
{
    if (pedestrian.category == "wheelchair") return EntityKind::wheelchair;
    const bool isAnimal = pedestrian.category == "animal" || hasAny(words, {"moose", "deer", "_dog", "dog_"});
    return isAnimal ? animalKind(words) : EntityKind::pedestrian;
}

EntityKind kindOf(const simulation::MiscObject& object, const std::string& words)
{
    if (hasAny(words, {"cone", "pylon"})) return EntityKind::cone;
    if (hasAny(words, {"ship", "boat", "ferry", "vessel", "yacht"})) return EntityKind::ship;
    if (object.category == "barrier" || hasAny(words, {"wall", "barrier"})) return EntityKind::barrier;
    const bool isPole =
        object.category == "pole" || object.category == "streetLamp" || hasAny(words, {"pole"});
    return isPole ? EntityKind::pole : EntityKind::box;
}

EntityKind kindOf(const simulation::Unsupported&, const std::string&)
{
    return EntityKind::box;
}

bool isPaintable(EntityKind kind)
{
    return !models::isAnimal(kind) && kind != EntityKind::box;
}

/// The coat of an animal.
Colour coatOf(EntityKind kind, std::uint32_t hash)
{
    static constexpr std::array<Colour, 4> kBrown{
        {{0.33F, 0.24F, 0.16F}, {0.28F, 0.20F, 0.14F}, {0.40F, 0.29F, 0.19F}, {0.36F, 0.26F, 0.15F}}};
    static constexpr std::array<Colour, 4> kCows{
        {{0.11F, 0.10F, 0.10F}, {0.42F, 0.22F, 0.13F}, {0.50F, 0.33F, 0.20F}, {0.16F, 0.14F, 0.13F}}};
    static constexpr std::array<Colour, 4> kDogs{
        {{0.60F, 0.45F, 0.27F}, {0.13F, 0.12F, 0.12F}, {0.40F, 0.27F, 0.16F}, {0.78F, 0.74F, 0.68F}}};
    static constexpr std::array<Colour, 4> kWool{
        {{0.82F, 0.79F, 0.71F}, {0.76F, 0.73F, 0.66F}, {0.86F, 0.83F, 0.76F}, {0.70F, 0.66F, 0.58F}}};
    const std::size_t pick = hash % 4U;
    if (kind == EntityKind::cow) return kCows[pick];
    if (kind == EntityKind::dog) return kDogs[pick];
    return kind == EntityKind::sheep ? kWool[pick] : kBrown[pick];
}

EntityKind kindOf(const models::VehicleLook& look)
{
    using models::VehicleKind;
    return look.kind == VehicleKind::car   ? EntityKind::car
           : look.kind == VehicleKind::van ? EntityKind::van
                                           : EntityKind::bus;
}

/// A colour by a word of the names, else one of several by a hash of the object's name (FNV-1a).
Colour colourOf(const std::string& words, const std::string& name, const EntityShape& shape)
{
    const EntityKind kind = shape.kind;
    static constexpr std::array<std::pair<std::string_view, Colour>, 12> kNamed{
        {{"white", {0.93F, 0.93F, 0.92F}},
         {"red", {0.72F, 0.09F, 0.08F}},
         {"blue", {0.12F, 0.24F, 0.52F}},
         {"yellow", {0.88F, 0.70F, 0.14F}},
         {"green", {0.16F, 0.38F, 0.24F}},
         {"black", {0.09F, 0.09F, 0.10F}},
         {"silver", {0.70F, 0.72F, 0.74F}},
         {"grey", {0.45F, 0.46F, 0.48F}},
         {"gray", {0.45F, 0.46F, 0.48F}},
         {"orange", {0.85F, 0.40F, 0.08F}},
         {"brown", {0.36F, 0.25F, 0.17F}},
         {"police", {0.93F, 0.93F, 0.94F}}}};
    if (isPaintable(kind))
        for (const auto& [word, colour] : kNamed)
            if (words.find(word) != std::string::npos) return colour;
    if (shape.look)
    {
        const glm::vec3& colour = shape.look->colours[hashOf(name) % shape.look->colours.size()];
        return {colour.r, colour.g, colour.b};
    }
    static constexpr std::array<Colour, 8> kPaints{{{0.72F, 0.10F, 0.09F},
                                                    {0.80F, 0.81F, 0.83F},
                                                    {0.15F, 0.26F, 0.48F},
                                                    {0.42F, 0.44F, 0.47F},
                                                    {0.20F, 0.34F, 0.26F},
                                                    {0.62F, 0.56F, 0.46F},
                                                    {0.93F, 0.93F, 0.92F},
                                                    {0.78F, 0.55F, 0.12F}}};
    static constexpr std::array<Colour, 1> kWood{{{0.58F, 0.44F, 0.28F}}};
    if (kind == EntityKind::box) return kWood[0];
    if (models::isAircraft(kind))
    {
        const glm::vec3 trim = models::aircraftTrim(hashOf(name)); // on white
        return {trim.r, trim.g, trim.b};
    }
    return models::isAnimal(kind) ? coatOf(kind, hashOf(name)) : kPaints[hashOf(name) % kPaints.size()];
}

/// The body of a car: by words, else by its height and length, else by its name.
models::CarBody bodyOf(const EntityShape& shape, const std::string& words, const std::string& name)
{
    using models::CarBody;
    constexpr double kSuvFromM = 1.62, kHatchbackToM = 4.15;
    if (hasAny(words, {"suv", "jeep", "offroad"})) return CarBody::suv;
    if (hasAny(words, {"hatch"})) return CarBody::hatchback;
    if (hasAny(words, {"estate", "wagon", "kombi", "touring"})) return CarBody::estate;
    if (hasAny(words, {"sedan", "saloon", "limousine"})) return CarBody::saloon;
    if (shape.heightM > kSuvFromM) return CarBody::suv;
    if (shape.lengthM < kHatchbackToM) return CarBody::hatchback;
    return (hashOf(name) / 8U) % 3U == 0U ? CarBody::estate : CarBody::saloon;
}

void addAxle(EntityShape& shape, const simulation::Axle& axle)
{
    if (axle.wheelDiameterM > 0.0)
        shape.axles.push_back(
            {axle.positionXM, axle.trackWidthM, 0.5 * axle.wheelDiameterM, axle.maxSteeringRad > 0.0});
}

void takeAxles(EntityShape& shape, const simulation::Vehicle& vehicle)
{
    if (vehicle.frontAxle) addAxle(shape, *vehicle.frontAxle);
    addAxle(shape, vehicle.rearAxle);
    for (const simulation::Axle& axle : vehicle.additionalAxles)
        addAxle(shape, axle);
    for (std::size_t i = 0; i < shape.axles.size();
         ++i) // a maxSteering at the rear is a habit of files, not a steered axle
        shape.axles[i].steers = shape.axles[i].steers && i == 0 && vehicle.frontAxle.has_value();
}

/// Gives a shape the size of its kind, or of its look.
void setUsualSize(EntityShape& shape)
{
    if (!shape.look) return models::setDefaultSize(shape);
    const models::VehicleForm& form = shape.look->form;
    constexpr double kTrackShare = 0.86;
    shape.lengthM = form.lengthM;
    shape.widthM = form.widthM;
    shape.heightM = form.heightM;
    shape.middleXM = -form.axles.y;
    const double track = kTrackShare * form.widthM;
    shape.axles = {{form.axles.x - form.axles.y, track, form.wheelRadiusM, true},
                   {0.0, track, form.wheelRadiusM, false}};
}

std::string metres(double value)
{
    std::string text = std::to_string(value);
    return text.substr(0, text.find('.') + 2);
}

} // namespace

EntityLook entityLook(const simulation::ScenarioObject& object,
                      const std::shared_ptr<const models::VehicleLook>& vehicle)
{
    const std::string words = wordsOf(object, vehicle.get());
    const simulation::BoundingBox& box = object.box();
    EntityLook look;
    EntityShape& shape = look.shape;
    shape.look = vehicle;
    shape.kind = vehicle ? kindOf(*vehicle)
                 : object.isAirborne()
                     ? flyingKind(object, words)
                     : std::visit([&](const auto& content) { return kindOf(content, words); }, object.object);
    shape.lengthM = box.lengthM;
    shape.widthM = box.widthM;
    shape.heightM = box.heightM;
    shape.middleXM = box.centre.x;
    if (const auto* wheeled = std::get_if<simulation::Vehicle>(&object.object)) takeAxles(shape, *wheeled);
    const Colour colour = colourOf(words, object.name, shape);
    shape.red = colour.red;
    shape.green = colour.green;
    shape.blue = colour.blue;
    const bool isFitting = models::isPlausible(shape);
    if (!isFitting) setUsualSize(shape);
    if (shape.kind == EntityKind::car) shape.body = bodyOf(shape, words, object.name);
    // Aircraft have one size for each kind unless the file's is plainly another.
    if (isFitting || models::isAircraft(shape.kind) || box == simulation::BoundingBox{}) return look;
    look.note = object.name + ": a bounding box of " + metres(box.lengthM) + " m by " + metres(box.widthM) +
                " m by " + metres(box.heightM) + " m cannot be that of its category; it is drawn " +
                metres(shape.lengthM) + " m long";
    return look;
}

} // namespace scenery
