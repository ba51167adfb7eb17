// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <memory>
#include <vector>

namespace scenery::models
{

struct VehicleLook;

/// What a moving entity looks like.
enum class EntityKind
{
    car,
    van,
    bus,
    lorry,
    tractor, ///< of a semitrailer
    semitrailer,
    trailer,
    motorbike,
    bicycle,
    pedestrian,
    wheelchair,
    horse,
    cow,
    sheep,
    deer, ///< with antlers where it is as high as a moose
    dog,
    lightAircraft,
    glider,
    airliner,
    helicopter,
    ship,
    cone,
    barrier,
    pole,
    box, ///< of no known kind
};

inline bool isAnimal(EntityKind kind)
{
    return kind >= EntityKind::horse && kind <= EntityKind::dog;
}

inline bool isAircraft(EntityKind kind)
{
    return kind >= EntityKind::lightAircraft && kind <= EntityKind::helicopter;
}

/// The bodies of cars.
enum class CarBody
{
    saloon,
    hatchback,
    estate,
    suv,
};

/// An axle with its two wheels. Units: metres.
struct AxleShape
{
    double xM = 0.0, trackM = 0.0, wheelRadiusM = 0.0;
    bool steers = false;

    auto operator<=>(const AxleShape&) const = default;
};

/// The size of an entity; equal shapes share one model.
/// Frame: the entity's, as in OpenSCENARIO: x forward, y left, z up, origin on the ground below the rear
/// axle.
/// Units: metres; colours as display values.
struct EntityShape
{
    EntityKind kind = EntityKind::box;
    double lengthM = 1.0, widthM = 1.0, heightM = 1.0;
    double middleXM = 0.0;        ///< of the box; z runs from 0 to heightM
    std::vector<AxleShape> axles; ///< from the front; may be empty
    float red = 0.7F, green = 0.7F, blue = 0.7F;
    CarBody body = CarBody::saloon;            ///< of a car
    std::shared_ptr<const VehicleLook> look{}; ///< that of a car, van or bus; null: by its kind and body

    auto operator<=>(const EntityShape&) const = default;
    double frontXM() const { return middleXM + 0.5 * lengthM; }
    double backXM() const { return middleXM - 0.5 * lengthM; }
};

} // namespace scenery::models
