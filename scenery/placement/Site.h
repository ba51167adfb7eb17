// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "scenery/models/Dice.h"
#include "scenery/placement/Lines.h"
#include "scenery/placement/PlaceScenery.h"
#include "scenery/placement/TakenDiscs.h"

namespace scenery
{

/// The terrain while it is filled field by field.
class Site
{
public:
    Site(const SceneryDescription& description, std::span<const Measures> measures, const Ground& ground,
         const Ways& ways);

    /// Begins the field with this index in the description.
    void begin(std::uint32_t number);
    const SceneryField& field() const { return *_field; }
    models::Dice& dice() { return _dice; }
    std::uint32_t placed() const { return _placed; }

    /// The smallest axis-aligned rectangle that contains the area of the field. area(): in m².
    struct Box
    {
        glm::dvec2 low{0.0}, high{0.0};
        double area() const { return (high.x - low.x) * (high.y - low.y); }
    };
    const Box& box() const { return _box; }
    glm::dvec2 anyPlace();
    bool isInArea(glm::dvec2 place) const;
    std::optional<double> heightM(glm::dvec2 place) const { return _ground.heightM(place); }

    /// Draws a random object of the field, and a random scale.
    std::uint32_t anyObject();
    double anyScale() { return _dice.between(_field->leastScale, _field->mostScale); }
    const Measures& measures(std::uint32_t object) const { return _measures[object]; }

    /// Puts an object at a point if all rules hold. Returns whether they do.
    bool put(std::uint32_t object, glm::dvec2 place, double headingRad, double scale);

    /// Adds a street, which stays free of objects.
    void addStreet(const Corridor& street);
    const std::vector<std::pair<std::uint32_t, Corridor>>& streets() const { return _streets; } ///< by field
    const std::string& fieldName(std::uint32_t number) const { return _description.fields[number].name; }
    bool isClear(glm::dvec2 place, double roomM) const { return _clear.distanceM(place) >= roomM; }

    std::vector<Placement> placements;

private:
    bool suits(glm::dvec2 place, double heightM, double slopeDeg) const;

    const SceneryDescription& _description;
    std::span<const Measures> _measures;
    const Ground& _ground;
    std::vector<SceneryObject> _objects;
    Lines _clear, _paths;
    std::vector<std::vector<glm::dvec2>> _pathLines;
    TakenDiscs _taken;
    std::vector<std::pair<std::uint32_t, Corridor>> _streets;
    const SceneryField* _field = nullptr;
    std::uint32_t _number = 0, _placed = 0;
    models::Dice _dice{0};
    Box _box;
    std::vector<std::uint32_t> _fieldObjects; ///< of _objects
};

} // namespace scenery
