// SPDX-License-Identifier: Apache-2.0
// Moves the snow line with the season: seasonSnow() returns the share of snow, 0 ... 1.

uniform vec4 seasonSnowLine; // snow line, its shift (m), 1 / (2 Earth radii), height minus local z

float seasonSnow(float earlySummers, vec3 place, float steep, Grain g)
{
    vec3 local = place + 4096.0 * vec3(terrainEyeWraps);
    float height = local.z + dot(local.xy, local.xy) * seasonSnowLine.z + seasonSnowLine.w;
    height += 400.0 * g.metres4700.w + 250.0 * g.metres324.w;
    float over = smoothstep(-450.0, 450.0, height - seasonSnowLine.x - seasonSnowLine.y);
    if (seasonSnowLine.y > 0.0) return earlySummers * over;
    return max(earlySummers, over * (1.0 - 0.85 * smoothstep(0.22, 0.5, steep)));
}
