// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <osgRoads/core/query/ObjectInstances.h>

#include "scenery/models/roads/RoadModel.h"

namespace scenery::roads
{

/// The words of an object's type, subtype and name in small letters: "streetLamp" and "guide-post.osgb" give
/// street, lamp, guide, post, osgb.
class ObjectWords
{
public:
    explicit ObjectWords(const osgRoads::core::RoadObject& object);

    /// Whether one of the words is among these, or two that follow each other make one of these
    /// ("guardrail").
    bool any(std::initializer_list<std::string_view> wanted) const;

private:
    std::vector<std::string> _words;
};

bool isPlant(const ObjectWords& words);

/// What a stretch, an object that goes on along the road without a break, looks like.
enum class StretchForm
{
    guardRail,
    jersey, ///< a concrete barrier with a wide foot
    fence,
    kerb,
    wall, ///< any other body, as wide and high as told
};

/// Returns the form of a stretch by its words, else by its sizes: what is at most 0.3 m wide and 1.2 m high
/// is a guard rail.
StretchForm stretchForm(const ObjectWords& words, double widthM, double heightM);

/// Returns the model of an object by its words, or nothing when it has none of its own.
/// Source: ASAM OpenDRIVE 1.8, 13.1: types and subtypes of objects.
std::optional<models::RoadModel> objectModel(const ObjectWords& words,
                                             const osgRoads::core::ObjectInstance& instance);

/// Returns a grey box of an object's size.
models::RoadModel boxOf(const osgRoads::core::ObjectInstance& instance);

/// Whether a grey box is what an object of this type looks like anyway: buildings, barriers, obstacles,
/// traffic islands.
bool isBoxLike(const ObjectWords& words);

} // namespace scenery::roads
