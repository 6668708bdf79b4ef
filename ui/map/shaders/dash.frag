#version 440

layout(location = 0) in vec4 place;
layout(location = 0) out vec4 fragColor;

layout(std140, binding = 0) uniform buf {
    mat4 matrix;
    vec4 color;
    vec4 shape;
    vec4 dash;
};

void main() {
    float along = clamp(place.x, 0.0, place.z);
    float away = length(vec2(place.x - along, place.y));
    float cover = clamp((shape.y - away) * shape.z + 0.5, 0.0, 1.0);
    float phase = mod(place.w + place.x, dash.y);
    float edge = min(phase, dash.x - phase);
    fragColor = color * (cover * clamp(edge * shape.z + 0.5, 0.0, 1.0));
}
