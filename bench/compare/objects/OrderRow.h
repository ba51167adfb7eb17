// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "compare/objects/OrderSubject.h"

namespace pmtool
{

/// Returns the names of all orders of triangles.
std::vector<std::string> orderNames();

/// A computed order of a subject's triangles.
struct OrderedSubject
{
    std::vector<std::vector<osgPMObjects::core::Triangle>> calls; ///< by draw call
    double ms = 0.0;                                              ///< processor time for the order alone
    std::size_t strips = 0, sentVertices = 0;                     ///< of orders made of strips
};

/// Computes the order of a name in orderNames() for each draw call of a subject.
OrderedSubject orderSubject(const OrderSubject& subject, const std::string& order);

/// Returns the vertices transformed for each triangle, by cache model. The cache is empty at the beginning of
/// every draw call.
nlohmann::ordered_json transformsPerTriangle(const OrderSubject& subject, const OrderedSubject& ordered);

} // namespace pmtool
