// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/DefaultSize.h"

#include <algorithm>
#include <array>

namespace scenery::models
{

namespace
{

struct Range
{
    double least, most;

    bool contains(double value) const { return value >= least && value <= most; }
};

/// The sizes of a kind. Units: metres. Axles are counted from the front of the box.
struct KindSize
{
    EntityKind kind;
    Range length, width, height;
    double defaultLength, defaultWidth, defaultHeight;
    double rearOverhang, wheelbase; ///< 0 wheelbase: one axle or none
    double wheelRadius;             ///< 0: no wheels that are drawn by axles
    double mostRadiusShare;         ///< of the height
};

constexpr std::array kSizes{
    KindSize{EntityKind::car, {2.2, 6.5}, {1.2, 2.4}, {1.0, 2.4}, 4.5, 1.8, 1.46, 0.95, 2.70, 0.32, 0.235},
    KindSize{EntityKind::van, {3.8, 8.5}, {1.6, 2.6}, {1.7, 3.4}, 5.6, 2.02, 2.5, 1.18, 3.40, 0.35, 0.16},
    KindSize{EntityKind::bus, {6.0, 25.0}, {2.0, 2.7}, {2.4, 4.5}, 11.9, 2.5, 3.05, 3.30, 5.90, 0.48, 0.17},
    KindSize{EntityKind::lorry, {4.5, 20.0}, {1.7, 3.2}, {2.0, 4.6}, 9.0, 2.5, 3.7, 2.2, 5.2, 0.50, 0.20},
    KindSize{EntityKind::tractor, {4.0, 9.0}, {2.0, 3.2}, {2.3, 4.6}, 6.0, 2.5, 3.6, 0.9, 3.7, 0.50, 0.20},
    KindSize{
        EntityKind::semitrailer, {6.0, 18.0}, {1.8, 3.2}, {2.0, 4.6}, 13.6, 2.55, 4.0, 3.0, 0.0, 0.50, 0.20},
    KindSize{EntityKind::trailer, {1.5, 14.0}, {1.0, 3.2}, {0.6, 4.6}, 4.5, 1.8, 1.6, 1.4, 0.0, 0.33, 0.30},
    KindSize{EntityKind::motorbike, {1.4, 3.0}, {0.3, 1.3}, {0.8, 2.2}, 2.1, 0.8, 1.6, 0.35, 1.42, 0.0, 0.3},
    KindSize{EntityKind::bicycle, {1.2, 2.6}, {0.2, 1.2}, {0.8, 2.2}, 1.8, 0.6, 1.75, 0.35, 1.06, 0.0, 0.3},
    KindSize{EntityKind::pedestrian, {0.1, 1.5}, {0.1, 1.5}, {0.7, 2.3}, 0.5, 0.6, 1.75, 0.25, 0.0, 0.0, 1.0},
    KindSize{EntityKind::wheelchair, {0.5, 1.8}, {0.3, 1.2}, {0.7, 1.9}, 1.1, 0.65, 1.3, 0.5, 0.0, 0.0, 1.0},
    KindSize{EntityKind::horse, {0.2, 6.0}, {0.05, 2.5}, {0.15, 5.0}, 2.4, 0.55, 1.9, 1.2, 0.0, 0.0, 1.0},
    KindSize{EntityKind::cow, {0.2, 6.0}, {0.05, 2.5}, {0.15, 5.0}, 2.4, 0.70, 1.5, 1.2, 0.0, 0.0, 1.0},
    KindSize{EntityKind::sheep, {0.2, 6.0}, {0.05, 2.5}, {0.15, 5.0}, 1.2, 0.45, 0.85, 0.6, 0.0, 0.0, 1.0},
    KindSize{EntityKind::deer, {0.2, 6.0}, {0.05, 2.5}, {0.15, 5.0}, 1.6, 0.45, 1.3, 0.8, 0.0, 0.0, 1.0},
    KindSize{EntityKind::dog, {0.2, 6.0}, {0.05, 2.5}, {0.15, 5.0}, 1.0, 0.25, 0.65, 0.5, 0.0, 0.0, 1.0},
    KindSize{
        EntityKind::lightAircraft, {4.0, 16.0}, {5.0, 24.0}, {1.2, 6.0}, 8.1, 11.0, 2.75, 5.2, 0.0, 0.0, 1.0},
    KindSize{EntityKind::glider, {4.0, 12.0}, {7.0, 32.0}, {0.8, 3.5}, 6.8, 15.0, 1.5, 4.4, 0.0, 0.0, 1.0},
    KindSize{
        EntityKind::airliner, {12.0, 85.0}, {10.0, 90.0}, {3.5, 26.0}, 37.6, 35.8, 11.8, 20.0, 0.0, 0.0, 1.0},
    KindSize{
        EntityKind::helicopter, {5.0, 25.0}, {1.0, 25.0}, {2.0, 7.0}, 11.0, 2.2, 3.2, 8.3, 0.0, 0.0, 1.0},
    KindSize{
        EntityKind::ship, {3.0, 500.0}, {1.0, 80.0}, {1.0, 90.0}, 120.0, 16.0, 24.0, 60.0, 0.0, 0.0, 1.0},
    KindSize{EntityKind::cone, {0.1, 1.0}, {0.1, 1.0}, {0.2, 1.5}, 0.4, 0.4, 0.75, 0.2, 0.0, 0.0, 1.0},
    KindSize{
        EntityKind::barrier, {0.02, 500.0}, {0.02, 500.0}, {0.1, 30.0}, 2.0, 0.6, 0.8, 1.0, 0.0, 0.0, 1.0},
    KindSize{EntityKind::pole, {0.01, 2.0}, {0.01, 2.0}, {0.3, 60.0}, 0.1, 0.1, 4.0, 0.05, 0.0, 0.0, 1.0},
    KindSize{EntityKind::box, {0.01, 500.0}, {0.01, 500.0}, {0.01, 500.0}, 1.0, 1.0, 1.0, 0.5, 0.0, 0.0, 1.0},
};

const KindSize& sizeOf(EntityKind kind)
{
    return *std::find_if(kSizes.begin(), kSizes.end(),
                         [&](const KindSize& size) { return size.kind == kind; });
}

std::vector<AxleShape> defaultAxles(const EntityShape& shape)
{
    const KindSize& size = sizeOf(shape.kind);
    if (size.wheelRadius <= 0.0) return {};
    const double track = 0.86 * shape.widthM;
    const double rear = shape.backXM() + size.rearOverhang * shape.lengthM / size.defaultLength;
    const AxleShape axle{rear, track, size.wheelRadius, false};
    constexpr double kBetweenM = 1.31; // of a semitrailer's three axles
    if (shape.kind == EntityKind::semitrailer)
        return {{rear + kBetweenM, track, size.wheelRadius, false},
                axle,
                {rear - kBetweenM, track, size.wheelRadius, false}};
    if (size.wheelbase <= 0.0) return {axle};
    return {{rear + size.wheelbase * shape.lengthM / size.defaultLength, track, size.wheelRadius, true},
            axle};
}

} // namespace

bool isPlausible(const EntityShape& shape)
{
    const KindSize& size = sizeOf(shape.kind);
    return size.length.contains(shape.lengthM) && size.width.contains(shape.widthM) &&
           size.height.contains(shape.heightM);
}

void setDefaultSize(EntityShape& shape)
{
    const KindSize& size = sizeOf(shape.kind);
    shape.lengthM = size.defaultLength;
    shape.widthM = size.defaultWidth;
    shape.heightM = size.defaultHeight;
    shape.middleXM = 0.5 * shape.lengthM - size.rearOverhang;
    shape.axles = defaultAxles(shape);
}

void keepWheelsInside(EntityShape& shape)
{
    const KindSize& size = sizeOf(shape.kind);
    std::erase_if(
        shape.axles, [&](const AxleShape& axle)
        { return axle.xM > shape.frontXM() || axle.xM < shape.backXM() || axle.wheelRadiusM < 0.05; });
    const bool lacksAxle = shape.axles.size() < (size.wheelbase > 0.0 ? 2U : 1U);
    if (lacksAxle) shape.axles = defaultAxles(shape);
    if (size.wheelRadius <= 0.0) return;
    for (AxleShape& axle : shape.axles)
    {
        axle.wheelRadiusM = std::min(axle.wheelRadiusM, size.mostRadiusShare * shape.heightM);
        axle.trackM = std::clamp(axle.trackM, 0.5 * shape.widthM, 0.92 * shape.widthM);
    }
    std::sort(shape.axles.begin(), shape.axles.end(),
              [](const AxleShape& a, const AxleShape& b) { return a.xM > b.xM; });
}

} // namespace scenery::models
