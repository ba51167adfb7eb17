// SPDX-License-Identifier: Apache-2.0
// The reflectance of each kind of surface (core::SurfaceKind), linear. Asphalt reflects 8 to 12 %, worn concrete about 25 %, dry grass
// and soil 10 to 15 % (Santamouris, Energy and Climate in the Urban Built Environment, 2001, chapter 11). GLSL 1.30.

uniform vec3 roadVerge = vec3(0.105, 0.115, 0.050); // of the ground beside the road

float roadShown()
{
    return 1.0 - smoothstep(0.85 * roadLift.w, roadLift.w, length(roadFromEye));
}

bool roadIsLane() { return roadAt.z > 2.2 && roadAt.z < 6.0; }

float roadTracks()
{
    return roadIsLane() ? roadTracksAt(roadAt.y / max(roadAt.z, 0.1), 7.0) : 0.0;
}

// Gravel is pressed bright by the wheels and thrown up between them.
vec3 roadGravel(float stones, float wide)
{
    float tracks = roadTracks();
    return vec3(0.19, 0.175, 0.15) * (1.0 + (1.1 - 0.6 * tracks) * stones + 0.3 * wide + 0.16 * tracks);
}

vec3 roadSlabs(vec3 colour, vec2 filters)
{
    float joint = roadLineCover(fract(roadAt.x * 1.25 + 0.5) * 0.8 - 0.4, 0.006, filters.x) +
                  roadLineCover(fract(roadAt.y * 1.25 + 0.5) * 0.8 - 0.4, 0.006, filters.y);
    return colour * (1.0 - 0.45 * min(joint, 1.0));
}

vec3 roadSurface(vec2 filters)
{
    vec3 fine = roadStones();
    vec3 wide = texture(roadGrain, roadGround * 0.03125).rgb - 0.5;
    float stones = 0.55 * fine.r + 0.35 * fine.g;
    if (roadKind == 0)
    {
        float worn = roadIsLane() ? roadWearOfAsphalt(wide.g + 0.5 * wide.r, filters) : 1.0;
        return vec3(0.138, 0.137, 0.135) * worn * (1.0 + 0.75 * stones + 0.25 * wide.b + 0.18 * wide.g + 0.14 * roadTracks());
    }
    if (roadKind == 1) return vec3(0.27, 0.26, 0.245) * (1.0 + 0.25 * stones + 0.20 * wide.b);
    if (roadKind == 2) return vec3(0.150, 0.146, 0.139) * (1.0 + 0.75 * stones + 0.35 * wide.b);
    if (roadKind == 3) return vec3(0.30, 0.295, 0.285) * (1.0 + 0.25 * stones);
    if (roadKind == 4) return roadSlabs(vec3(0.235, 0.23, 0.22) * (1.0 + 0.20 * stones + 0.25 * wide.g), filters);
    if (roadKind == 5) return roadGravel(stones, wide.g);
    // Grass: tufts, and soil that shows through.
    float soil = smoothstep(0.05, 0.30, wide.g + 0.6 * fine.g);
    vec3 grass = roadVerge * (1.0 + 0.7 * fine.r + 0.8 * fine.g + 0.5 * wide.b);
    return mix(grass, vec3(0.15, 0.125, 0.09) * (1.0 + 0.6 * stones), 0.6 * soil);
}

// Paints decals and marks on a colour.
vec3 roadPainted(vec3 colour, vec2 filters)
{
    vec2 planX = dFdx(roadPlan), planY = dFdy(roadPlan);
    colour = roadDecalsOf(colour, roadMarkRows.z, planX, planY);
    colour = roadMarksOfRow(colour, roadMarkRows.x, roadAt.y, roadPresence.y, filters);
    return roadMarksOfRow(colour, roadMarkRows.y, roadAt.y - roadAt.z, roadPresence.z, filters);
}

// How far the surface has worn off here, in patches; above 0.7 nothing is left.
float roadGone()
{
    vec2 alongX = dFdx(roadGround) * 0.05, alongY = dFdy(roadGround) * 0.05;
    float gone = roadWear;
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = roadWear > 0.0 ? 0 : 1; i < 1; ++i)
    {
        vec3 patches = textureGrad(roadGrain, roadGround * 0.05, alongX, alongY).rgb - 0.5;
        gone += min(2.0 * roadWear, 1.0) * (0.9 * patches.b + 0.6 * patches.g + 0.3 * patches.r);
    }
    return gone;
}

// Whether there is a surface at all.
bool isRoadThere()
{
    return roadPresence.x >= 0.5 && roadGone() <= 0.7;
}

vec3 roadAlbedo()
{
    vec2 filters = roadFilters();
    float gone = roadGone();
    if (roadPresence.x < 0.5 || gone > 0.7) discard;
    vec3 painted = roadPainted(max(roadSurface(filters), vec3(0.01)), filters);
    float stones = texture(roadGrain, roadGround * 0.5).r - 0.5;
    return mix(painted, vec3(0.15, 0.13, 0.10) * (1.0 + 1.1 * stones), smoothstep(0.15, 0.55, gone));
}
