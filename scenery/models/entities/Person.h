// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/EntityModel.h"
#include "scenery/models/entities/LegBend.h"
#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// The lengths of a person. Source: Winter, *Biomechanics and Motor Control of Human Movement*, 2009, figure
/// 4.1, after Drillis and Contini, 1966. Units: metres.
struct PersonSize
{
    explicit PersonSize(double heightM) : height(heightM) {}

    double height;
    double ankle() const { return 0.039 * height; } ///< above the sole
    Leg leg() const { return {0.245 * height, 0.246 * height, true}; }
    double hip() const { return 0.530 * height; }
    double shoulderAboveHip() const { return 0.288 * height; }
    double halfHips() const { return 0.055 * height; }
    double halfShoulders() const { return 0.115 * height; }
    double upperArm() const { return 0.186 * height; }
    double forearm() const { return 0.200 * height; } ///< with the hand
};

struct PersonColours
{
    glm::vec3 jacket{0.2F, 0.3F, 0.5F}, trousers{0.12F, 0.13F, 0.18F}, skin{0.80F, 0.60F, 0.48F},
        hair{0.16F, 0.11F, 0.08F}, shoes{0.08F, 0.07F, 0.07F};
};

/// Adds the trunk, the neck and the head. Frame: origin between the hips. `helmet`: in the place of hair.
void addTrunk(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours, bool helmet);

/// Adds an arm between points, bent at the elbow. All in one frame.
void addArm(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours,
            const glm::dvec3& shoulder, const glm::dvec3& elbow, const glm::dvec3& hand);

/// Adds a leg with its shoe. `foot`: the ankle; the shoe points forward.
void addLeg(ModelBuilder& builder, const PersonSize& size, const PersonColours& colours,
            const glm::dvec3& hip, const glm::dvec3& knee, const glm::dvec3& foot);

/// The bones of a leg, each in its own frame: thigh and shank hang from the origin, the shoe has the ankle
/// there.
Model makeThigh(const PersonSize& size, const PersonColours& colours);
Model makeShank(const PersonSize& size, const PersonColours& colours);
Model makeShoe(const PersonSize& size, const PersonColours& colours);

} // namespace scenery::models
