#version 440

// A segment becomes a rectangle around it, half a device pixel larger than the line is wide, so that its width
// is the same at every zoom.
layout(location = 0) in vec2 start;
layout(location = 1) in vec2 delta;
layout(location = 2) in vec3 corner;  // 0 at the start or 1 at the end, side, way from the line's beginning

layout(location = 0) out vec4 place;  // along, across, length, way before: pixels

layout(std140, binding = 0) uniform buf {
    mat4 matrix;
    vec4 color;
    vec4 shape;  // pixels per unit, half width, device pixels per pixel, -
    vec4 dash;   // drawn, period: pixels; period 0 for a full line
};

void main() {
    float scale = shape.x;
    float reach = shape.y + 0.55 / shape.z;
    float lengthPx = length(delta) * scale;
    vec2 along = lengthPx > 1e-5 ? normalize(delta) : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float towards = corner.x * 2.0 - 1.0;
    vec2 offset = along * (towards * reach) + across * (corner.y * reach);
    gl_Position = matrix * vec4(start + delta * corner.x + offset / scale, 0.0, 1.0);
    place = vec4(corner.x * lengthPx + towards * reach, corner.y * reach, lengthPx, corner.z * scale);
}
