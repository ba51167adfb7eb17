// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/mesh/ModelBuilder.h"
#include "scenery/models/vehicles/VehicleForm.h"

namespace scenery::models
{

/// The form of a vehicle stretched by a seed; wheels stay round. Frame: the model's, x = 0 in the middle of
/// the vehicle.
struct StretchedForm
{
    const VehicleForm& form;
    glm::dvec3 stretch{1.0};

    double wheelRadiusM() const { return form.wheelRadiusM * stretch.z; }
    double archRadiusM() const { return form.archRadiusM * stretch.z; }
};

/// Adds the closed body: cross sections joined along x, denser where curves bend. The wheel wells are part of
/// every cross section, so no cutting is needed. Each face shows the view of the texture that it faces most.
/// About 2 000 to 4 000 triangles. Precondition: its part has begun.
void addBody(ModelBuilder& builder, const StretchedForm& body);

} // namespace scenery::models
