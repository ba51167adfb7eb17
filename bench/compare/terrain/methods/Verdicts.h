// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "compare/terrain/methods/MethodFigures.h"

namespace terraintool
{

/// What the figures say of one requirement and one method: "met", "not met" or "not measured".
struct RequirementVerdict
{
    std::string requirement, method, verdict, figure;
};

/// What the figures say of a claim of the paper: "confirmed", "mixed", "refuted" or "not measured".
struct ClaimVerdict
{
    std::string claim, verdict, figure;
};

/// What the figures say of an advantage or a drawback that the paper lists for a method.
struct QualityVerdict
{
    std::string section, method, kind, quality, verdict, figure; ///< kind: "advantage" or "drawback"
};

/// Judges every method by the requirements R1 to R8, from its figures alone.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), sections 2 and 5.3. The
/// limits are this project's.
std::vector<RequirementVerdict> requirementVerdicts(const DemComparison& dem);

/// Judges what the paper claims of the methods; a claim is confirmed when it holds on every terrain.
/// Source: the same, sections 5.2 and 6.
std::vector<ClaimVerdict> claimVerdicts(const std::vector<DemComparison>& dems);

/// Judges the advantages and drawbacks that the paper lists; one is confirmed when it holds on every terrain.
/// Source: the same, sections 3.3, 4.3, 4.5 and 5.3.
std::vector<QualityVerdict> qualityVerdicts(const std::vector<DemComparison>& dems);

} // namespace terraintool
