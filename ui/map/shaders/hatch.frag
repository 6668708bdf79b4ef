#version 440

layout(location = 0) in vec2 pixel;
layout(location = 0) out vec4 fragColor;

layout(std140, binding = 0) uniform buf {
    mat4 matrix;
    vec4 color;
    vec4 hatch;
};

void main() {
    float phase = mod((pixel.x + pixel.y) * 0.70710678, hatch.y);
    float away = min(phase, hatch.y - phase);
    // The ground of a hatched area is filled lightly.
    float cover = 0.22 + 0.78 * clamp((hatch.z * 0.5 - away) * hatch.w + 0.5, 0.0, 1.0);
    fragColor = color * cover;
}
