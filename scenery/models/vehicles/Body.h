// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/vehicles/VehicleForm.h"

namespace scenery::models
{

/// A vehicle's form as a seed stretches it, wheels staying round. Frame: the model's, x = 0 in the middle of the vehicle.
struct StretchedForm
{
    const VehicleForm& form;
    glm::dvec3 stretch{1.0};

    double wheelRadiusM() const { return form.wheelRadiusM * stretch.z; }
    double archRadiusM() const { return form.archRadiusM * stretch.z; }
};

/// The closed body: cross sections joined along x, denser where curves turn, with wells for the wheels, whose walls and roof
/// are part of every cross section, so that no cut is needed. Each face shows the view of the vehicle's picture it faces most.
/// Some 2 000 to 4 000 triangles. Begin its part before.
void addBody(ModelBuilder& builder, const StretchedForm& body);

} // namespace scenery::models
