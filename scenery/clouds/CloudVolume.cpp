// SPDX-License-Identifier: Apache-2.0
// Clouds as noise over a plan, cut by a profile of heights: where the sum is above a threshold is cloud. The
// threshold is the quantile of the columns' highest sums that the cover asks for, so that oktas hold exactly.
// Sources: Schneider & Vos, *The real-time volumetric cloudscapes of
// Horizon: Zero Dawn* (2015): plan times profile, eroded by finer noise (which the shader does); Borgefors,
// *Distance transformations in digital images* (1986): gaps; extinctions by Hess, Koepke and Schult, *Optical
// properties of aerosols and clouds* (1998), table 4, in part.
#include "scenery/clouds/CloudVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/vec2.hpp>

#include "scenery/clouds/TiledNoise3.h"

namespace scenery::clouds
{

namespace
{

constexpr int kSide = CloudVolume::kSide, kSlices = CloudVolume::kSlices;
constexpr std::size_t kPlan = static_cast<std::size_t>(kSide) * kSide;

/// What tells the kinds apart. Noise is from -1 to 1, most of it within 0.5.
struct Form
{
    glm::ivec2 cells; ///< of the plan's coarsest noise in the tile
    int octaves;      ///< of the plan
    float lump;       ///< strength of the noise in space
    int lumpCells;    ///< of it in the tile
    float flatBase;   ///< share of the height by which a cloud is as wide as it gets
    float narrowing;  ///< how much of the plan's sum the top needs more than the base
    float softness;   ///< sum behind the edge at which a cloud is as dense as it gets
    double extinctionPerM;
};

const Form& formOf(simulation::CloudKind kind)
{
    static const std::array<Form, 4> forms{{
        {{9, 9}, 4, 0.30F, 28, 0.12F, 0.42F, 0.06F, 0.040},
        {{11, 8}, 4, 0.16F, 24, 0.45F, 0.20F, 0.10F, 0.030},
        {{5, 5}, 3, 0.08F, 16, 0.50F, 0.10F, 0.20F, 0.020},
        {{3, 16}, 5, 0.10F, 20, 0.50F, 0.25F, 0.40F, 0.0020},
    }};
    return forms[static_cast<std::size_t>(kind)];
}

/// What a height takes off the sum: nothing where the cloud is widest, more towards top and base.
float profile(const Form& form, float height)
{
    if (height < form.flatBase)
    {
        const float below = 1.0F - height / form.flatBase;
        return 0.5F * form.narrowing * below * below;
    }
    const float above = (height - form.flatBase) / (1.0F - form.flatBase);
    return form.narrowing * std::pow(above, 1.5F);
}

/// The sums of all samples.
std::vector<float> sums(const Form& form, double thicknessM, std::uint32_t seed)
{
    std::vector<float> plan(kPlan);
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
            plan[static_cast<std::size_t>(row) * kSide + column] =
                tiledSum3({(column + 0.5F) * form.cells.x / kSide, (row + 0.5F) * form.cells.y / kSide, 0.5F},
                          {form.cells, 0}, form.octaves, seed);
    std::vector<float> all(kPlan * kSlices);
    const float perCell = static_cast<float>(form.lumpCells) / kSide;
    const float heightCells = static_cast<float>(thicknessM / CloudVolume::kTileM) * form.lumpCells;
    for (int slice = 0; slice < kSlices; ++slice)
    {
        const float height = (slice + 0.5F) / kSlices;
        const float taken = profile(form, height);
        float* const at = all.data() + slice * kPlan;
        for (std::size_t i = 0; i < kPlan; ++i)
            at[i] = plan[i] - taken +
                    form.lump * tiledSum3({(i % kSide + 0.5F) * perCell, (i / kSide + 0.5F) * perCell,
                                           height * heightCells},
                                          {form.lumpCells, form.lumpCells, 0}, 2, seed + 17U);
    }
    return all;
}

/// The share of the columns that are seen as cloud, from an optical depth on.
double coverAt(const std::vector<float>& all, float edge, const Form& form, double sliceM)
{
    constexpr float kSeenDepth = 0.1F;
    const auto enough = static_cast<float>(kSeenDepth / (form.extinctionPerM * sliceM));
    std::size_t seen = 0;
    for (std::size_t i = 0; i < kPlan; ++i)
    {
        float depth = 0.0F;
        for (std::size_t sample = i; sample < all.size() && depth < enough; sample += kPlan)
            depth += std::clamp((all[sample] - edge) / form.softness, 0.0F, 1.0F);
        seen += depth >= enough ? 1U : 0U;
    }
    return static_cast<double>(seen) / kPlan;
}

/// The threshold at which as many eighths of the columns are seen as cloud.
float threshold(const std::vector<float>& all, int oktas, const Form& form, double sliceM)
{
    constexpr float kReach = 2.0F; // of sums
    if (oktas <= 0) return kReach;
    float low = -kReach, high = kReach;
    for (int i = 0; i < 14; ++i)
    {
        const float middle = 0.5F * (low + high);
        (coverAt(all, middle, form, sliceM) * 8.0 < oktas ? high : low) = middle;
    }
    constexpr float kThick = 0.3F; // a full cover has no thin places
    return oktas >= 8 ? low - kThick : low;
}

/// Distances to the nearest cloud, over the border of the tile too.
std::vector<std::uint8_t> gaps(const CloudVolume& volume)
{
    std::vector<float> far(volume.form.size());
    for (std::size_t i = 0; i < far.size(); ++i)
        far[i] = volume.form[i] > CloudVolume::kSurface - 12 ? 0.0F : 1e6F;
    const auto flat = static_cast<float>(CloudVolume::kCellM), up = static_cast<float>(volume.sliceM());
    const float across = flat * std::sqrt(2.0F), slanting = std::sqrt(flat * flat + up * up);
    const auto relax = [&](int slice, int row, int column, int to)
    {
        float& here = far[(static_cast<std::size_t>(slice) * kSide + row) * kSide + column];
        const auto from = [&](int dz, int dy, int dx, float way)
        {
            const int z = slice + dz;
            if (z < 0 || z >= kSlices) return;
            const int y = (row + dy) & (kSide - 1), x = (column + dx) & (kSide - 1);
            here = std::min(here, far[(static_cast<std::size_t>(z) * kSide + y) * kSide + x] + way);
        };
        from(0, 0, -to, flat);
        from(0, -to, 0, flat);
        from(0, -to, -to, across);
        from(0, -to, to, across);
        from(-to, 0, 0, up);
        from(-to, 0, to, slanting);
        from(-to, 0, -to, slanting);
        from(-to, to, 0, slanting);
        from(-to, -to, 0, slanting);
    };
    for (int round = 0; round < 2; ++round) // the second carries distances over the border
    {
        for (int slice = 0; slice < kSlices; ++slice)
            for (int row = 0; row < kSide; ++row)
                for (int column = 0; column < kSide; ++column)
                    relax(slice, row, column, 1);
        for (int slice = kSlices - 1; slice >= 0; --slice)
            for (int row = kSide - 1; row >= 0; --row)
                for (int column = kSide - 1; column >= 0; --column)
                    relax(slice, row, column, -1);
    }
    std::vector<std::uint8_t> steps(far.size());
    // A chamfer of these masks is up to a seventh too long.
    std::transform(far.begin(), far.end(), steps.begin(),
                   [](float way)
                   {
                       const auto whole = static_cast<float>(CloudVolume::kGapStepM);
                       return static_cast<std::uint8_t>(std::min(0.84F * way / whole, 255.0F));
                   });
    return steps;
}

/// A value of a plan between its samples, over its border too.
float between(const std::vector<float>& plan, float column, float row)
{
    const float x = std::floor(column), y = std::floor(row);
    const float u = column - x, v = row - y;
    const int x0 = static_cast<int>(x) & (kSide - 1), x1 = (x0 + 1) & (kSide - 1);
    const int y0 = static_cast<int>(y) & (kSide - 1), y1 = (y0 + 1) & (kSide - 1);
    const auto at = [&](int cx, int cy) { return plan[static_cast<std::size_t>(cy) * kSide + cx]; };
    const float low = at(x0, y0) + u * (at(x1, y0) - at(x0, y0));
    const float high = at(x0, y1) + u * (at(x1, y1) - at(x0, y1));
    return low + v * (high - low);
}

/// Goes through a volume from the top down along parallel rays; `each` gets the samples and the optical
/// depths above the middle of each. Returns the depths below the base.
template<class Each>
std::vector<float> sweepDown(const CloudVolume& volume, const glm::vec3& towards, const Each& each)
{
    const float perSlice = static_cast<float>(volume.sliceM()) / towards.z; // metres of ray
    const glm::vec2 shift = glm::vec2(towards) * (perSlice / static_cast<float>(CloudVolume::kCellM));
    const int parts =
        std::max(1, static_cast<int>(std::ceil(std::max(std::abs(shift.x), std::abs(shift.y)))));
    const float part = 1.0F / static_cast<float>(parts);
    const auto depthPerPart = static_cast<float>(volume.extinctionPerM) * perSlice * part;
    std::vector<float> above(kPlan, 0.0F), next(kPlan);
    for (int slice = kSlices - 1; slice >= 0; --slice)
        for (int step = 0; step < parts; ++step)
        {
            for (int row = 0; row < kSide; ++row)
                for (int column = 0; column < kSide; ++column)
                {
                    const std::size_t i = static_cast<std::size_t>(row) * kSide + column;
                    const float depth = between(above, column + shift.x * part, row + shift.y * part);
                    const std::size_t sample = slice * kPlan + i;
                    const float own = depthPerPart * volume.density(sample);
                    if (step == parts / 2) each(sample, depth + 0.5F * own);
                    next[i] = depth + own;
                }
            above.swap(next);
        }
    return above;
}

std::uint8_t byteOf(float share)
{
    return static_cast<std::uint8_t>(255.0F * std::clamp(share, 0.0F, 1.0F) + 0.5F);
}

} // namespace

CloudVolume makeCloudVolume(const simulation::CloudLayer& layer, std::uint32_t seed)
{
    const Form& form = formOf(layer.kind);
    CloudVolume volume;
    volume.baseM = layer.baseM;
    volume.topM = layer.topM;
    volume.extinctionPerM = form.extinctionPerM;
    constexpr float kReach = 0.5F; // of sums on either side of the edge that the bytes tell
    volume.sharpness = kReach / form.softness;
    const std::vector<float> all = sums(form, layer.topM - layer.baseM, seed);
    const float edge = threshold(all, layer.oktas, form, volume.sliceM());
    volume.form.resize(all.size());
    std::transform(all.begin(), all.end(), volume.form.begin(),
                   [=](float sum)
                   {
                       const float within = std::clamp((sum - edge) / kReach, -1.0F, 1.0F);
                       return static_cast<std::uint8_t>(CloudVolume::kSurface + std::lround(127.0F * within));
                   });
    volume.gap = gaps(volume);
    volume.skylit.resize(all.size());
    constexpr float kSkyShare = 0.10F; // of the depth: light of the sky comes from all sides
    sweepDown(volume, {0.0F, 0.0F, 1.0F},
              [&](std::size_t sample, float depth)
              { volume.skylit[sample] = byteOf(std::exp(-kSkyShare * depth)); });
    return volume;
}

SunInClouds sunInClouds(const CloudVolume& volume, const glm::vec3& towardsSun)
{
    constexpr float kLowest = 0.105F; // sine of 6 degrees
    const float height = std::max(towardsSun.z, kLowest);
    const float across = std::max(std::hypot(towardsSun.x, towardsSun.y), 1e-6F);
    const glm::vec3 towards(
        glm::vec2(towardsSun) * (std::sqrt(std::max(1.0F - height * height, 0.0F)) / across), height);
    // Two orders of scattering, the second of which goes on through five times the depth.
    constexpr float kForward = 0.35F, kDeep = 0.07F;
    SunInClouds sun;
    sun.within.resize(volume.form.size());
    const std::vector<float> depths =
        sweepDown(volume, towards,
                  [&](std::size_t sample, float depth) {
                      sun.within[sample] =
                          byteOf(0.72F * std::exp(-kForward * depth) + 0.28F * std::exp(-kDeep * depth));
                  });
    sun.below.resize(kPlan);
    std::transform(depths.begin(), depths.end(), sun.below.begin(),
                   [](float depth) { return 0.06F + 0.94F * std::exp(-0.5F * depth); });
    return sun;
}

std::vector<std::uint8_t> shadeBelow(const std::vector<CloudVolume>& volumes,
                                     const std::vector<SunInClouds>& suns, const glm::vec3& towardsSun)
{
    std::vector<std::uint8_t> shade(kPlan, 255);
    for (std::size_t n = 0; n < volumes.size(); ++n)
    {
        const auto lift = static_cast<float>((volumes[n].baseM - volumes[0].baseM) / CloudVolume::kCellM);
        const glm::vec2 shift = glm::vec2(towardsSun) * (lift / std::max(towardsSun.z, 0.105F));
        for (std::size_t i = 0; i < kPlan; ++i)
            shade[i] =
                byteOf(shade[i] / 255.0F * between(suns[n].below, i % kSide + shift.x, i / kSide + shift.y));
    }
    return shade;
}

double opticalDepth(const CloudVolume& volume, const glm::dvec3& from, const glm::dvec3& direction)
{
    constexpr double kStepM = 10.0;
    double depth = 0.0;
    for (double z = volume.baseM + 0.5 * kStepM; z < volume.topM; z += kStepM)
    {
        const double t = (z - from.z) / direction.z;
        const int column = static_cast<int>(std::floor((from.x + t * direction.x) / CloudVolume::kCellM));
        const int row = static_cast<int>(std::floor((from.y + t * direction.y) / CloudVolume::kCellM));
        const int slice = std::clamp(static_cast<int>((z - volume.baseM) / volume.sliceM()), 0, kSlices - 1);
        const std::size_t sample =
            (static_cast<std::size_t>(slice) * kSide + (row & (kSide - 1))) * kSide + (column & (kSide - 1));
        depth += volume.extinctionPerM * volume.density(sample) * kStepM / direction.z;
    }
    return depth;
}

} // namespace scenery::clouds
